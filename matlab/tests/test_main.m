function tests = test_main()
    % TEST_MAIN  The command line.
    tests = {@version_and_help, @bad_usage, @lesson_on_standard_output, ...
             @several_scenarios, @seeds, @an_error_keeps_what_is_done, ...
             @nothing_written_after_an_error, @picture};
end

function [status, text] = run(varargin)
    % its status and what it prints
    args = varargin; %#ok<NASGU>
    status = [];
    text = evalc('status = occgrid.main(args{:});');
end

function version_and_help()
    [status, text] = run('--version');
    same(status, 0);
    same(strncmp(text, 'occgrid ', 8), true);
    same(sum(text == newline), 1);
    [status, text] = run('--help');
    same(status, 0);
    same(strncmp(text, 'usage: occgrid ', 15), true);
end

function bad_usage()
    table = { ...
        {'--bogus'}, {'-x'}, {'--seed'}, {'--out'}, {'--seed', '--out', 'x'}
        {'--seed', '-1'}, {'--seed', '1.5'}, {'--seed', '4294967296'}, ...
        {'--seed', ''}, {'--seed', '1e3'}
        {'--noise-free', '--seed', '1'}, {'--seed', '1', '--noise-free'}, ...
        {'a.log', 'b.log'}, {'--out', 'x', 'a/m.log', 'b/m.log'}, ...
        {'--out', 'x', '--plot', 'p.png', 'a.log', 'b.log'}};
    for args = reshape(table, 1, [])
        [status, text] = run(args{1}{:});
        same(status, 2);
        assert(~isempty(strfind(text, 'usage: occgrid '))); %#ok<STREMP>
    end
    same(exist('x', 'dir'), 0);
end

function lesson_on_standard_output()
    if exist('OCTAVE_VERSION', 'builtin')
        % a process of its own: there evalc does not see what it prints
        [status, text] = system([ ...
            'octave-cli --no-history --norc --quiet ''', ...
            strrep(cli_script(), '''', '''\'''''), '''']);
    else
        [status, text] = run();
    end
    same(status, 0);
    map = occgrid.mapper.map_scenario(occgrid.lesson.lesson_scenario(), 0);
    same(text, occgrid.map_writer.map_pgm(map));
end

function file = cli_script()
    % the command line's script
    tests_folder = fileparts(mfilename('fullpath'));
    file = fullfile(fileparts(tests_folder), 'occgrid_cli.m');
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
    same(read_file(fullfile(out, 'b.logodds')), ...
        occgrid.map_writer.map_log_odds(map));
    same(exist('nowhere', 'dir'), 0);
end

function seeds()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    a = small_scenario(folder, 'a.log', 'POSE 0 0 0');
    none = drawn(folder, a);
    zero = drawn(folder, '--seed', '0', a);
    one = drawn(folder, '--seed', '7', a, '--seed', '1');
    free = drawn(folder, a, '--noise-free');
    s = occgrid.scenario.read_scenario(a);
    same(none, zero);
    same(one, occgrid.map_writer.map_pgm(occgrid.mapper.map_scenario(s, 1)));
    same(free, occgrid.map_writer.map_pgm(occgrid.mapper.map_scenario(s, [])));
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
    [status, text] = run(a);
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
    file = fullfile(folder, 'a.png');
    [status, text] = run('--out', folder, '--plot', file, a);
    same(status, 0);
    same(text, '');
    bytes = read_file(file);
    same(double(bytes(1:8)), [137, 80, 78, 71, 13, 10, 26, 10]);
    assert(numel(bytes) > 2000);
    same(numel(dir(fullfile(folder, '*.part*'))), 0);
    file = fullfile(folder, 'none', 'a.png');
    [status, text] = run('--out', folder, '--plot', file, a);
    same(status, 1);
    same(text, [file, ': cannot be written', newline]);
end
