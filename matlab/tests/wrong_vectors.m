function differences = wrong_vectors(file)
    % WRONG_VECTORS  Lines of a file of shared vectors that do not hold.
    %
    %   differences: cell array of texts, empty where all lines hold.
    [~, name] = fileparts(file);
    lines = strsplit(strtrim(strrep(read_file(file), char(13), '')), newline);
    assert(numel(lines) > 1, '%s holds no vectors', file);
    columns = strsplit(lines{1}, ',');
    takes = vector_columns(name);
    assert(isequal(columns(1:numel(takes)), takes), ...
        '%s: the columns are not those that are expected', file);
    cells = cell(numel(lines) - 1, numel(columns));
    for i = 2:numel(lines)
        cells(i - 1, :) = strsplit(lines{i}, ',', 'CollapseDelimiters', false);
    end
    answers = probe_answers(name, cells(:, 1:numel(takes)));
    differences = {};
    for i = 1:size(cells, 1)
        expected = strjoin(cells(i, numel(takes) + 1:end), ' ');
        if ~strcmp(answers{i}, expected)
            differences{end + 1} = sprintf( ...
                '%s line %d: %s, expected %s', ...
                file, i + 1, answers{i}, expected); %#ok<AGROW>
        end
    end
end
