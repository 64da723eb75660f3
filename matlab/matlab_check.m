function matlab_check()
    % MATLAB_CHECK  Whether the port's assumptions hold on this engine.
    %
    %   sh matlab.sh check
    %   matlab -batch "addpath('matlab'); matlab_check"
    %
    %   The first thing to run on a MATLAB that has not run the port: each
    %   assumption is a line, pass or FAIL; then the results that all ports
    %   share and the small scenarios. Ends with an error where a line fails.
    %   On Octave it runs as well; what only MATLAB has is a line "not here".
    here = fileparts(mfilename('fullpath'));
    addpath(here);
    addpath(fullfile(here, 'tests'));
    scenarios = fullfile(fileparts(here), 'scenarios');
    fprintf('%s\n', version());
    failed = language(@check_line) + numbers(@check_line) + ...
        pictures(@check_line) + vectors(scenarios) + maps(scenarios);
    fprintf('%d failed\n', failed);
    if failed > 0
        error('occgrid:check', '%d assumptions do not hold', failed);
    end
end

function failed = check_line(name, holds)
    % run one check, print its line; failed: 0 or 1
    failed = 0;
    word = 'pass';
    try
        result = holds();
        if ischar(result)
            word = 'not here';
            name = [name, ': ', result];
        elseif ~all(result(:))
            word = 'FAIL';
        end
    catch failure
        word = 'FAIL';
        name = [name, ': ', failure.message];
    end
    if strcmp(word, 'FAIL')
        failed = 1;
    end
    fprintf('%-8s %s\n', word, name);
end

function failed = language(check)
    failed = 0;
    failed = failed + check('string scalars at the public functions', ...
                            @string_scalars);
    failed = failed + check('a struct is a value', @struct_is_value);
    failed = failed + check('an empty loop does nothing', @empty_loops);
    failed = failed + check('fields of a struct array as a row', ...
        @() isequal([struct('a', {1, 2, 3}).a], [1, 2, 3]));
    failed = failed + check('onCleanup runs when an error passes', ...
                            @cleanup_runs);
    failed = failed + check('a failed write of a file is noticed', ...
                            @failed_write);
    failed = failed + check('rng restores the random generator', ...
                            @restored_generator);
end

function failed = numbers(check)
    bits = @(words) hex2num(words);
    failed = 0;
    failed = failed + check('pi is 400921fb54442d18', ...
        @() pi == bits('400921fb54442d18') && 2.0 * pi == 2 * pi);
    failed = failed + check('typecast of nothing', ...
        @() isempty(typecast(zeros(0, 1), 'uint64')));
    failed = failed + check('typecast of a column is a column', ...
        @() isequal(size(typecast(zeros(3, 1), 'uint64')), [3, 1]));
    failed = failed + check('products of uint64 are exact', @uint64_products);
    failed = failed + check('bitshift of uint64', ...
        @() bitshift(intmax('uint64'), -32) == uint64(4294967295));
    failed = failed + check('subnormal numbers are kept', ...
        @() bits('0010000000000000') / 2 == bits('0008000000000000') && ...
        bits('0000000000000001') > 0);
    failed = failed + check('division rounds once', ...
        @() [15; 1] ./ 137 == ...
            [bits('3fbc077975b8fe22'); bits('3f7de5d6e3f8868a')]);
    failed = failed + check('a product and a sum round twice', @no_fma);
    failed = failed + check('floor and ceil beyond 2^31', ...
        @() floor(-2.5e10 - 0.5) == -25000000001 && ceil(1e15 + 0.5) == ...
        1000000000000001);
    failed = failed + check('sscanf reads to the last bit', @sscanf_exact);
    failed = failed + check('sprintf %.17g writes to the last bit', ...
                            @sprintf_exact);
    failed = failed + check('sprintf %.9f rounds correctly', ...
        @() strcmp(sprintf('%.9f ', [0.1, 1 / 3, 9999999.9999999991, ...
                                     2^-30]), ...
                   '0.100000000 0.333333333 10000000.000000000 0.000000001 '));
    failed = failed + check('min and max leave NaN out', ...
        @() isequal(min(max([-9, 9], -8), 8), [-8, 8]) && ...
        min(NaN, Inf) == Inf);
