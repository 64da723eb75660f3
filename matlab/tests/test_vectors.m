function tests = test_vectors()
    % TEST_VECTORS  The results that all ports share, scenarios/vectors/*.csv.
    %
    %   The first line of a file names its columns; the arguments come first,
    %   then the results. The last column may hold blanks.
    tests = {@there_are_vectors, @a_wrong_answer_is_seen};
    [files, folder] = vector_files();
    for i = 1:numel(files)
        tests{end + 1} = @() compare(fullfile(folder, files{i})); %#ok<AGROW>
    end
end

function [files, folder] = vector_files()
    here = fileparts(mfilename('fullpath'));
    folder = fullfile(fileparts(fileparts(here)), 'scenarios', 'vectors');
    listed = dir(fullfile(folder, '*.csv'));
    files = {listed.name};
end

function there_are_vectors()
    assert(numel(vector_files()) >= 15);
end

function compare(file)
    differences = wrong_vectors(file);
    assert(isempty(differences), '%s', sprintf('%s\n', differences{:}));
end

function a_wrong_answer_is_seen()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    file = fullfile(folder, 'bresenham.csv');
    write_file(file, sprintf(['gx0,gy0,gx1,gy1,cells\n' ...
                              '0,0,2,1,0:0 1:0 2:1\n0,0,1,0,0:0 1:1\n']));
    same(numel(wrong_vectors(file)), 1);
end
