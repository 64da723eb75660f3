function tests = test_bad_scenarios()
    % TEST_BAD_SCENARIOS  The errors that all ports share, scenarios/bad.
    tests = {@expected};
end

function expected()
    here = fileparts(mfilename('fullpath'));
    bad = fullfile(fileparts(fileparts(here)), 'scenarios', 'bad');
    lines = strsplit(strtrim(read_file(fullfile(bad, 'expected.txt'))), ...
                     newline);
    assert(numel(lines) > 100);
    wrong = {};
    for line = lines
        name = line{1}(1:find(line{1} == ':', 1) - 1);
        message = 'no error';
        try
            occgrid.scenario.read_scenario([bad, '/', name]);
        catch failure
            message = failure.message;
        end
        if ~strcmp(message, [bad, '/', line{1}])
            wrong{end + 1} = [message, ', expected ', line{1}]; %#ok<AGROW>
        end
    end
    assert(isempty(wrong), '%s', sprintf('%s\n', wrong{:}));
end
