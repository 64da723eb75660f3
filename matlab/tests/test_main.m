function tests = test_main()
    % TEST_MAIN  The command line.
    tests = {@options_in_order, @bad_usage, @both_paths, ...
             @several_scenarios, @seeds, @an_error_keeps_what_is_done, ...
             @nothing_written_after_an_error, @picture};
end

function [status, text] = run(varargin)
    % its status and what it prints
    args = varargin; %#ok<NASGU>
    status = [];
    text = evalc('status = occgrid.main(args{:});');
end

function options_in_order()
    % what stands before --help counts, what stands after it does not
    for option = {'--help', '--version'}
        [status, text] = run('--bogus', option{1});
        same(status, 2);
        same(strncmp(text, 'occgrid: there is no option --bogus', 35), true);
        [status, text] = run('--seed', '1', '--noise-free', option{1}, ...
            '--bogus');
        same(status, 0);
        same(text, '');
    end
end

function bad_usage()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    x = fullfile(folder, 'x');
    missing = {'--seed'; '--out'; '--plot'};
    for option = missing'
        table = {{option{1}}, {option{1}, ''}, {option{1}, '--noise-free'}, ...
                 {option{1}, '--'}};
        for args = table
            [status, text] = run(args{1}{:});
            same(status, 2);
            expected = ['occgrid: argument ', option{1}, ...
                        ': a value is missing', newline, 'usage: occgrid '];
            same(text(1:numel(expected)), expected);
        end
    end
    table = {{'--bogus'}, {'-x'}, {'-h'}, {'-'}, {'--'}, {'-5'}, ...
             {'--seed=7'}, {['--', newline]}, ...
             {'--seed', '-1'}, {'--seed', '1.5'}, {'--seed', '4294967296'}, ...
             {'--seed', '99999999999999999999'}, {'--seed', '1e3'}, ...
             {'--noise-free', '--seed', '1'}, ...
             {'--seed', '1', '--noise-free'}, {'a.log', 'b.log'}, ...
             {'--out', x, 'a/m.log', 'b/m.log'}, ...
             {'--out', x, '--plot', 'p.png', 'a.log', 'b.log'}};
    for args = table
        [status, text] = run(args{1}{:});
        same(status, 2);
        lines = strsplit(text, newline);
        same(strncmp(lines{1}, 'occgrid: ', 9), true);
        same(strncmp(lines{2}, 'usage: occgrid ', 15), true);
    end
    same(exist(x, 'dir'), 0);
end

function both_paths()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    out = @(name) fullfile(folder, name);
    same(run('--out', out('fast'), a), 0);
    same(run(a, '--plain', '--out', out('plain')), 0);
    for ending = {'.pgm', '.yaml', '.logodds'}
        same(read_file(fullfile(folder, 'plain', ['a', ending{1}])), ...
            read_file(fullfile(folder, 'fast', ['a', ending{1}])));
    end
end

function file = small_scenario(folder, name, last)
    file = fullfile(folder, name);
    write_file(file, sprintf('%s\n', 'PARAM occgrid_width 9', ...
        'PARAM occgrid_height 9', 'PARAM occgrid_resolution .5', ...
        'PARAM occgrid_origin_x -2', 'PARAM occgrid_origin_y -2', ...
        'PARAM occgrid_max_range 3', 'PARAM occgrid_noise_std 0.3', ...
        'WALL 1 -1 1 1', last));
end

function several_scenarios()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    b = small_scenario(folder, 'b.log', 'POSE 0 0 1');
    out = fullfile(folder, 'out');
    [status, text] = run(a, '--out', 'nowhere', b, '--out', out);
    same(status, 0);
    same(text, '');
    same(numel(dir(fullfile(out, '*.*'))) >= 6, true);
    s = occgrid.scenario.read_scenario(b);
    map = occgrid.mapper.map_scenario(s, 0);
    occgrid.map_writer.write_map(folder, 'expected', map);
    same(read_file(fullfile(out, 'b.logodds')), ...
        read_file(fullfile(folder, 'expected.logodds')));
    same(exist('nowhere', 'dir'), 0);
end

function seeds()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    none = drawn(folder, a);
    zero = drawn(folder, '--seed', '00000000000000000000000', a);
    one = drawn(folder, '--seed', '7', a, '--seed', '1');
    free = drawn(folder, a, '--noise-free');
    s = occgrid.scenario.read_scenario(a);
    same(none, zero);
    same(one, drawn(folder, a, '--seed', '0001'));
    assert(~isequal(zero, one) && ~isequal(zero, free));
end

function text = drawn(folder, varargin)
    % the picture of the scenario a.log
    [status, said] = run('--out', folder, varargin{:});
    same(status, 0);
    same(said, '');
    text = read_file(fullfile(folder, 'a.pgm'));
end

function an_error_keeps_what_is_done()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    b = small_scenario(folder, 'b.log', 'POSE 0 0');
    c = small_scenario(folder, 'c.log', 'POSE 0 0 0');
    [status, text] = run('--out', folder, a, b, c);
    same(status, 1);
    same(text, [b, ':9: POSE takes 3 values, found 2', newline]);
    same(exist(fullfile(folder, 'a.pgm'), 'file'), 2);
    same(exist(fullfile(folder, 'b.pgm'), 'file'), 0);
    same(exist(fullfile(folder, 'c.pgm'), 'file'), 0);
end

function nothing_written_after_an_error()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', ['POSE 0 0 0', newline, '9']);
    out = fullfile(folder, 'out');
    [status, text] = run('--out', out, a);
    same(status, 1);
    same(text, [a, ':10: ''9'' is not a keyword', newline]);
    same(exist(out, 'dir'), 0);
    [status, text] = run(a, '--plot', fullfile(folder, 'a.png'));
    same(status, 1);
    same(text, [a, ':10: ''9'' is not a keyword', newline]);
end

function picture()
    if exist('OCTAVE_VERSION', 'builtin')
        [missing, ~] = system('gnuplot --version');
        if missing
            skip('gnuplot is missing: install gnuplot-nox');
        end
    end
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    file = [folder, '/a "''#.png'];
    [status, text] = run('--out', folder, '--plot', file, a);
    same(status, 0);
    same(text, '');
    bytes = read_file(file);
    same(double(bytes(1:8)), [137, 80, 78, 71, 13, 10, 26, 10]);
    assert(numel(bytes) > 2000);
    same(sum(strncmp({dir(folder).name}, '.occgrid-', 9)), 0);
    file = fullfile(folder, 'none', 'a.png');
    [status, text] = run('--out', folder, '--plot', file, a);
    same(status, 1);
    same(text, [file, ': cannot be written', newline]);
end
