classdef map_writer
    % MAP_WRITER  Writing a map: picture, its description, log-odds.
    %
    %   pixels = occgrid.map_writer.pixel(log_odds)
    %   occgrid.map_writer.map_pgm(grid, put)
    %   text = occgrid.map_writer.map_yaml(grid, image)
    %   occgrid.map_writer.map_log_odds(grid, put)
    %   occgrid.map_writer.write_map(folder, name, grid)
    %   occgrid.map_writer.print_out(write)
    %
    %   SPEC.md section 7. put is a function that takes a piece of text, some
    %   rows of the map, so that the text of a large map is never in memory as
    %   a whole. To have it as a file:
    %
    %       id = fopen('map.pgm', 'w');
    %       occgrid.map_writer.map_pgm(grid, @(text) fprintf(id, '%s', text));
    %       fclose(id);

    methods (Static)

        % [snippet: pixel]
        function pixels = pixel(log_odds)
            % PIXEL  Grey values of log-odds: 0 occupied, 255 free.
            free = 1 - occgrid.grid.sigmoid(log_odds);
            pixels = floor(free .* 255 + 0.5);
        end

        % [/snippet]

        % [snippet: map-pgm]
        function map_pgm(grid, put)
            % MAP_PGM  The map as ASCII PGM (P2), the largest y first.
            spec = grid.spec;
            put(sprintf('P2\n%d %d\n255\n', spec.width, spec.height));
            step = ceil(2^16 ./ spec.width); % rows at once
            for top = spec.height:-step:1
                rows = top:-1:max(top - step + 1, 1);
                pixels = occgrid.map_writer.pixel(grid.log_odds(rows, :));
                put(occgrid.map_writer.lines_of('%d ', pixels));
            end
        end

        function text = lines_of(format, values)
            % LINES_OF  A line for each row of values, format for each value.
            text = sprintf(format, values');
            blanks_ = find(text == ' ');
            text(blanks_(size(values, 2):size(values, 2):end)) = newline;
        end

        % [/snippet]

        function text = map_yaml(grid, image)
            % MAP_YAML  What map_server and Nav2 read beside the picture.
            %
            %   image: the picture's file name.
            spec = grid.spec;
            fixed = @occgrid.map_writer.fixed;
            [occupied, free] = occgrid.map_writer.thresholds(grid.l0);
            lines = {['image: ', occgrid.map_writer.quoted(char(image))]
                     'mode: trinary'
                     ['resolution: ', fixed(spec.resolution)]
                     ['origin: [', fixed(spec.origin_x), ', ', ...
                      fixed(spec.origin_y), ', 0.0]']
                     'negate: 0'
                     ['occupied_thresh: ', fixed(occupied)]
                     ['free_thresh: ', fixed(free)]};
            text = sprintf('%s\n', lines{:});
        end

        function map_log_odds(grid, put)
            % MAP_LOG_ODDS  Log-odds as text, the smallest y first.
            %
            %   17 digits read back to the same doubles.
            spec = grid.spec;
            put(sprintf('# logodds %d %d\n', spec.width, spec.height));
            step = ceil(2^16 / spec.width); % rows at once
            for bottom = 1:step:spec.height
                rows = bottom:min(bottom + step - 1, spec.height);
                put(occgrid.map_writer.lines_of( ...
                    '%.17g ', grid.log_odds(rows, :)));
            end
        end

        function write_map(folder, name, grid)
            % WRITE_MAP  Write NAME.pgm, NAME.yaml and NAME.logodds.
            %
            %   The folder is made where it is missing. The files get their
            %   names when all of them are whole, or none does. Raises
            %   occgrid:output, with the message PATH: cannot be written.
            name = char(name);
            folder = occgrid.map_writer.without_slashes(char(folder));
            if ~occgrid.files.make_folder([folder, '/'])
                occgrid.map_writer.fail(folder);
            end
            occgrid.files.remove_old([folder, '/']);
            paths = {'.pgm', '.yaml', '.logodds'};
            for i = 1:3
                paths{i} = [folder, '/', name, paths{i}];
                if occgrid.files.is_folder(paths{i})
                    occgrid.map_writer.fail(paths{i});
                end
            end
            writers = {@(put) occgrid.map_writer.map_pgm(grid, put), ...
                       @(put) put(occgrid.map_writer.map_yaml( ...
                           grid, [name, '.pgm'])), ...
                       @(put) occgrid.map_writer.map_log_odds(grid, put)};
            beside = cell(1, 3);
            for i = 1:3
                beside{i} = [folder, '/', occgrid.files.temporary_name()];
            end
            % also where an error or an interrupt ends this
            removes = onCleanup(@() occgrid.files.remove(beside));
            for i = 1:3
                occgrid.map_writer.write_file(beside{i}, paths{i}, writers{i});
            end
            for i = 1:3
                if ~occgrid.files.rename(beside{i}, paths{i})
                    occgrid.files.remove(paths(1:i - 1));
                    occgrid.map_writer.fail(paths{i});
                end
            end
        end

        function write_file(beside, path, write)
            % WRITE_FILE  Write the file beside, which is to become path.
            %
            %   write(put) puts its text. Raises occgrid:output for path.
            id = occgrid.files.open(beside, 'w');
            if id < 0
                occgrid.map_writer.fail(path);
            end
            closes = onCleanup(@() fclose(id));
            write(@(text) occgrid.map_writer.put(id, path, text));
            bytes = ftell(id);
            clear closes;
            % what was still in the buffer shows in the file's size only
            if occgrid.files.size_of(beside) ~= bytes
                occgrid.map_writer.fail(path);
            end
        end

        function print_out(write)
            % PRINT_OUT  Write to standard output what write(put) puts.
            %
            %   Raises occgrid:output, with the message standard output:
            %   cannot be written.
            name = 'standard output';
            if ~exist('OCTAVE_VERSION', 'builtin') || ispc
                write(@(text) fprintf('%s', text));
                return
            end
            % No function of Octave tells whether a write to its standard
            % output failed, and opening /dev/stdout begins at the start of a
            % file that others write to as well. So cat does it, and its exit
            % status tells.
            file = tempname();
            removes = onCleanup(@() occgrid.files.remove({file}));
            occgrid.map_writer.write_file(file, name, write);
            fflush(stdout);
            if system(['cat ', occgrid.files.in_shell(file), ...
                       ' 2> /dev/null']) ~= 0
                occgrid.map_writer.fail(name);
            end
        end

        function fail(path)
            % FAIL  Raise occgrid:output.
            error('occgrid:output', '%s: cannot be written', ...
                  occgrid.files.shown(path));
        end

    end

    methods (Static, Access = private)

        function put(id, path, text)
            % write a piece of text to an open file; where the disk is full
            % Octave's fprintf counts all of it, but the position stays
            before = ftell(id);
            bytes = fprintf(id, '%s', text);
            if bytes < numel(text) || ftell(id) ~= before + bytes
                occgrid.map_writer.fail(path);
            end
        end

        function folder = without_slashes(folder)
            % a folder without the slashes at its end; '' for the root
            last = find(folder ~= '/', 1, 'last');
            folder = folder(1:max([last, 0]));
        end

        function text = quoted(name)
            % a file name as YAML has it
            plain = (name >= 'A' & name <= 'Z') | ...
                (name >= 'a' & name <= 'z') | ...
                (name >= '0' & name <= '9') | ...
                name == '_' | name == '.' | name == '-';
            text = name;
            if all(plain) && ~any(name(1) == '-.')
                return
            end
            pieces = num2cell(name);
            for i = find(name == '"' | name == '\')
                pieces{i} = ['\', name(i)];
            end
            for i = find(name < 32 | name == 127)
                pieces{i} = sprintf('\\x%02X', double(name(i)));
            end
            text = ['"', pieces{:}, '"'];
        end

        function [occupied, free] = thresholds(l0)
            % the probabilities above and below which a cell counts as
            % occupied and as free, so that a cell at the prior is neither
            grey = 255 - occgrid.map_writer.pixel(l0);
            occupied = occgrid.grid.sigmoid(l0 + occgrid.grid.logit(0.65));
            occupied = min(max(occupied, (grey + 0.5) / 255), 1);
            free = occgrid.grid.sigmoid(l0 + occgrid.grid.logit(0.196));
            free = max(min(free, (grey - 0.5) / 255), 0);
        end

        function text = fixed(value)
            % the value rounded to nine decimals, without trailing zeros but
            % one
            text = sprintf('%.9f', value);
            if mod(value * 1024, 2) == 1
                % half way between two: to the even one, which not every C
                % library does; exact, for a fraction is below 1
                whole = fix(value);
                billionths = abs(value - whole) * 1e9;
                even = 2 * round(billionths / 2);
                text = sprintf('%d.%09d', abs(whole), even);
                if value < 0
                    text = ['-', text];
                end
            end
            text = regexprep(text, '0+$', '');
            if text(end) == '.'
                text(end + 1) = '0';
            end
            if strcmp(text, '-0.0')
                text = '0.0';
            end
        end

    end
end
