function lines = probe_answers(name, words)
    % PROBE_ANSWERS  What a function of the port gives for many arguments.
    %
    %   name: as in vector_columns; words: (n, arguments) cell array of text.
    %   lines: (n, 1) cell array, the results of each call separated by
    %   blanks. Doubles are 16 hexadecimal digits, words of the random
    %   generator 8, integers decimal.
    n = size(words, 1);
    if n == 0
        lines = cell(0, 1);
        return
    end
    switch name
        case 'sin'
            lines = hex(occgrid.portable_math.sin(doubles(words)));
        case 'cos'
            lines = hex(occgrid.portable_math.cos(doubles(words)));
        case 'exp'
            lines = hex(occgrid.portable_math.exp(doubles(words)));
        case 'log'
            lines = hex(occgrid.portable_math.log(doubles(words)));
        case 'logit'
            lines = hex(occgrid.grid.logit(doubles(words)));
        case 'sigmoid'
            lines = hex(occgrid.grid.sigmoid(doubles(words)));
        case 'pixel'
            lines = whole(occgrid.map_writer.pixel(doubles(words)));
        case 'world_to_grid'
            v = doubles(words);
            grid.spec = occgrid.grid.grid_spec( ...
                1, 1, v(:, 1), v(:, 2), v(:, 3));
            [gx, gy] = occgrid.grid.world_to_grid(grid, v(:, 4), v(:, 5));
            lines = whole([gx, gy]);
        case 'bresenham'
            v = integers(words);
            lines = cell(n, 1);
            for i = 1:n
                [gx, gy] = occgrid.ray.bresenham( ...
                    v(i, 1), v(i, 2), v(i, 3), v(i, 4));
                text = sprintf('%.0f:%.0f ', [gx'; gy']);
                lines{i} = text(1:end - 1);
            end
        case 'clip_ray'
            lines = whole(clip_rays(integers(words)));
        case 'flaser_angles'
            v = integers(words);
            angle = zeros(n, 1);
            for i = 1:n
                angles = occgrid.sensor.flaser_angles(v(i, 1));
                angle(i) = angles(v(i, 2) + 1);
            end
            lines = hex(angle);
        case 'read_ranges'
            v = doubles(words(:, 1:2));
            lines = cell(n, 1);
            for i = 1:n
                [z, hit, used] = occgrid.sensor.read_ranges( ...
                    v(i, 1), v(i, 2), words{i, 3});
                lines(i) = joined([hex(z), whole([hit, used])]);
            end
        case 'beam_endpoints'
            v = doubles(words);
            pose = occgrid.world.pose(v(:, 1), v(:, 2), v(:, 3));
            [ex, ey] = occgrid.sensor.beam_endpoints(pose, v(:, 4), v(:, 5));
            lines = joined([hex(ex), hex(ey)]);
        case 'update_cell'
            v = doubles(words(:, 1:5));
            log_odds = zeros(n, 1);
            spec = occgrid.grid.grid_spec(1, 1, 1, 0, 0);
            for i = 1:n
                grid = occgrid.grid.occupancy_grid( ...
                    spec, v(i, 1), v(i, 2), v(i, 3), v(i, 4), v(i, 5));
                for letter = words{i, 6}
                    l_update = grid.l_free;
                    if letter == 'o'
                        l_update = grid.l_occ;
                    end
                    grid = occgrid.grid.update_cell(grid, 0, 0, l_update);
                end
                log_odds(i) = grid.log_odds;
            end
            lines = hex(log_odds);
        case 'philox'
            v = reshape(hex2dec(words(:)), size(words))';
            out = occgrid.noise.philox4x32(v(1:4, :), v(5:6, :));
            digits = lower(dec2hex(out', 8));
            lines = joined(reshape(cellstr(digits), n, 4));
        case 'normal_deviate'
            v = integers(words);
            deviate = zeros(n, 1);
            for i = 1:n
                deviate(i) = occgrid.noise.normal_deviate( ...
                    v(i, 1), v(i, 2), v(i, 3));
            end
            lines = hex(deviate);
        otherwise
            error('no function %s', name);
    end
end

function steps = clip_rays(v)
    % first and last step; 0 and -1 for a line that misses
    steps = zeros(size(v, 1), 2);
    [grids, ~, of] = unique(v(:, 5:6), 'rows');
    for i = 1:size(grids, 1)
        k = of == i;
        [first, last] = occgrid.fast.clip_ray( ...
            v(k, 1), v(k, 2), v(k, 3), v(k, 4), grids(i, 1), grids(i, 2));
        misses = last < first;
        first(misses) = 0;
        last(misses) = -1;
        steps(k, :) = [first, last];
    end
end

function v = doubles(words)
    % words of 16 hexadecimal digits
    v = reshape(hex2num(words(:)), size(words));
end

function v = integers(words)
    % decimal words
    v = reshape(sscanf(sprintf('%s ', words{:}), '%f'), size(words));
end

function c = hex(v)
    % doubles (n, 1) as 16 hexadecimal digits; one word for every NaN
    c = cellstr(num2hex(v));
    c(isnan(v)) = {'7ff8000000000000'};
end

function c = whole(v)
    % whole numbers (n, m), a row of them to a line
    format = [strjoin(repmat({'%.0f'}, 1, size(v, 2)), ' '), '\n'];
    c = strsplit(sprintf(format, double(v)' + 0), newline); % no -0
    c = reshape(c(1:end - 1), [], 1);
end

function c = joined(parts)
    % the cells of each row (n, m), with blanks between them
    c = parts(:, 1);
    for i = 2:size(parts, 2)
        c = strcat(c, {' '}, parts(:, i));
    end
end
