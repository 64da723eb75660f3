function tests = test_map_writer()
    % TEST_MAP_WRITER  The three files of a map.
    tests = {@pixels, @pgm, @pgm_row_ends, @yaml, @decimals, @log_odds, ...
             @log_odds_of_many_rows, @files, @files_are_replaced, ...
             @folders_are_made, @nothing_is_left_after_an_error};
end

function map = small_map()
    spec = occgrid.grid.grid_spec(3, 2, 0.1, -11, -9);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
    map.log_odds = [0, 8, -8; 0.1, -0.1, 1.5];
end

function pixels()
    same(occgrid.map_writer.pixels(small_map()), [128, 0, 255; 121, 134, 47]);
end

function pgm()
    % the row with the largest y first; LF after the last pixel, too
    same(occgrid.map_writer.map_pgm(small_map()), ...
        sprintf('P2\n3 2\n255\n121 134 47\n128 0 255\n'));
end

function pgm_row_ends()
    for shape = [1, 1; 1, 5; 5, 1; 7, 3]'
        map = small_map();
        map.spec.width = shape(1);
        map.spec.height = shape(2);
        map.log_odds = 3 * rand(shape(2), shape(1)) - 1.5;
        expected = sprintf('P2\n%d %d\n255\n', shape);
        for row = flipud(occgrid.map_writer.pixels(map))'
            numbers = sprintf('%d ', row);
            expected = [expected, numbers(1:end - 1), newline]; %#ok<AGROW>
        end
        same(occgrid.map_writer.map_pgm(map), expected);
    end
end

function yaml()
    same(occgrid.map_writer.map_yaml(small_map(), 'a.pgm'), ...
        sprintf('%s\n', 'image: a.pgm', 'mode: trinary', ...
                'resolution: 0.1', 'origin: [-11.0, -9.0, 0.0]', ...
                'negate: 0', 'occupied_thresh: 0.65', 'free_thresh: 0.196'));
end

function decimals()
    table = {0, '0.0'; -1e-10, '0.0'; 4.9e-10, '0.0'; 5.1e-10, '0.000000001'
             1000000, '1000000.0'; -0.25, '-0.25'; 100, '100.0'
             0.05, '0.05'; 1 / 3, '0.333333333'; -999999.9999999999, ...
             '-1000000.0'
             % half way between two: to the even one
             2^-10, '0.000976562'; 3 * 2^-10, '0.00292968800'
             -2^-10, '-0.000976562'; 999999 + 2^-10, '999999.000976562'
             5 * 2^-10, '0.004882812'; 7 * 2^-10, '0.006835938'};
    table{12, 2} = '0.002929688';
    for i = 1:size(table, 1)
        map = small_map();
        map.spec.origin_x = table{i, 1};
        text = occgrid.map_writer.map_yaml(map, 'a.pgm');
        at = sprintf('origin: [%s, -9.0, 0.0]', table{i, 2});
        assert(~isempty(strfind(text, at)), '%.17g gives %s', ...
            table{i, 1}, text); %#ok<STREMP>
    end
end

function log_odds()
    same(occgrid.map_writer.map_log_odds(small_map()), ...
        sprintf(['# logodds 3 2\n0 8 -8\n0.10000000000000001 ' ...
                 '-0.10000000000000001 1.5\n']));
end

function log_odds_of_many_rows()
    map = small_map();
    map.spec.width = 1500;
    map.spec.height = 1400; % more than are written at once
    map.log_odds = 16 * rand(1400, 1500) - 8;
    map.log_odds(:, 3:end) = round(map.log_odds(:, 3:end));
    text = occgrid.map_writer.map_log_odds(map);
    rows = strsplit(text, newline);
    same(numel(rows), 1402);
    for i = [1, 699, 700, 701, 1400]
        same(sscanf(rows{i + 1}, '%f')', map.log_odds(i, :));
        same(sum(rows{i + 1} == ' '), 1499);
    end
end

function files()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    occgrid.map_writer.write_map(folder, 'a.b', small_map());
    same(listing(folder), {'a.b.logodds', 'a.b.pgm', 'a.b.yaml'});
    same(read_file(fullfile(folder, 'a.b.pgm')), ...
        occgrid.map_writer.map_pgm(small_map()));
    same(read_file(fullfile(folder, 'a.b.yaml')), ...
        occgrid.map_writer.map_yaml(small_map(), 'a.b.pgm'));
    same(read_file(fullfile(folder, 'a.b.logodds')), ...
        occgrid.map_writer.map_log_odds(small_map()));
end

function names = listing(folder)
    all_ = dir(folder);
    names = sort({all_.name});
    names = names(~strcmp(names, '.') & ~strcmp(names, '..'));
end

function files_are_replaced()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    write_file(fullfile(folder, 'm.pgm'), 'old');
    occgrid.map_writer.write_map(folder, 'm', small_map());
    same(read_file(fullfile(folder, 'm.pgm')), ...
        occgrid.map_writer.map_pgm(small_map()));
end

function folders_are_made()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    deep = fullfile(folder, 'x', 'it''s y');
    occgrid.map_writer.write_map(deep, 'm', small_map());
    same(listing(deep), {'m.logodds', 'm.pgm', 'm.yaml'});
end

function nothing_is_left_after_an_error()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    mkdir(fullfile(folder, 'm.yaml'));
    raises(@() occgrid.map_writer.write_map(folder, 'm', small_map()), ...
        'occgrid:output', ...
        [fullfile(folder, 'm.yaml'), ': cannot be written']);
    same(listing(folder), {'m.yaml'});
    write_file(fullfile(folder, 'file'), 'x');
    for in = {'file', fullfile('file', 'below')}
        path = fullfile(folder, in{1});
        raises(@() occgrid.map_writer.write_map(path, 'm', small_map()), ...
            'occgrid:output', [path, ': cannot be written']);
    end
end
