function tests = test_readme()
    % TEST_README  The use as a library that README.md shows runs as printed.
    tests = {@library};
end

function library()
    port = fileparts(fileparts(mfilename('fullpath')));
    text = read_file(fullfile(port, 'README.md'));
    program = block(text, ['```matlab', newline]);
    printed = block(text, ['prints', newline, newline, '```', newline]);
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    % in a folder of its own, in place of the top of the repository
    program = strrep(program, '''scenarios/', ...
        ['''', fileparts(port), '/scenarios/']);
    program = strrep(program, 'addpath(''matlab'')', '');
    before = cd(folder);
    returns = onCleanup(@() cd(before));
    same(evalc(program), printed);
    assert(occgrid.files.size_of('noisy.png') > 2000);
    assert(occgrid.files.size_of('maps/noisy.pgm') > 2000);
    clear returns;
end

function text = block(text, head)
    % what stands between head and the next ```
    at = strfind(text, head);
    assert(isscalar(at), 'README.md has no block, or several: %s', head);
    text = text(at + numel(head):end);
    ends = strfind(text, '```');
    text = text(1:ends(1) - 1);
end
