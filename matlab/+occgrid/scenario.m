classdef scenario
    % SCENARIO  Reading a scenario: a CARMEN log with PARAM, WALL, POSE lines.
    %
    %   s = occgrid.scenario.read_scenario(file)
    %   name = occgrid.scenario.scenario_name(file)
    %   map = occgrid.scenario.new_grid(s.settings)
    %
    %   SPEC.md sections 5 and 8. A scenario is a struct:
    %
    %   name      the file's name without folder and ending
    %   settings  what the PARAM lines set: metres, radians, probabilities,
    %             log-odds; the names are those of SPEC.md section 5.2
    %   walls     (w, 4): x0, y0, x1, y1, metres
    %   poses     (m, 3): x, y, theta of each scan, metres and radians
    %   bearings  (m, 1): 0 for a simulated scan; for a recorded one the
    %             number of its bearings among
    %   angles    cell array of bearings (n, 1), radians
    %   ranges    cell array (m, 1) of ranges (n, 1), metres, NaN and infinity
    %             among them; empty for a simulated scan

    methods (Static)

        function s = read_scenario(file)
            % READ_SCENARIO  Read a scenario file.
            %
            %   Raises occgrid:scenario, with the message FILE:LINE: REASON,
            %   for the first line that breaks a rule.
            id = -1;
            if ~isfolder(file)
                id = fopen(occgrid.scenario.absolute(file), 'r');
            end
            if id < 0
                occgrid.scenario.fail(file, 0, 'cannot be read');
            end
            closes = onCleanup(@() fclose(id));
            s = occgrid.scenario.read_lines(file, id);
            s.name = occgrid.scenario.scenario_name(file);
        end

        function name = scenario_name(file)
            % SCENARIO_NAME  A file's name without folder and ending.
            slash = [0, find(file == '/' | (ispc & file == '\'))];
            name = file(slash(end) + 1:end);
            dot = find(name == '.', 1, 'last');
            if ~isempty(dot) && dot > 1
                name = name(1:dot - 1);
            end
        end

        function path = absolute(file)
            % ABSOLUTE  A file's path from the root.
            %
            %   fopen looks for other names along the search path, too.
            if strncmp(file, '/', 1) || strncmp(file, filesep, 1) || ...
                    (ispc && numel(file) > 1 && file(2) == ':')
                path = file;
            else
                path = fullfile(pwd, file);
            end
        end

        function map = new_grid(settings)
            % NEW_GRID  An empty map.
            spec = occgrid.grid.grid_spec( ...
                settings.width, settings.height, settings.resolution, ...
                settings.origin_x, settings.origin_y);
            map = occgrid.grid.occupancy_grid( ...
                spec, settings.p0, settings.p_occ, settings.p_free, ...
                settings.l_min, settings.l_max);
        end

    end

    methods (Static, Access = private)

        function s = read_lines(file, id)
            % all lines of an open file
            given = struct(); % what PARAM lines said
            lines = struct(); % the line that said so
            s = struct('name', '', 'settings', [], 'walls', zeros(0, 4));
            walls = {};
            angles = {};
            keys = zeros(0, 4); % what tells the elements of angles apart
            poses = zeros(1024, 3);
            bearings = zeros(1024, 1);
            ranges = cell(1024, 1);
            scans = 0;
            before = 0; % lines in earlier chunks
            rest = '';
            listed = dir(occgrid.scenario.absolute(file));
            [~, name, ending] = fileparts(file);
            listed = listed(strcmp({listed.name}, [name, ending])); % no * or ?
            bytes = sum([listed.bytes]); % 0 for a pipe
            while true
                [text, rest] = occgrid.scenario.next_lines( ...
                    file, id, bytes, before, rest);
                if isempty(text)
                    break
                end
                c = occgrid.scenario.fields(text);
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
                        if scans == 0
                            s.settings = occgrid.scenario.check_settings( ...
                                file, line, given, lines);
                        end
                        scans = scans + 1;
                        if scans > numel(bearings)
                            poses(2 * scans, :) = 0;
                            bearings(2 * scans) = 0;
                            ranges{2 * scans} = [];
                        end
                    end
                    switch keyword
                        case {'PARAM', 'WALL'}
                            values = occgrid.scenario.values(text, c, f, g);
                            ours = keyword(1) == 'W' || ~isempty(values) && ...
                                strncmp(values{1}, 'occgrid_', 8);
                            if ours && scans > 0
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
                            values = occgrid.scenario.values(text, c, f, g);
                            poses(scans, :) = occgrid.scenario.pose( ...
                                file, line, values);
                        case {'FLASER', 'ROBOTLASER1'}
                            [r, pose, key] = occgrid.scenario.scan( ...
                                file, line, text, c, f, g);
                            ranges{scans} = r;
                            poses(scans, :) = pose;
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
                            bearings(scans) = same;
                        otherwise
                            % it belongs to another program
                    end
                end
                before = before + numel(c.first);
            end
            if scans == 0
                occgrid.scenario.fail(file, before, 'no scan');
            end
            s.walls = [s.walls; vertcat(walls{:})];
            s.poses = poses(1:scans, :);
            s.bearings = bearings(1:scans);
            s.angles = angles;
            s.ranges = ranges(1:scans);
        end

        % --- lines and fields ---

        function [text, rest] = next_lines(file, id, bytes, before, rest)
            % some whole lines, each with its LF; empty at the end of the
            % file. rest is what was read beyond them, bytes the size of the
            % file, before the number of lines read. (fgetl is not used:
            % Octave's takes a single CR for the end of a line.)
            parts = {rest};
            size_ = 65536;
            while true
                text = fread(id, [1, size_], 'uint8=>char');
                parts{end + 1} = text; %#ok<AGROW>
                last = find(text == newline, 1, 'last');
                if isempty(text)
                    text = [parts{:}];
                    rest = '';
                    if max(ftell(id), 0) < bytes % nothing else tells it
                        occgrid.scenario.fail(file, before, 'cannot be read');
                    end
                    if ~isempty(text)
                        text(end + 1) = newline;
                    end
                    return
                elseif ~isempty(last)
                    rest = text(last + 1:end);
                    parts{end} = text(1:last);
                    text = [parts{:}];
                    return
                end
                size_ = 2 * size_; % a very long line
            end
        end

        function c = fields(text)
            % where the fields of whole lines are, and what is odd in them
            %
            %   first, last   per line: its fields; none where last < first
            %   not_plain     per line: has a byte that is not plain ASCII
            %   candidates    the lines to look at: neither blank nor comment,
            %                 and wrong or with a keyword that may be ours
            %   starts, ends  per field: its place in text
            %   not_word      per field: cannot be a keyword
            %   odd           per field: not a number of the simplest form,
            %                 [-] digits [. digits], which is read quickly
            d = double(text);
            lf = d == 10;
            line_ends = find(lf);
            space = d == 32 | d == 9 | lf;
            space(line_ends(d(max(line_ends - 1, 1)) == 13) - 1) = true;
            edges = diff([true, space, true]);
            c.starts = find(edges == -1);
            c.ends = find(edges == 1) - 1;
            field = cumsum(edges == -1);
            c.last = field(line_ends);
            c.first = [0, c.last(1:end - 1)] + 1;
            n = numel(c.starts);
            line = cumsum([1, lf]);

            c.not_plain = false(size(line_ends));
            c.not_plain(line((d < 32 & ~space) | d > 126)) = true;

            digit = d >= 48 & d <= 57;
            letter = (d >= 65 & d <= 90) | (d >= 97 & d <= 122) | d == 95;
            c.not_word = false(1, n);
            c.not_word(field(~(digit | letter | space))) = true;
            c.not_word(digit(c.starts)) = true;

            minus = d == 45;
            dot = d == 46;
            after = [digit(2:end) | dot(2:end), false];
            wrong = ~(digit | minus | dot | space) | (minus & ~after);
            wrong = wrong | (dot & ~[false, digit(1:end - 1)] & ...
                             ~[digit(2:end), false]);
            wrong = wrong | (minus & ~[true, space(1:end - 1)]);
            c.odd = false(1, n);
            c.odd(field(wrong)) = true;
            dots = field(dot);
            c.odd(dots([false, diff(dots) == 0])) = true;

            c.candidates = [];
            if n == 0
                return
            end
            some = find(c.last >= c.first);
            head = d(c.starts(c.first(some)));
            ours = any(head == ('PWFR')', 1);
            look = ours | c.not_plain(some) | c.not_word(c.first(some));
            c.candidates = some(look & head ~= '#');
        end

        function v = values(text, c, f, g)
            % the fields after the keyword, up to one that begins with #
            v = cell(1, g - f);
            for i = 1:g - f
                v{i} = text(c.starts(f + i):c.ends(f + i));
                if v{i}(1) == '#'
                    v = v(1:i - 1);
                    break
                end
            end
        end

        % --- PARAM, WALL, POSE ---

        function table = parameters()
            % rows of name, kind, limits as they are printed, default
            far = {'-1000000', '1000000'};
            table = { ...
                'width', 'whole', '1', '25000000', []
                'height', 'whole', '1', '25000000', []
                'resolution', 'real', '0.001', '1000', []
                'origin_x', 'real', far{:}, []
                'origin_y', 'real', far{:}, []
                'max_range', 'real', '0.001', '10000', []
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
        end

        function w = wall(file, line, values)
            % the values of a WALL line
            occgrid.scenario.expect(file, line, 'WALL', 4, values);
            w = occgrid.scenario.coordinates( ...
                file, line, {'x0', 'y0', 'x1', 'y1'}, values);
        end

        function p = pose(file, line, values)
            % the values of a POSE line
            occgrid.scenario.expect(file, line, 'POSE', 3, values);
            p = occgrid.scenario.coordinates( ...
                file, line, {'x', 'y', 'theta'}, values);
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
                turn = occgrid.scenario.coordinates( ...
                    file, line, {'start', 'step'}, {field(2), field(4)});
                key = [2, n, turn];
                at_ranges = f + 9;
                at_pose = f + n + m + 10;
            end

            [ranges, bad] = occgrid.scenario.numbers( ...
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
            [pose, bad] = occgrid.scenario.numbers( ...
                text, c, at_pose, at_pose + 2);
            if any(bad | ~(abs(pose) <= 1000000))
                at = at_pose - f;
                pose = occgrid.scenario.coordinates( ...
                    file, line, {'x', 'y', 'theta'}, ...
                    {field(at), field(at + 1), field(at + 2)});
            end
            pose = pose';
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

        function [v, bad] = numbers(text, c, f, g)
            % the fields f to g as numbers (n, 1), and which are none
            %
            %   All fields are read at once. Those that are not of the
            %   simplest form are read one by one, and stand as 0 meanwhile.
            odd = find(c.odd(f:g));
            part = text(c.starts(f):c.ends(g));
            special = zeros(numel(odd), 1);
            bad = false(g - f + 1, 1);
            token = '';
            for i = 1:numel(odd)
                a = c.starts(f + odd(i) - 1);
                b = c.ends(f + odd(i) - 1);
                if ~strcmp(token, text(a:b)) % NaN often follows NaN
                    token = text(a:b);
                    [value, wrong] = occgrid.scenario.one_number(token);
                end
                special(i) = value;
                bad(odd(i)) = wrong;
                part(a - c.starts(f) + 1:b - c.starts(f) + 1) = ' ';
                part(a - c.starts(f) + 1) = '0';
            end
            v = sscanf(part, '%f');
            v(odd) = special;
            v(v >= 1e300) = Inf;
            v(v <= -1e300) = -Inf;
            v(abs(v) < 1e-300) = 0;
        end

        function [value, bad] = one_number(token)
            % any number of SPEC.md section 5.1
            value = 0;
            bad = isempty(regexp(token, ...
                ['^[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)' ...
                 '([eE][+-]?[0-9]+)?$'], 'once'));
            if ~bad
                value = sscanf(token, '%f');
            elseif ~isempty(regexpi(token, ...
                                    '^[+-]?(nan|inf|infinity)$', 'once'))
                bad = false;
                value = Inf;
                if any(lower(token) == 'a')
                    value = NaN;
                elseif token(1) == '-'
                    value = -Inf;
                end
            end
        end

        function value = number(file, line, field, token)
            % a number, NaN and infinity included
            [value, bad] = occgrid.scenario.one_number(token);
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

        function v = coordinates(file, line, fields, tokens)
            % coordinates in metres, or angles in radians
            v = zeros(1, numel(fields));
            for i = 1:numel(fields)
                v(i) = occgrid.scenario.real( ...
                    file, line, fields{i}, tokens{i}, '-1000000', '1000000');
            end
        end

        function fail(file, line, reason)
            error('occgrid:scenario', '%s:%d: %s', file, line, reason);
        end

    end
end
