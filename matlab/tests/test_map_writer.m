function tests = test_map_writer()
    % TEST_MAP_WRITER  The three files of a map.
    tests = {@pixels, @pgm, @pgm_row_ends, @yaml, @image_names, @decimals, ...
             @thresholds, @log_odds, @many_rows, @three_files, ...
             @files_are_replaced, @folders_are_made, @odd_names, ...
             @long_names, @all_or_nothing, @undone, @slashes, ...
             @leftovers};
end

function map = small_map()
    spec = occgrid.grid.grid_spec(3, 2, 0.1, -11, -9);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
    map.log_odds = [0, 8, -8; 0.1, -0.1, 1.5];
end

function text = text_of(write)
    % what write(put) puts
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    file = fullfile(folder, 'text');
    occgrid.map_writer.write_file(file, file, write);
    text = read_file(file);
end

function text = pgm_of(map)
    text = text_of(@(put) occgrid.map_writer.map_pgm(map, put));
end

function text = log_odds_of(map)
    text = text_of(@(put) occgrid.map_writer.map_log_odds(map, put));
end

function pixels()
    same(occgrid.map_writer.pixel(small_map().log_odds), ...
        [128, 0, 255; 121, 134, 47]);
end

function pgm()
    % the row with the largest y first; LF after the last pixel, too
    same(pgm_of(small_map()), ...
        sprintf('P2\n3 2\n255\n121 134 47\n128 0 255\n'));
end

function pgm_row_ends()
    restores = seeded(1); %#ok<NASGU>
    for shape = [1, 1; 1, 5; 5, 1; 7, 3]'
        map = small_map();
        map.spec.width = shape(1);
        map.spec.height = shape(2);
        map.log_odds = 3 * rand(shape(2), shape(1)) - 1.5;
        expected = sprintf('P2\n%d %d\n255\n', shape);
        for row = flipud(occgrid.map_writer.pixel(map.log_odds))'
            numbers = sprintf('%d ', row);
            expected = [expected, numbers(1:end - 1), newline]; %#ok<AGROW>
        end
        same(pgm_of(map), expected);
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
             5 * 2^-10, '0.004882812'; 7 * 2^-10, '0.006835938'
             % the largest coordinates
             1e7, '10000000.0'; 9999999 + 2^-10, '9999999.000976562'
             -9999999 - 3 * 2^-10, '-9999999.002929688'
             9999999 + 1023 * 2^-10, '9999999.999023438'};
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
    same(log_odds_of(small_map()), ...
        sprintf(['# logodds 3 2\n0 8 -8\n0.10000000000000001 ' ...
                 '-0.10000000000000001 1.5\n']));
end

function many_rows()
    restores = seeded(2); %#ok<NASGU>
    map = small_map();
    map.spec.width = 1500;
    map.spec.height = 1400; % more than are written at once
    map.log_odds = 16 * rand(1400, 1500) - 8;
    map.log_odds(:, 3:end) = round(map.log_odds(:, 3:end));
    text = log_odds_of(map);
    rows = strsplit(text, newline);
    same(numel(rows), 1402);
    for i = [1, 699, 700, 701, 1400]
        same(sscanf(rows{i + 1}, '%f')', map.log_odds(i, :));
        same(sum(rows{i + 1} == ' '), 1499);
    end
    rows = strsplit(pgm_of(map), newline);
    same(numel(rows), 1404);
    for i = [1, 699, 700, 701, 1400]
        same(sscanf(rows{1404 - i}, '%f')', ...
            occgrid.map_writer.pixel(map.log_odds(i, :)));
    end
end

function three_files()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    occgrid.map_writer.write_map(folder, 'a.b', small_map());
    same(listing(folder), {'a.b.logodds', 'a.b.pgm', 'a.b.yaml'});
    same(read_file(fullfile(folder, 'a.b.pgm')), ...
        pgm_of(small_map()));
    same(read_file(fullfile(folder, 'a.b.yaml')), ...
        occgrid.map_writer.map_yaml(small_map(), 'a.b.pgm'));
    same(read_file(fullfile(folder, 'a.b.logodds')), ...
        log_odds_of(small_map()));
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
        pgm_of(small_map()));
end

function folders_are_made()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    deep = fullfile(folder, 'x', 'it''s y');
    occgrid.map_writer.write_map(deep, 'm', small_map());
    same(listing(deep), {'m.logodds', 'm.pgm', 'm.yaml'});
end

function image_names()
    table = {'a.pgm', 'a.pgm'; 'A-_9.b.pgm', 'A-_9.b.pgm'
             'run #2.pgm', '"run #2.pgm"'; '-x.pgm', '"-x.pgm"'
             '.x.pgm', '".x.pgm"'; '1.pgm', '1.pgm'; 'a: b', '"a: b"'
             'a"\b', '"a\"\\b"'; char([97, 9, 10, 127]), '"a\x09\x0A\x7F"'};
    for i = 1:size(table, 1)
        text = occgrid.map_writer.map_yaml(small_map(), table{i, 1});
        expected = sprintf('image: %s\nmode: trinary\n', table{i, 2});
        same(text(1:numel(expected)), expected);
    end
end

function thresholds()
    % a cell at the prior is neither occupied nor free
    for p0 = [1e-12, 0.001, 0.15, 0.196, 0.4, 0.5, 0.65, 0.7, 0.99, 1 - 1e-12]
        spec = occgrid.grid.grid_spec(1, 1, 1, 0, 0);
        map = occgrid.grid.occupancy_grid(spec, p0, 0.75, 0.3, -30, 30);
        text = occgrid.map_writer.map_yaml(map, 'a.pgm');
        [~, ~, ~, ~, found] = regexp(text, '_thresh: ([0-9.]+)');
        limits = [str2double(found{1}), str2double(found{2})];
        p = (255 - occgrid.map_writer.pixel(map.l0)) / 255;
        assert(limits(2) < p || p == 0, 'p0 %g is free', p0);
        assert(p < limits(1) || p == 1, 'p0 %g is occupied', p0);
        assert(limits(2) < limits(1));
    end
