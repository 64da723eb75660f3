classdef scenario
    % SCENARIO  Reading a scenario: a CARMEN log with PARAM, WALL, POSE lines.
    %
    %   grid = occgrid.scenario.new_grid(settings)
    %   s = occgrid.scenario.new_scenario(name, settings, walls, scans)
    %   s = occgrid.scenario.read_scenario(path)
    %   name = occgrid.scenario.scenario_name(path)
    %
    %   SPEC.md sections 5 and 8. settings is a struct with the names of
    %   SPEC.md section 5.2: width, height, resolution and so on; metres,
    %   radians, probabilities, log-odds.

    methods (Static)

        function grid = new_grid(settings)
            % NEW_GRID  An empty grid.
            spec = occgrid.grid.grid_spec( ...
                settings.width, settings.height, settings.resolution, ...
                settings.origin_x, settings.origin_y);
            grid = occgrid.grid.occupancy_grid( ...
                spec, settings.p0, settings.p_occ, settings.p_free, ...
                settings.l_min, settings.l_max);
        end

        function s = new_scenario(name, settings, walls, scans)
            % NEW_SCENARIO  What there is to map; a value, to be mapped at will.
            %
            %   walls: (w, 1) struct array (see occgrid.world.segment); scans:
            %   (1, m) struct array (see occgrid.sensor.scan). The angles and
            %   ranges of a bare pose, which is to be simulated, are [].
            s.name = name;
            s.settings = settings;
            s.walls = walls;
            s.scans = scans;
        end

        function s = read_scenario(path)
            % READ_SCENARIO  Read a scenario file.
            %
            %   Raises occgrid:scenario, with the message FILE:LINE: REASON,
            %   for the first line that breaks a rule.
            path = char(path);
            id = occgrid.files.open(path, 'r');
            if id < 0
                occgrid.scenario.fail(path, 0, 'cannot be read');
            end
            closes = onCleanup(@() fclose(id));
            s = occgrid.scenario.read_lines(path, id);
        end

        function name = scenario_name(path)
            % SCENARIO_NAME  A file's name without folder and ending.
            path = char(path);
            slash = path == '/' | (ispc & path == '\');
            path = path(1:max([find(~slash, 1, 'last'), 0]));
            slash = [0, find(slash(1:numel(path)))];
            name = path(slash(end) + 1:end);
            dot = find(name == '.', 1, 'last');
            if ~isempty(dot) && dot > 1
                name = name(1:dot - 1);
            end
        end

    end

    methods (Static, Access = private)

        function s = read_lines(file, id)
            % all lines of an open file
            given = struct(); % what PARAM lines gave
            lines = struct(); % the line that gave it
            settings = [];
            walls = {};
            angles = {};
            keys = zeros(0, 4); % what distinguishes the elements of angles
            scans = cell(3, 1024); % pose, angles, ranges of each
            n = 0; % scans so far
            before = 0; % lines in earlier chunks
            rest = '';
            ended = false;
            while ~ended
                [text, rest, ended] = occgrid.log_lines.next_lines(id, rest);
                if ended && ~occgrid.files.read_to_end(file, id)
                    occgrid.scenario.fail(file, before, 'cannot be read');
                end
                c = occgrid.log_lines.fields(text);
                for i = c.candidates
                    line = before + i;
                    if c.not_plain(i)
                        occgrid.scenario.fail( ...
                            file, line, 'not plain ASCII text');
                    end
                    f = c.first(i);
                    g = c.last(i);
                    keyword = text(c.starts(f):c.ends(f));
                    if c.not_word(f)
                        occgrid.scenario.fail(file, line, ...
                            sprintf('''%s'' is not a keyword', keyword));
                    end
                    if any(strcmp(keyword, {'POSE', 'FLASER', 'ROBOTLASER1'}))
                        if n == 0
                            settings = occgrid.scenario.check_settings( ...
                                file, line, given, lines);
                        end
                        n = n + 1;
                        if n > size(scans, 2)
                            scans{1, 2 * n} = [];
                        end
                    end
                    switch keyword
                        case {'PARAM', 'WALL'}
                            values = occgrid.log_lines.values(text, c, f, g);
                            ours = keyword(1) == 'W' || ~isempty(values) && ...
                                strncmp(values{1}, 'occgrid_', 8);
                            if ours && n > 0
                                occgrid.scenario.fail(file, line, ...
                                    [keyword, ' must stand before ' ...
                                     'the first scan']);
                            end
                            if keyword(1) == 'W'
                                walls{end + 1} = occgrid.scenario.wall( ...
                                    file, line, values); %#ok<AGROW>
                            elseif ours
                                [name, value] = occgrid.scenario.parameter( ...
                                    file, line, values, given);
                                given.(name) = value;
                                lines.(name) = line;
                            end
                        case 'POSE'
                            values = occgrid.log_lines.values(text, c, f, g);
                            scans{1, n} = occgrid.scenario.pose( ...
                                file, line, values);
                        case {'FLASER', 'ROBOTLASER1'}
                            [ranges, pose, key] = occgrid.scenario.scan( ...
                                file, line, text, c, f, g);
                            ranges(ranges < settings.min_range) = NaN;
                            same = find(all(keys == key, 2), 1);
                            if isempty(same)
                                keys = [keys; key]; %#ok<AGROW>
                                same = size(keys, 1);
                                if keyword(1) == 'F'
                                    a = occgrid.sensor.flaser_angles(key(2));
                                else
                                    a = key(3) + (0:key(2) - 1)' .* key(4);
                                end
                                angles{same} = a; %#ok<AGROW>
                            end
                            scans(:, n) = {pose; angles{same}; ranges};
                        otherwise
                            % it belongs to another program
                    end
                end
                before = before + numel(c.last);
            end
            if n == 0
                occgrid.scenario.fail(file, before, 'no scan');
            end
            scans = struct('pose', scans(1, 1:n), ...
                           'angles', scans(2, 1:n), 'ranges', scans(3, 1:n));
            walls = [struct('x0', {}, 'y0', {}, 'x1', {}, 'y1', {})
                     vertcat(walls{:})];
            s = occgrid.scenario.new_scenario( ...
                occgrid.scenario.scenario_name(file), settings, walls, scans);
        end

        % --- PARAM, WALL, POSE ---

        function table = parameters()
            % rows of name, kind, limits as they are printed, default
            far = {'-10000000', '10000000'};
            table = { ...
                'width', 'whole', '1', '25000000', []
                'height', 'whole', '1', '25000000', []
                'resolution', 'real', '0.001', '1000', []
                'origin_x', 'real', far{:}, []
                'origin_y', 'real', far{:}, []
                'max_range', 'real', '0.001', '10000', []
                'min_range', 'real', '0', '10000', 0
                'p0', 'probability', '', '', 0.5
                'p_occ', 'probability', '', '', 0.75
                'p_free', 'probability', '', '', 0.30
                'l_min', 'real', '-1000', '1000', -8
                'l_max', 'real', '-1000', '1000', 8
                'no_return', 'no_return', '', '', 'free'
                'fov', 'real', '0', '6.283185307179586', pi
                'beams', 'whole', '1', '100000', 181
                'noise_std', 'real', '0', '1000', 0.02};
        end

        function [name, value] = parameter(file, line, values, given)
            % one PARAM line of ours
            fail = @(reason) occgrid.scenario.fail(file, line, reason);
            occgrid.scenario.expect(file, line, 'PARAM', 2, values);
            [field, token] = values{:};
            name = field(9:end);
            table = occgrid.scenario.parameters();
            row = table(strcmp(name, table(:, 1)), :);
            if isempty(row)
                fail(['unknown parameter ', field]);
            elseif isfield(given, name)
                fail([field, ' is given twice']);
            end
            switch row{2}
                case 'whole'
                    value = occgrid.scenario.whole( ...
                        file, line, field, token, row{3}, row{4});
                case 'real'
                    value = occgrid.scenario.real( ...
                        file, line, field, token, row{3}, row{4});
                case 'probability'
                    value = occgrid.scenario.number(file, line, field, token);
                    if ~(0 < value && value < 1)
                        fail(sprintf('%s ''%s'' is not between 0 and 1', ...
                                     field, token));
                    end
                otherwise
                    value = token;
                    if ~any(strcmp(token, {'free', 'ignore'}))
                        fail(sprintf('%s ''%s'' is not free or ignore', ...
                                     field, token));
                    end
            end
        end

        function settings = check_settings(file, line, given, lines)
            % the parameters as a whole, when the first scan comes
            table = occgrid.scenario.parameters();
            settings = struct();
            for i = 1:size(table, 1)
                name = table{i, 1};
                if isfield(given, name)
                    settings.(name) = given.(name);
                else
                    settings.(name) = table{i, 5};
                    lines.(name) = 0;
                end
                if isempty(settings.(name))
                    occgrid.scenario.fail( ...
                        file, line, ['occgrid_', name, ' is missing']);
                end
            end
            if settings.width * settings.height > 25000000
                occgrid.scenario.fail( ...
                    file, max(lines.width, lines.height), ...
                    'the grid has more than 25000000 cells');
            end
            if settings.max_range / settings.resolution > 1000000
                occgrid.scenario.fail( ...
                    file, max(lines.max_range, lines.resolution), ...
                    'occgrid_max_range is more than 1000000 cells');
            end
            latest = max(lines.l_min, lines.l_max);
            if ~(settings.l_min < settings.l_max)
                occgrid.scenario.fail( ...
                    file, latest, 'occgrid_l_min is not below occgrid_l_max');
            end
            l0 = occgrid.grid.logit(settings.p0);
            if ~(settings.l_min <= l0 && l0 <= settings.l_max)
                occgrid.scenario.fail( ...
                    file, max(lines.p0, latest), ...
                    ['logit(occgrid_p0) is not from occgrid_l_min ' ...
                     'to occgrid_l_max']);
            end
            if ~(settings.min_range < settings.max_range)
                occgrid.scenario.fail( ...
                    file, max(lines.min_range, lines.max_range), ...
                    'occgrid_min_range is not below occgrid_max_range');
            end
        end

        function w = wall(file, line, values)
            % the wall of a WALL line
            occgrid.scenario.expect(file, line, 'WALL', 4, values);
            v = zeros(1, 4);
            fields = {'x0', 'y0', 'x1', 'y1'};
            for i = 1:4
                v(i) = occgrid.scenario.coordinate( ...
                    file, line, fields{i}, values{i});
            end
            w = occgrid.world.segment(v(1), v(2), v(3), v(4));
        end

        function p = pose(file, line, values)
            % the pose of a POSE line
            occgrid.scenario.expect(file, line, 'POSE', 3, values);
            p = occgrid.scenario.pose_of(file, line, values);
        end

        function p = pose_of(file, line, tokens)
            % the pose in three fields
            x = occgrid.scenario.coordinate(file, line, 'x', tokens{1});
            y = occgrid.scenario.coordinate(file, line, 'y', tokens{2});
            theta = occgrid.scenario.angle(file, line, 'theta', tokens{3});
            p = occgrid.world.pose(x, y, theta);
        end

        % --- recorded scans ---

        function [ranges, pose, key] = scan(file, line, text, c, f, g)
            % a FLASER or ROBOTLASER1 line, its fields f to g. key tells its
            % bearings: kind, count, start, step.
            fail = @(reason) occgrid.scenario.fail(file, line, reason);
            field = @(i) text(c.starts(f + i):c.ends(f + i));
            found = g - f;
            if text(c.starts(f)) == 'F'
                if found < 1
                    fail('FLASER has no beam count');
                end
                n = occgrid.scenario.whole( ...
                    file, line, 'beam count', field(1), '1', '100000');
                if found ~= n + 10
                    fail(sprintf(['FLASER with %d beams takes %d values, ' ...
                                  'found %d'], n, n + 10, found));
                end
                key = [1, n, 0, 0];
                at_ranges = f + 2;
                at_pose = f + n + 2;
            else
                if found < 8
                    fail('ROBOTLASER1 has no beam count');
                end
                n = occgrid.scenario.whole( ...
                    file, line, 'beam count', field(8), '1', '100000');
                if found < n + 23
                    fail(sprintf(['ROBOTLASER1 with %d beams takes ' ...
                                  'at least %d values, found %d'], ...
                                 n, n + 23, found));
                end
                m = occgrid.scenario.whole( ...
                    file, line, 'remission count', field(n + 9), '0', '100000');
                if found ~= n + m + 23
                    fail(sprintf(['ROBOTLASER1 with %d beams and %d ' ...
                                  'remissions takes %d values, found %d'], ...
                                 n, m, n + m + 23, found));
                end
                start = occgrid.scenario.angle( ...
                    file, line, 'start', field(2));
                step = occgrid.scenario.angle(file, line, 'step', field(4));
                key = [2, n, start, step];
                at_ranges = f + 9;
                at_pose = f + n + m + 10;
            end

            [ranges, bad] = occgrid.log_lines.numbers( ...
                text, c, at_ranges, at_ranges + n - 1);
            i = find(bad | ranges < 0, 1);
            if ~isempty(i)
                token = text(c.starts(at_ranges + i - 1): ...
                             c.ends(at_ranges + i - 1));
                reason = 'is negative';
                if bad(i)
                    reason = 'is not a number';
                end
                fail(sprintf('range %d ''%s'' %s', i - 1, token, reason));
            end
            [v, bad] = occgrid.log_lines.numbers( ...
                text, c, at_pose, at_pose + 2);
            if any(bad | ~(abs(v) <= [10000000; 10000000; 1000000]))
                at = at_pose - f;
                occgrid.scenario.pose_of(file, line, ...
                    {field(at), field(at + 1), field(at + 2)});
            end
            pose = occgrid.world.pose(v(1), v(2), v(3));
        end

        % --- values ---

        function expect(file, line, keyword, count, values)
            % whether there are so many values
            if numel(values) ~= count
                occgrid.scenario.fail( ...
                    file, line, sprintf('%s takes %d values, found %d', ...
                                        keyword, count, numel(values)));
            end
        end

        function value = number(file, line, field, token)
            % a number, NaN and infinity included
            [value, bad] = occgrid.log_lines.one_number(token);
            if bad
                occgrid.scenario.fail( ...
                    file, line, sprintf('%s ''%s'' is not a number', ...
                                        field, token));
            end
            if abs(value) >= 1e300
                value = sign(value) * Inf;
            elseif abs(value) < 1e-300
                value = 0;
            end
        end

        function value = real(file, line, field, token, low, high)
            % a number within limits
            value = occgrid.scenario.number(file, line, field, token);
            if ~(sscanf(low, '%f') <= value && value <= sscanf(high, '%f'))
                occgrid.scenario.fail( ...
                    file, line, sprintf('%s ''%s'' is not from %s to %s', ...
                                        field, token, low, high));
            end
        end

        function value = whole(file, line, field, token, low, high)
            % a whole number within limits
            if any(token < '0' | token > '9')
                occgrid.scenario.fail( ...
                    file, line, sprintf('%s ''%s'' is not a whole number', ...
                                        field, token));
            end
            value = occgrid.scenario.real( ...
                file, line, field, token, low, high);
        end

        function value = coordinate(file, line, field, token)
            % metres
            value = occgrid.scenario.real( ...
                file, line, field, token, '-10000000', '10000000');
        end

        function value = angle(file, line, field, token)
            % radians
            value = occgrid.scenario.real( ...
                file, line, field, token, '-1000000', '1000000');
        end

        function fail(file, line, reason)
            error('occgrid:scenario', '%s:%d: %s', ...
                  occgrid.files.shown(file), line, reason);
        end

    end
end