end

function failed = pictures(check)
    failed = 0;
    failed = failed + check('CLim is a property of the axes', @colour_limits);
    failed = failed + check('a picture without a display', @headless_picture);
end

function yes = string_scalars()
    if exist('OCTAVE_VERSION', 'builtin')
        yes = 'Octave has no string scalars';
        return
    end
    folder = string(tempname());
    removes = onCleanup(@() rmdir(folder, 's'));
    grid = occgrid.lesson.lesson_scenario();
    grid = occgrid.scenario.new_grid(grid.settings);
    occgrid.map_writer.write_map(folder, "a b", grid);
    name = occgrid.scenario.scenario_name(folder + "/a.log");
    yes = strcmp(name, 'a') && isfile(folder + "/a b.pgm");
    try
        occgrid.scenario.read_scenario(folder + "/none.log");
    catch failure
        yes = yes && strcmp(failure.identifier, 'occgrid:scenario');
    end
    yes = yes && occgrid.main("--bogus") == 2;
    scan = occgrid.sensor.scan(occgrid.world.pose(0, 0, 0), 0, 20);
    ignored = occgrid.sensor.update_grid_from_scan(grid, scan, 10, "ignore");
    yes = yes && isequal(ignored.log_odds, grid.log_odds);
    yes = yes && strncmp(occgrid.map_writer.map_yaml(grid, "a.pgm"), ...
                         'image: a.pgm', 12);
end

function yes = struct_is_value()
    a.v = [1, 2];
    b = a;
    b.v(1) = 9;
    yes = isequal(a.v, [1, 2]);
end

function yes = empty_loops()
    yes = true;
    for i = reshape(find(false(3, 1)), 1, []) %#ok<NASGU>
        yes = false;
    end
end

function yes = cleanup_runs()
    file = tempname();
    write_file(file, 'x');
    try
        fail_with(file);
    catch
        yes = exist(file, 'file') == 0;
    end
end

function fail_with(file)
    removes = onCleanup(@() delete(file)); %#ok<NASGU>
    error('occgrid:check', 'on purpose');
end

function yes = failed_write()
    if ~exist('/dev/full', 'file')
        yes = 'no /dev/full';
        return
    end
    yes = false;
    try
        occgrid.map_writer.write_file('/dev/full', 'x', ...
                                      @(put) put(repmat('x', 1, 100000)));
    catch failure
        yes = strcmp(failure.message, 'x: cannot be written');
    end
end

function yes = restored_generator()
    before = rng();
    restores = seeded(5); %#ok<NASGU>
    rand(1, 10);
    clear restores;
    yes = isequal(rng(), before);
end

function yes = uint64_products()
    product = uint64(4294967295) .* uint64(4294967295);
    yes = product == bitor(bitshift(uint64(4294967294), 32), uint64(1));
end

function yes = no_fma()
    % (1 + 2^-30)^2 - (1 + 2^-29) is 2^-60 where the product is not rounded
    x = [1, 1] + 2^-30;
    yes = x .* x - (1 + 2^-29) == 0;
end