end

function odd_names()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    names = {'a\b', '~', '*', '?', '[x]', sprintf('a\nb'), ' ', ' x ', '-x', ...
             'it''s', '"', '$HOME', '`id`', '%d', '#', ';', '~root', '..x'};
    if exist('OCTAVE_VERSION', 'builtin')
        names{end + 1} = char([97, 255, 254]); % not UTF-8
        names{end + 1} = char([195, 188]);
    end
    other = fullfile(folder, 'a');
    write_file(other, 'must stay');
    for i = 1:numel(names)
        in = [folder, '/d/', names{i}];
        occgrid.map_writer.write_map(in, names{i}, small_map());
        for ending = {'.pgm', '.yaml', '.logodds'}
            file = [in, '/', names{i}, ending{1}];
            assert(occgrid.files.size_of(file) > 20, '%s', file);
        end
        same(numel(readdir_of(in)), 3);
        source = [in, '/', names{i}, '.log'];
        write_file(source, sprintf('PARAM occgrid_%s\n', 'width 2', ...
            'height 2', 'resolution 1', 'origin_x 0', 'origin_y 0', ...
            'max_range 1'));
        raises(@() occgrid.scenario.read_scenario(source), ...
            'occgrid:scenario', [occgrid.files.shown(source), ':6: no scan']);
    end
    same(read_file(other), 'must stay');
    same(numel(readdir_of(fullfile(folder, 'd'))), numel(names));
    if exist('OCTAVE_VERSION', 'builtin')
        % Octave would put root's home folder here
        path = [folder, '/x ~root'];
        raises(@() occgrid.map_writer.write_map(path, 'm', small_map()), ...
            'occgrid:output', [path, ': cannot be written']);
        path = [path, '/a.log'];
        raises(@() occgrid.scenario.read_scenario(path), ...
            'occgrid:scenario', [path, ':0: cannot be read']);
    end
end

function names = readdir_of(folder)
    % what is in a folder with any name
    if exist('OCTAVE_VERSION', 'builtin')
        names = readdir(folder);
    else
        listed = dir(folder);
        names = {listed.name};
    end
    names = names(~ismember(names, {'.', '..'}));
end

function long_names()
    % the longest that the system takes, with the longest ending
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    name = repmat('n', 1, 255 - numel('.logodds'));
    occgrid.map_writer.write_map(folder, name, small_map());
    same(numel(listing(folder)), 3);
    path = [folder, '/n', name, '.logodds'];
    raises(@() occgrid.map_writer.write_map(folder, ['n', name], ...
        small_map()), 'occgrid:output', [path, ': cannot be written']);
    same(numel(listing(folder)), 3);
end

function all_or_nothing()
    for ending = {'.pgm', '.yaml', '.logodds'}
        [folder, removes] = temporary_folder(); %#ok<ASGLU>
        mkdir(fullfile(folder, ['m', ending{1}]));
        raises(@() occgrid.map_writer.write_map(folder, 'm', small_map()), ...
            'occgrid:output', ...
            [fullfile(folder, ['m', ending{1}]), ': cannot be written']);
        same(listing(folder), {['m', ending{1}]});
    end
    write_file(fullfile(folder, 'file'), 'x');
    for in = {'file', fullfile('file', 'below')}
        path = fullfile(folder, in{1});
        raises(@() occgrid.map_writer.write_map(path, 'm', small_map()), ...
            'occgrid:output', [path, ': cannot be written']);
    end
end

function undone()
    % a name that is too long with the last ending only: it is noticed when
    % two files have their names
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    name = repmat('n', 1, 250);
    path = [folder, '/', name, '.logodds'];
    raises(@() occgrid.map_writer.write_map(folder, name, small_map()), ...
        'occgrid:output', [path, ': cannot be written']);
    same(numel(listing(folder)), 0);
end

function slashes()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    mkdir(fullfile(folder, 'm.pgm'));
    raises(@() occgrid.map_writer.write_map( ...
        [folder, '/.//'], 'm', small_map()), ...
        'occgrid:output', [folder, '/./m.pgm: cannot be written']);
    mkdir(fullfile(folder, 'x'));
    occgrid.map_writer.write_map([folder, '///x//'], 'm', small_map());
    same(numel(listing(fullfile(folder, 'x'))), 3);
    raises(@() occgrid.map_writer.write_map('/', '../none/m', small_map()), ...
        'occgrid:output', '/../none/m.pgm: cannot be written');
end

function leftovers()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    old = {'.occgrid-1-aB9.part', '.occgrid-.part', '.occgrid-a_b.part', ...
           'occgrid-a.part', '.occgrid-a.par', ...
           ['.occgrid-', repmat('a', 1, 41), '.part']};
    for i = 1:numel(old)
        write_file(fullfile(folder, old{i}), 'x');
        if system(['touch -d ''25 hours ago'' ', ...
                   occgrid.files.in_shell(fullfile(folder, old{i}))]) ~= 0
            error('no touch -d');
        end
    end
    write_file(fullfile(folder, '.occgrid-new.part'), 'x');
    occgrid.map_writer.write_map(folder, 'm', small_map());
    same(listing(folder), ...
        sort([old(2:end), {'.occgrid-new.part', 'm.logodds', 'm.pgm', ...
                           'm.yaml'}]));
end
