function tests = test_scenario()
    % TEST_SCENARIO  Reading scenarios, and the errors of SPEC.md section 8.
    tests = {@names, @defaults, @all_parameters, @comments_and_blank_lines, ...
             @line_ends, @other_keywords, @walls, @poses, @flaser, ...
             @robotlaser1, @numbers, @numbers_in_a_scan, @long_lines, ...
             @far_away, @min_range, @read_twice, ...
             @no_such_file, @wrong_bytes, @wrong_keywords, @wrong_order, ...
             @wrong_counts, @wrong_parameters, @wrong_values, @missing, ...
             @wrong_together, @wrong_scans, @nothing_to_map, @which_first};
end

% --- what the tests are made of ---

function text = head(varargin)
    % the required parameters, one line each, 6 lines; others may follow
    text = sprintf('PARAM occgrid_%s\n', 'width 4', 'height 3', ...
        'resolution 0.5', 'origin_x -1', 'origin_y 0', 'max_range 2', ...
        varargin{:});
end

function s = read(text)
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    file = fullfile(folder, 'a.log');
    write_file(file, text);
    s = occgrid.scenario.read_scenario(file);
end

function wrong(text, line, reason)
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    file = fullfile(folder, 'a.log');
    write_file(file, text);
    raises(@() occgrid.scenario.read_scenario(file), 'occgrid:scenario', ...
        sprintf('%s:%d: %s', file, line, reason));
end

function text = lines(varargin)
    text = sprintf('%s\n', varargin{:});
end

