classdef map_writer
    % MAP_WRITER  Writing a map: picture, its description, log-odds.
    %
    %   pixels = occgrid.map_writer.pixels(map)
    %   text = occgrid.map_writer.map_pgm(map)
    %   text = occgrid.map_writer.map_yaml(map, image)
    %   text = occgrid.map_writer.map_log_odds(map)
    %   occgrid.map_writer.write_map(folder, name, map)
    %   occgrid.map_writer.print_text(text)
    %
    %   SPEC.md section 7.

    methods (Static)

        % [snippet: pixel]
        function pixels = pixels(map)
            % PIXELS  Grey values (height, width): 0 occupied, 255 free.
            free = 1 - occgrid.grid.probability_grid(map);
            pixels = floor(free .* 255 + 0.5);
        end

        % [/snippet]

        % [snippet: map-pgm]
        function text = map_pgm(map)
            % MAP_PGM  The map as ASCII PGM (P2), the largest y first.
            head = sprintf('P2\n%d %d\n255\n', ...
                           map.spec.width, map.spec.height);
            pixels = flipud(occgrid.map_writer.pixels(map))';
            % much faster than sprintf: a column of text per pixel, filled
            % up with 0, which is left out at last
            table = char(zeros(4, 256));
            for i = 0:255
                number = sprintf('%d ', i);
                table(1:numel(number), i + 1) = number;
            end
            body = table(:, pixels(:) + 1);
            row_ends = body(:, map.spec.width:map.spec.width:end);
            row_ends(row_ends == ' ') = newline;
            body(:, map.spec.width:map.spec.width:end) = row_ends;
            text = [head, reshape(body(body ~= 0), 1, [])];
        end

        % [/snippet]

        function text = map_yaml(map, image)
            % MAP_YAML  What map_server and Nav2 read beside the picture.
            fixed = @occgrid.map_writer.fixed;
            text = [sprintf('image: %s\n', image), ...
                    sprintf('mode: trinary\n'), ...
                    sprintf('resolution: %s\n', fixed(map.spec.resolution)), ...
                    sprintf('origin: [%s, %s, 0.0]\n', ...
                            fixed(map.spec.origin_x), ...
                            fixed(map.spec.origin_y)), ...
                    sprintf('negate: 0\n'), ...
                    sprintf('occupied_thresh: 0.65\n'), ...
                    sprintf('free_thresh: 0.196\n')];
        end

        function text = map_log_odds(map)
            % MAP_LOG_ODDS  Log-odds as text, the smallest y first.
            %
            %   17 digits read back to the same doubles.
            head = sprintf('# logodds %d %d\n', ...
                           map.spec.width, map.spec.height);
            rows = max(floor(2^20 / map.spec.width), 1); % at once
            parts = cell(1, ceil(map.spec.height / rows));
            for i = 1:numel(parts)
                last = min(i * rows, map.spec.height);
                values = map.log_odds((i - 1) * rows + 1:last, :)';
                line = sprintf('%.17g ', values);
                spaces = find(line == ' ');
                line(spaces(map.spec.width:map.spec.width:end)) = newline;
                parts{i} = line;
            end
            text = [head, parts{:}];
        end

        function write_map(folder, name, map)
            % WRITE_MAP  Write NAME.pgm, NAME.yaml and NAME.logodds.
            %
            %   The folder is made where it is missing. The files are renamed
            %   into place when all of them are whole. Raises occgrid:output,
            %   with the message PATH: cannot be written.
            occgrid.map_writer.make_folder(folder);
            endings = {'.pgm', '.yaml', '.logodds'};
            texts = {occgrid.map_writer.map_pgm(map), ...
                     occgrid.map_writer.map_yaml(map, [name, '.pgm']), ...
                     occgrid.map_writer.map_log_odds(map)};
            paths = cell(1, 3);
            beside = cell(1, 3);
            for i = 1:3
                paths{i} = fullfile(folder, [name, endings{i}]);
                if isfolder(paths{i})
                    occgrid.map_writer.fail(paths{i});
                end
                [~, unique_] = fileparts(tempname());
                beside{i} = fullfile( ...
                    folder, ['.', name, endings{i}, '.', unique_, '.part']);
            end
            removes = onCleanup(@() occgrid.map_writer.remove(beside));
            for i = 1:3
                occgrid.map_writer.write_text(beside{i}, paths{i}, texts{i});
            end
            for i = 1:3
                occgrid.map_writer.rename_file(beside{i}, paths{i});
            end
        end

        function print_text(text)
            % PRINT_TEXT  Write a text to standard output.
            %
            %   Raises occgrid:output, with the message standard output:
            %   cannot be written.
            if ~exist('OCTAVE_VERSION', 'builtin') || ispc
                fprintf('%s', text);
                return
            end
            % No function of Octave tells whether a write to its standard
            % output failed, and opening /dev/stdout begins at the start of a
            % file that others write to as well. So cat does it, and its exit
            % status tells.
            name = 'standard output';
            file = tempname();
            removes = onCleanup(@() occgrid.map_writer.remove({file}));
            occgrid.map_writer.write_text(file, name, text);
            fflush(stdout);
            if system(['cat ''', strrep(file, '''', '''\'''''), ...
                       ''' 2> /dev/null']) ~= 0
                occgrid.map_writer.fail(name);
            end
        end

        function rename_file(from, to)
            % RENAME_FILE  Give a whole file its name, in one step.
            %
            %   Raises occgrid:output.
            failed = isfolder(to); % movefile would move the file into it
            if ~failed && exist('OCTAVE_VERSION', 'builtin')
                failed = rename(from, to) ~= 0;
            elseif ~failed
                failed = ~movefile(from, to, 'f');
            end
            if failed
                occgrid.map_writer.fail(to);
            end
        end

        function remove(files)
            % REMOVE  Delete those files that are there.
            for i = 1:numel(files)
                if exist(files{i}, 'file')
                    delete(files{i});
                end
            end
        end

        function fail(path)
            % FAIL  Raise occgrid:output.
            error('occgrid:output', '%s: cannot be written', path);
        end

    end

    methods (Static, Access = private)

        function text = fixed(value)
            % the value rounded to nine decimals, without trailing zeros but
            % one
            text = sprintf('%.9f', value);
            if mod(value * 1024, 2) == 1
                % half way between two: to the even one, which not every C
                % library does; exact, for value is below 2^20
                billionths = value * 1024 * 976562.5;
                even = 2 * round(billionths / 2);
                text = sprintf('%.9f', even / 1e9);
            end
            text = regexprep(text, '0+$', '');
            if text(end) == '.'
                text(end + 1) = '0';
            end
            if strcmp(text, '-0.0')
                text = '0.0';
            end
        end

        function make_folder(folder)
            % a folder with its parents
            if ~isfolder(folder)
                made = mkdir(occgrid.scenario.absolute(folder));
                if ~made
                    occgrid.map_writer.fail(folder);
                end
            end
        end

        function write_text(beside, path, text)
            % write a file that gets its name later
            id = fopen(occgrid.scenario.absolute(beside), 'w');
            if id < 0
                occgrid.map_writer.fail(path);
            end
            bytes = unicode2native(text, 'UTF-8');
            written = fwrite(id, bytes, 'uint8');
            closed = fclose(id);
            % Octave notices a failure when its buffer runs over, but not
            % when that is emptied at last; so the file is looked at
            listed = dir(occgrid.scenario.absolute(beside));
            if closed ~= 0 || written ~= numel(bytes) || ...
                    ~isscalar(listed) || listed.bytes ~= written
                occgrid.map_writer.fail(path);
            end
        end

    end
end