function yes = sscanf_exact()
    half = ['0.100000000000000012490009027033011079765856266021' ...
            '728515625']; % half way between two, and a little more
    words = {'3fb999999999999a', '0.1000000000000000055511151231257827021'
             '3fb999999999999a', half
             '3fb999999999999b', [half, '1']
             '7fefffffffffffff', '1.7976931348623157e308'
             '0010000000000000', '2.2250738585072014e-308'
             '40fe240c9fcb68cd', '123456.789012345678901234567890'
             '4340000000000001', '9007199254740993.0000000001'};
    expected = hex2num(words(:, 1));
    yes = sscanf(strjoin(words(:, 2)', ' '), '%f') == expected;
    yes(end + 1) = isequal(sscanf([repmat('0', 1, 500), '7'], '%f'), 7);
end

function yes = sprintf_exact()
    restores = seeded(1); %#ok<NASGU>
    v = [16 * rand(5000, 1) - 8; 2.^(-1000:7:1000)'];
    yes = sscanf(sprintf('%.17g\n', v), '%f') == v;
end

function yes = colour_limits()
    if exist('OCTAVE_VERSION', 'builtin')
        before = warning('off', 'Octave:gnuplot-graphics');
        restores = onCleanup(@() warning(before));
    end
    fig = figure('Visible', 'off');
    closes = onCleanup(@() close(fig));
    imagesc([0, 1; 2, 3]);
    set(gca, 'CLim', [0, 1]);
    yes = isequal(get(gca, 'CLim'), [0, 1]);
end

function yes = headless_picture()
    file = [tempname(), '.png'];
    removes = onCleanup(@() delete(file));
    s = occgrid.lesson.lesson_scenario();
    occgrid.picture.draw_map(occgrid.scenario.new_grid(s.settings), file);
    bytes = read_file(file);
    yes = strcmp(bytes(2:4), 'PNG') && numel(bytes) > 2000;
end

function failed = vectors(scenarios)
    failed = 0;
    listed = dir(fullfile(scenarios, 'vectors', '*.csv'));
    if isempty(listed)
        failed = check_line('scenarios/vectors is there', @() false);
    end
    for i = 1:numel(listed)
        file = fullfile(scenarios, 'vectors', listed(i).name);
        failed = failed + check_line(['vectors: ', listed(i).name], ...
                                     @() isempty(wrong_vectors(file)));
    end
end

function failed = maps(scenarios)
    % the small scenarios on both paths, in both modes
    failed = 0;
    names = {'one-beam', 'octants', 'outside', 'no-return-free', ...
             'no-return-ignore', 'saturate', 'prior', 'flaser', ...
             'robotlaser1', 'formats', 'asymmetric'};
    modes = {'noise-free', []; 'seed-0', 0};
    for i = 1:numel(names)
        s = occgrid.scenario.read_scenario( ...
            fullfile(scenarios, [names{i}, '.log']));
        for j = 1:2
            golden = fullfile(scenarios, 'golden', ...
                              [names{i}, '.', modes{j, 1}]);
            seed = modes{j, 2};
            at = [names{i}, ', ', modes{j, 1}];
            failed = failed + check_line(['map: ', at, ', plain'], ...
                @() is_golden(occgrid.mapper.map_scenario(s, seed), golden));
            failed = failed + check_line(['map: ', at, ', fast'], ...
                @() is_golden(occgrid.fast.map_scenario_fast(s, seed), ...
                              golden));
        end
    end
end

function yes = is_golden(grid, golden)
    % picture and log-odds, the latter by SHA-256 after the last scan
    folder = tempname();
    occgrid.map_writer.write_map(folder, 'm', grid);
    removes = onCleanup(@() occgrid.files.remove( ...
        strcat(folder, {'/m.pgm', '/m.yaml', '/m.logodds'})));
    yes = strcmp(read_file([folder, '/m.pgm']), read_file([golden, '.pgm']));
    clear removes;
    rmdir(folder);
    hashes = strsplit(strtrim(read_file([golden, '.sha256'])), newline);
    bytes = typecast(reshape(grid.log_odds', 1, []), 'uint8');
    words = strsplit(strtrim(hashes{end}), ' ');
    yes = yes && strcmp(sha256(bytes), words{end});
end

function text = sha256(bytes)
    if exist('OCTAVE_VERSION', 'builtin')
        text = hash('sha256', char(bytes));
        return
    end
    digest = java.security.MessageDigest.getInstance('SHA-256');
    digest.update(bytes);
    text = sprintf('%02x', typecast(digest.digest(), 'uint8'));
end