function v = poses_of(s)
    poses = [s.scans.pose];
    v = [[poses.x]', [poses.y]', [poses.theta]'];
end

function v = walls_of(s)
    v = [[s.walls.x0]', [s.walls.y0]', [s.walls.x1]', [s.walls.y1]'];
    v = reshape(v, [], 4);
end

function text = flaser_line(n, ranges, pose)
    text = sprintf('FLASER %s %s %s 0 0 0 12.5 host 12.5\n', n, ranges, pose);
end

function text = robot_line(n, ranges, m, remissions, pose)
    text = sprintf('ROBOTLASER1 0 -1 3 0.25 81.9 0.01 0 %s %s %s %s %s%s\n', ...
        n, ranges, m, remissions, pose, repmat(' x', 1, 11));
end

% --- what is right ---

function names()
    same(occgrid.scenario.scenario_name('a.log'), 'a');
    same(occgrid.scenario.scenario_name('/x.y/b.c.log'), 'b.c');
    same(occgrid.scenario.scenario_name('x/plain'), 'plain');
    same(occgrid.scenario.scenario_name('.hidden'), '.hidden');
    same(occgrid.scenario.scenario_name('d/ a.b.log//'), ' a.b');
    assert(isempty(occgrid.scenario.scenario_name('/')));
end

function defaults()
    s = read([head(), lines('POSE 0 0 0')]);
    t = occgrid.lesson.lesson_settings();
    same(s.name, 'a');
    same([s.settings.width, s.settings.height], [4, 3]);
    for name = {'p0', 'p_occ', 'p_free', 'l_min', 'l_max', 'no_return', ...
                'fov', 'beams', 'noise_std'}
        same(s.settings.(name{1}), t.(name{1}));
    end
    map = occgrid.scenario.new_grid(s.settings);
    same(map.log_odds, zeros(3, 4));
end

function all_parameters()
    s = read([head('p0 0.4', 'p_occ 0.9', 'p_free 1e-3', 'l_min -2.5', ...
                   'l_max 3', 'no_return ignore', 'fov 1', 'beams 5', ...
                   'noise_std 0'), lines('POSE 0 0 0')]);
    t = s.settings;
    same([t.resolution, t.origin_x, t.origin_y, t.max_range], [0.5, -1, 0, 2]);
    same([t.p0, t.p_occ, t.p_free, t.l_min, t.l_max, t.fov, t.beams, ...
          t.noise_std], [0.4, 0.9, 1e-3, -2.5, 3, 1, 5, 0]);
    same(t.no_return, 'ignore');
end

function comments_and_blank_lines()
    tab = char(9);
    odd = char(200);
    s = read(['# ', odd, newline, newline, tab, ' ', newline, ...
              ' #', odd, newline, head(), ...
              'PARAM', tab, 'occgrid_beams  7 ', tab, newline, ...
              lines('PARAM occgrid_fov 2 # 3', 'WALL 1 2 3 4 #', ...
                    '  POSE 1 2 3 #4 5')]);
    same(s.settings.beams, 7);
    same(s.settings.fov, 2);
    same(walls_of(s), [1, 2, 3, 4]);
    same(poses_of(s), [1, 2, 3]);
end

function line_ends()
    text = [head(), lines('POSE 1 2 3', 'POSE 4 5 6')];
    expected = [1, 2, 3; 4, 5, 6];
    s = read(strrep(text, newline, [char(13), newline]));
    same(poses_of(s), expected);
    s = read(text(1:end - 1));
    same(poses_of(s), expected);
    % a CR alone ends no line
    wrong([head(), 'POSE 1 2 3', char(13), lines('POSE 4 5 6')], 7, ...
        'not plain ASCII text');
    s = read([head(), '# 1', char(13), lines('POSE 1 2 3', 'POSE 4 5 6')]);
    same(poses_of(s), [4, 5, 6]);
end

function other_keywords()
    s = read([lines('PARAM robot_width 3', 'PARAM', 'ODOM 1 2 x', '_a', ...
                    'FLASER2', 'POSES'), head(), ...
              lines('POSE 0 0 0', 'PARAM laser_fov 1', 'SYNC')]);
    same(size(poses_of(s)), [1, 3]);
end

function walls()
    s = read([lines('WALL 1 2 3 4'), head(), lines('WALL -5 .5 1e0 +0', ...
                                                   'POSE 0 0 0')]);
    same(walls_of(s), [1, 2, 3, 4; -5, 0.5, 1, 0]);
    s = read([head(), lines('POSE 0 0 0')]);
    same(walls_of(s), zeros(0, 4));
end

function poses()
    n = 3000; % more than are read at once
    text = sprintf('POSE %d %d -0.5\n', [1:n; n:-1:1]);
    s = read([head(), text]);
    same(poses_of(s), [(1:n)', (n:-1:1)', repmat(-0.5, n, 1)]);
    same(isempty([s.scans.angles]) && isempty([s.scans.ranges]), true);
end

function flaser()
    s = read([head(), flaser_line('3', '1 2 3', '4 5 6'), ...
              lines('POSE 7 8 9'), flaser_line('2', '1 .5', '1 2 3'), ...
              flaser_line('003', '3 2 1', '0 0 0')]);
    same(poses_of(s), [4, 5, 6; 7, 8, 9; 1, 2, 3; 0, 0, 0]);
    same({s.scans.ranges}, {[1; 2; 3], [], [1; 0.5], [3; 2; 1]});
    three = [-(pi / 2); 0; pi / 2];
    same({s.scans.angles}, {three, [], [-(pi / 2); pi / 2], three});
end

function robotlaser1()
    s = read([head(), robot_line('3', '1 2 3', '2', '7 8', '4 5 6'), ...
              robot_line('2', '1 2', '0', '', '1 2 3')]);
    same(poses_of(s), [4, 5, 6; 1, 2, 3]);
    same({s.scans.ranges}, {[1; 2; 3], [1; 2]});
    same({s.scans.angles}, {[-1; -0.75; -0.5], [-1; -0.75]});
end

function numbers()
    table = {'1', 1; '+1', 1; '-1', -1; '1.', 1; '.5', 0.5; '-.5', -0.5
             '1e2', 100; '1E+2', 100; '1.5e-1', 0.15; '007', 7
             '-0', 0; '1e-301', 0; '-1e-400', 0; '1e-300', 1e-300
             '0.1000000000000000055511151231257827021181583404541015625', 0.1
             '0.10000000000000000555111512312578270211815834045410156251', 0.1
             '123456.789012345678901234567890', 123456.78901234568
             [repmat('0', 1, 500), '7'], 7
             ['.', repmat('0', 1, 500), '7e501'], 7};
    for i = 1:size(table, 1)
        s = read([head(), lines(['POSE 0 ', table{i, 1}, ' 0'])]);
        same(s.scans.pose.y, table{i, 2});
    end
    for token = {'nan', '-NaN', 'inf', '-Infinity', '+iNf', '1e300', '1e400'}
        wrong([head(), lines(['POSE 0 ', token{1}, ' 0'])], 7, ...
            sprintf('y ''%s'' is not from -10000000 to 10000000', token{1}));
    end
    for token = {'1e', 'e1', '.', '-', '+', '--1', '1-2', '1.2.3', '1.2.', ...
                 '1,5', '0x1', '1d2', '1e5.', 'na', 'NaN(1)', 'infi', '1_0', ...
                 '1+', '1e+', '-.', 'i', '1i', 'pi', '5#'}
        wrong([head(), lines(['POSE 0 ', token{1}, ' 0'])], 7, ...
            sprintf('y ''%s'' is not a number', token{1}));
    end
end

function numbers_in_a_scan()
    s = read([head(), flaser_line('12', ...
        'nan 1 NAN inf +Infinity 1e300 1e-300 9e-301 -0 1.5e1 2. .5', ...
        '-1e0 -0 +.5')]);
    same(s.scans(1).ranges, ...
        [NaN; 1; NaN; Inf; Inf; Inf; 1e-300; 0; 0; 15; 2; 0.5]);
    same(poses_of(s), [-1, 0, 0.5]);
    for token = {'1e', 'e1', '.', '-', '--1', '1-2', '1.2.3', '1.2.', ...
                 '1e5.', '-.', 'x', '+'}
        wrong([head(), flaser_line('3', ['nan ', token{1}, ' y'], '1 2 3')], ...
            7, sprintf('range 1 ''%s'' is not a number', token{1}));
    end
end

function long_lines()
    n = 30000;
    ranges = round(1000 * rand(1, n)) / 1000;
    s = read([head(), '# ', repmat('x', 1, 200000), newline, ...
              flaser_line('30000', sprintf(' %.3f', ranges), '1 2 3'), ...
              lines('POSE 1 2 3')]);
    same(s.scans(1).ranges, ranges');
    same(poses_of(s), [1, 2, 3; 1, 2, 3]);
end

function far_away()
    s = read([head(), lines('WALL 1e7 -1e7 0 0', 'POSE -1e7 1e7 -1e6'), ...
              flaser_line('1', '1', '10000000 -10000000 1000000')]);
    same(poses_of(s), [-1e7, 1e7, -1e6; 1e7, -1e7, 1e6]);
    same(walls_of(s), [1e7, -1e7, 0, 0]);
end

function min_range()
    % recorded ranges below it are ignored
    s = read([head('min_range 0.5'), lines('POSE 0 0 0'), ...
              flaser_line('5', '0.5 0.49999999999999994 0 inf nan', ...
                          '0 0 0')]);
    same(s.settings.min_range, 0.5);
    same(s.scans(2).ranges, [0.5; NaN; NaN; Inf; NaN]);
end

function read_twice()
    % a scenario is a value: mapping it leaves its scans
    s = read([head(), flaser_line('1', '1', '0 0.5 1')]);
    a = occgrid.fast.map_scenario_fast(s, []);
    b = occgrid.fast.map_scenario_fast(s, []);
    assert(nnz(a.log_odds) > 0);
    same(b.log_odds, a.log_odds);
end

% --- what is wrong ---

function no_such_file()
    [folder, removes] = temporary_folder(); %#ok<ASGLU>
    write_file(fullfile(folder, 'a.log'), [head(), lines('POSE 0 0 0')]);
    for file = {fullfile(folder, 'none.log'), folder, '', ...
                fullfile(folder, 'a.log/'), '/proc/self/mem'}
        raises(@() occgrid.scenario.read_scenario(file{1}), ...
            'occgrid:scenario', [file{1}, ':0: cannot be read']);
    end
    raises(@() occgrid.scenario.read_scenario(sprintf('a\nb\x7f')), ...
        'occgrid:scenario', 'a?b?:0: cannot be read');
end

function wrong_bytes()
    for byte = [0, 1, 7, 11, 12, 13, 31, 127, 128, 200, 255]
        wrong([head(), lines(['ODOM ', char(byte), ' 1'])], 7, ...
            'not plain ASCII text');
        wrong([head(), lines(['1', char(byte), '0'])], 7, ...
            'not plain ASCII text');
    end
end

function wrong_keywords()
    for keyword = {'9A', 'A-B', 'POSE,', '1', 'WALL:', '!', 'A#'}
        wrong([head(), lines([keyword{1}, ' 0 0 0'])], 7, ...
            sprintf('''%s'' is not a keyword', keyword{1}));
    end
end

function wrong_order()
    scans = {lines('POSE 0 0 0'), flaser_line('1', '1', '1 2 3'), ...
             robot_line('1', '1', '0', '', '1 2 3')};
    for scan = scans
        wrong([head(), scan{1}, lines('PARAM occgrid_beams x y z')], 8, ...
            'PARAM must stand before the first scan');
        wrong([head(), scan{1}, lines('WALL')], 8, ...
            'WALL must stand before the first scan');
    end
end

function wrong_counts()
    wrong(lines('PARAM occgrid_p0'), 1, 'PARAM takes 2 values, found 1');
    wrong(lines('PARAM occgrid_x 1 2'), 1, 'PARAM takes 2 values, found 3');
    wrong(lines('PARAM occgrid_p0 #1'), 1, 'PARAM takes 2 values, found 1');
    wrong(lines('', 'WALL 1 2 x'), 2, 'WALL takes 4 values, found 3');
    wrong(lines('WALL 1 2 3 4 5'), 1, 'WALL takes 4 values, found 5');
    wrong(lines('WALL # 1 2 3 4'), 1, 'WALL takes 4 values, found 0');
    wrong([head(), lines('POSE')], 7, 'POSE takes 3 values, found 0');
    wrong([head(), lines('POSE 1 2 3 4')], 7, 'POSE takes 3 values, found 4');
end

function wrong_parameters()
    wrong(lines('PARAM occgrid_ 1'), 1, 'unknown parameter occgrid_');
    wrong(lines('PARAM occgrid_Width 1'), 1, ...
        'unknown parameter occgrid_Width');
    wrong(lines('PARAM occgrid_p0 .3', 'PARAM occgrid_p0 x'), 2, ...
        'occgrid_p0 is given twice');
end

function wrong_values()
    whole_ = {'width', '1', '25000000', {'0', '25000001', '99999999999999'}
              'height', '1', '25000000', {'0', '25000001'}
              'beams', '1', '100000', {'0', '100001'}};
    for i = 1:size(whole_, 1)
        for token = {'1.0', '+1', '-1', '1e1', 'x', 'nan', '.'}
            wrong(lines(['PARAM occgrid_', whole_{i, 1}, ' ', token{1}]), 1, ...
                sprintf('occgrid_%s ''%s'' is not a whole number', ...
                        whole_{i, 1}, token{1}));
        end
    end
    far = {'-10000000', '10000000', ...
           {'-10000000.1', '10000001', 'nan', '-inf'}};
    real_ = {'resolution', '0.001', '1000', {'0.0009', '1000.1', 'NaN'}
             'origin_x', far{:}
             'origin_y', far{:}
             'max_range', '0.001', '10000', {'0', '10001', 'inf'}
             'min_range', '0', '10000', {'-1', '10001', 'nan'}
             'l_min', '-1000', '1000', {'-1001', '1001', 'nan'}
             'l_max', '-1000', '1000', {'-1001', '1001', 'nan'}
             'fov', '0', '6.283185307179586', {'-1', '6.2831853071795870'}
             'noise_std', '0', '1000', {'-1', '1001', 'nan'}};
    limits = [whole_; real_];
    for i = 1:size(limits, 1)
        for token = limits{i, 4}
            wrong(lines(['PARAM occgrid_', limits{i, 1}, ' ', token{1}]), 1, ...
                sprintf('occgrid_%s ''%s'' is not from %s to %s', ...
                        limits{i, 1}, token{1}, limits{i, 2}, limits{i, 3}));
        end
    end
    for name = real_(:, 1)'
        wrong(lines(['PARAM occgrid_', name{1}, ' 1x']), 1, ...
            sprintf('occgrid_%s ''1x'' is not a number', name{1}));
    end
    for name = {'p0', 'p_occ', 'p_free'}
        for token = {'0', '1', '-0.5', '1.5', 'nan', 'inf', '1e-301'}
            wrong(lines(['PARAM occgrid_', name{1}, ' ', token{1}]), 1, ...
                sprintf('occgrid_%s ''%s'' is not between 0 and 1', ...
                        name{1}, token{1}));
        end
        wrong(lines(['PARAM occgrid_', name{1}, ' half']), 1, ...
            sprintf('occgrid_%s ''half'' is not a number', name{1}));
    end
    wrong(lines('PARAM occgrid_no_return Free'), 1, ...
        'occgrid_no_return ''Free'' is not free or ignore');
    for i = 1:4
        names_ = {'x0', 'y0', 'x1', 'y1'};
        tokens = {'1', '2', '3', '4'};
        tokens{i} = '10000000.5';
        wrong(lines(strjoin([{'WALL'}, tokens])), 1, sprintf( ...
            '%s ''10000000.5'' is not from -10000000 to 10000000', ...
            names_{i}));
        tokens{i} = 'far';
        wrong(lines(strjoin([{'WALL'}, tokens])), 1, ...
            sprintf('%s ''far'' is not a number', names_{i}));
    end
    for i = 1:3
        names_ = {'x', 'y', 'theta'};
        tokens = {'1', '2', '3'};
        tokens{i} = 'nan';
        far = {'10000000', '10000000', '1000000'};
        reason = sprintf('%s ''nan'' is not from -%s to %s', ...
                         names_{i}, far{i}, far{i});
        wrong([head(), lines(strjoin([{'POSE'}, tokens]))], 7, reason);
        wrong([head(), flaser_line('1', '1', strjoin(tokens))], 7, reason);
        wrong([head(), robot_line('1', '1', '0', '', strjoin(tokens))], 7, ...
            reason);
        tokens{i} = '1..';
        reason = sprintf('%s ''1..'' is not a number', names_{i});
        wrong([head(), lines(strjoin([{'POSE'}, tokens]))], 7, reason);
        wrong([head(), flaser_line('1', '1', strjoin(tokens))], 7, reason);
    end
end

function missing()
    required = {'width', 'height', 'resolution', 'origin_x', 'origin_y', ...
                'max_range'};
    given = strsplit(strtrim(head()), newline);
    for i = 1:6
        rest = given([1:i - 1, i + 1:6]);
        wrong(lines(rest{:}, '', 'POSE'), 7, ...
            ['occgrid_', required{i}, ' is missing']);
        wrong(lines(given{1:i - 1}, 'FLASER'), i, ...
            ['occgrid_', required{i}, ' is missing']);
    end
end

function text = settings_lines(varargin)
    % the required parameters with other values, in the order given
    given = {'width', '4'; 'height', '3'; 'resolution', '0.5'
             'origin_x', '-1'; 'origin_y', '0'; 'max_range', '2'};
    text = '';
    for i = 1:2:numel(varargin)
        given(strcmp(given(:, 1), varargin{i}), :) = [];
    end
    given = given';
    text = [text, sprintf('PARAM occgrid_%s %s\n', given{:}), ...
            sprintf('PARAM occgrid_%s %s\n', varargin{:}), ...
            lines('#', 'POSE x')];
end

function wrong_together()
    reason = 'the grid has more than 25000000 cells';
    wrong(settings_lines('width', '5001', 'height', '5000'), 6, reason);
    wrong(settings_lines('height', '5001', 'width', '5000'), 6, reason);
    wrong(settings_lines('height', '25000000'), 6, reason);
    wrong([settings_lines('height', '6250000')], 8, ...
        'POSE takes 3 values, found 1');
    reason = 'occgrid_max_range is more than 1000000 cells';
    wrong(settings_lines('max_range', '2000', 'resolution', '0.001'), 6, ...
        reason);
    wrong(settings_lines('resolution', '0.001', 'max_range', '1000.001'), ...
        6, reason);
    reason = 'occgrid_l_min is not below occgrid_l_max';
    wrong(settings_lines('l_min', '8'), 7, reason);
    wrong(settings_lines('l_max', '-2', 'l_min', '-2', 'p0', '.1'), 8, reason);
    reason = ['logit(occgrid_p0) is not from occgrid_l_min ' ...
              'to occgrid_l_max'];
    wrong(settings_lines('l_max', '-2'), 7, reason);
    wrong(settings_lines('l_min', '0.1', 'l_max', '2'), 8, reason);
    wrong(settings_lines('p0', '0.9', 'beams', '3', 'l_max', '2'), 9, reason);
    wrong(settings_lines('p0', '0.99999'), 7, reason);
    reason = 'occgrid_min_range is not below occgrid_max_range';
    wrong(settings_lines('min_range', '2'), 7, reason);
    wrong(settings_lines('min_range', '2', 'beams', '3', 'max_range', '1'), ...
        8, reason);
end

function wrong_scans()
    wrong([head(), lines('FLASER')], 7, 'FLASER has no beam count');
    wrong([head(), lines('ROBOTLASER1 0 1 2 3 4 5 6')], 7, ...
        'ROBOTLASER1 has no beam count');
    for n = {'-1', '2.0', 'x', '+3', 'nan'}
        reason = sprintf('beam count ''%s'' is not a whole number', n{1});
        wrong([head(), flaser_line(n{1}, '1', '1 2 3')], 7, reason);
        wrong([head(), robot_line(n{1}, '1', '0', '', '1 2 3')], 7, reason);
    end
    for n = {'0', '100001', '1000000000000000000000'}
        reason = sprintf('beam count ''%s'' is not from 1 to 100000', n{1});
        wrong([head(), flaser_line(n{1}, '1', '1 2 3')], 7, reason);
        wrong([head(), robot_line(n{1}, '1', '0', '', '1 2 3')], 7, reason);
    end
    wrong([head(), flaser_line('2', '1', 'x y z')], 7, ...
        'FLASER with 2 beams takes 12 values, found 11');
    wrong([head(), flaser_line('1', '1 2', 'x y z')], 7, ...
        'FLASER with 1 beams takes 11 values, found 12');
    wrong([head(), lines('FLASER 1 #')], 7, ...
        'FLASER with 1 beams takes 11 values, found 2');
    wrong([head(), robot_line('3', '1', 'x', '', '1 2 3')], 7, ...
        'ROBOTLASER1 with 3 beams takes at least 26 values, found 24');
    wrong([head(), robot_line('1', '1', '1', '', '1 2 3')], 7, ...
        'ROBOTLASER1 with 1 beams and 1 remissions takes 25 values, found 24');
    wrong([head(), robot_line('1', '1', '0', '5', '1 2 3')], 7, ...
        'ROBOTLASER1 with 1 beams and 0 remissions takes 24 values, found 25');
    wrong([head(), robot_line('1', '1', '-1', '', '1 2 3')], 7, ...
        'remission count ''-1'' is not a whole number');
    wrong([head(), robot_line('1', '1', '100001', '', '1 2 3')], 7, ...
        'remission count ''100001'' is not from 0 to 100000');
    wrong([head(), strrep(robot_line('1', '1', '0', '', '1 2 3'), ...
                          ' -1 3 0.25 ', ' inf 3 0.25 ')], 7, ...
        'start ''inf'' is not from -1000000 to 1000000');
    wrong([head(), strrep(robot_line('1', '1', '0', '', '1 2 3'), ...
                          ' -1 3 0.25 ', ' -1 3 half ')], 7, ...
        'step ''half'' is not a number');
    for token = {'-1', '-inf', '-1e-300', '-.5'}
        reason = sprintf('range 2 ''%s'' is negative', token{1});
        ranges = ['1 nan ', token{1}, ' -7'];
        wrong([head(), flaser_line('4', ranges, '1 2 3')], 7, reason);
        wrong([head(), robot_line('4', ranges, '0', '', '1 2 3')], 7, reason);
    end
end

function nothing_to_map()
    wrong('', 0, 'no scan');
    wrong(newline, 1, 'no scan');
    wrong(head(), 6, 'no scan');
    wrong([head(), '#'], 7, 'no scan');
    wrong(lines('PARAM occgrid_width 3', ''), 2, 'no scan');
end

function which_first()
    % what is checked first, where a line breaks several rules
    bad = char(200);
    wrong(lines(['9 ', bad]), 1, 'not plain ASCII text');
    wrong(lines('PARAM occgrid_x'), 1, 'PARAM takes 2 values, found 1');
    wrong([head(), lines('POSE 1 2 3', 'PARAM occgrid_x')], 8, ...
        'PARAM must stand before the first scan');
    wrong(lines('FLASER x'), 1, 'occgrid_width is missing');
    wrong([head(), flaser_line('2', '1 -1', 'x y z')], 7, ...
        'range 1 ''-1'' is negative');
    wrong([head(), flaser_line('2', '-1 x', 'x y z')], 7, ...
        'range 0 ''-1'' is negative');
    wrong([head(), strrep(robot_line('1', '-1', '0', '', 'x y z'), ...
                          ' -1 3 0.25 ', ' a 3 b ')], 7, ...
        'start ''a'' is not a number');
    wrong([head(), lines('POSE 0 0 0', '9', 'POSE x y z')], 8, ...
        '''9'' is not a keyword');
    wrong([head(), lines('POSE 20000000 x z')], 7, ...
        'x ''20000000'' is not from -10000000 to 10000000');
    wrong([head(), flaser_line('1', '1', '1 2 2000000')], 7, ...
        'theta ''2000000'' is not from -1000000 to 1000000');
end
