% Runs every test_*.m of this folder, on MATLAB and on Octave:
%
%   octave-cli --no-history --norc --quiet run_tests.m
%   matlab -batch "run('matlab/tests/run_tests.m')"
%
% A test file is a function that returns its tests, handles of functions
% without arguments that fail with an error, or call skip where they cannot
% run. Ends with an error where a test failed, and on a build machine (CI is
% set) where one was skipped.
tests_folder = fileparts(mfilename('fullpath'));
addpath(tests_folder);
addpath(fileparts(tests_folder));

tests_passed = 0;
tests_failed = 0;
tests_skipped = 0;
tests_files = dir(fullfile(tests_folder, 'test_*.m'));
for tests_file = reshape(tests_files, 1, [])
    [~, tests_name] = fileparts(tests_file.name);
    for tests_one = feval(tests_name)
        try
            tests_one{1}();
            tests_passed = tests_passed + 1;
        catch tests_error
            if strcmp(tests_error.identifier, 'occgrid:skip')
                tests_skipped = tests_skipped + 1;
                fprintf('skipped %s, %s: %s\n', tests_name, ...
                    func2str(tests_one{1}), tests_error.message);
                continue
            end
            tests_failed = tests_failed + 1;
            fprintf('FAILED %s, %s: %s\n', tests_name, ...
                func2str(tests_one{1}), tests_error.message);
            for tests_frame = reshape(tests_error.stack, 1, [])
                fprintf('    %s:%d\n', tests_frame.name, tests_frame.line);
            end
        end
    end
end
fprintf('%d tests\n', tests_passed + tests_failed + tests_skipped);
fprintf('%d passed, %d failed, %d skipped\n', tests_passed, tests_failed, ...
    tests_skipped);
if tests_skipped > 0 && ~isempty(getenv('CI'))
    error('occgrid:tests', '%d tests skipped', tests_skipped);
end
if tests_failed > 0 || tests_passed == 0
    error('occgrid:tests', '%d tests failed', tests_failed);
end
