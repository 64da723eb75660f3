function tests = test_ray()
    % TEST_RAY  Which cells a line crosses.
    tests = {@one_cell, @straight, @octants, @ties, @definition, ...
             @lines_of_a_scan, @clipping, @clipping_far_away};
end

function cells = line_cells(varargin)
    [gx, gy] = occgrid.ray.bresenham(varargin{:});
    cells = [gx, gy];
end

function one_cell()
    same(line_cells(3, -4, 3, -4), [3, -4]);
end

function straight()
    same(line_cells(0, 0, 3, 0), [0, 0; 1, 0; 2, 0; 3, 0]);
    same(line_cells(0, 0, -2, 0), [0, 0; -1, 0; -2, 0]);
    same(line_cells(5, 1, 5, 3), [5, 1; 5, 2; 5, 3]);
    same(line_cells(5, 1, 5, -1), [5, 1; 5, 0; 5, -1]);
    same(line_cells(0, 0, 2, 2), [0, 0; 1, 1; 2, 2]);
    same(line_cells(0, 0, -2, 2), [0, 0; -1, 1; -2, 2]);
end

function octants()
    same(line_cells(0, 0, 5, 2), ...
        [0, 0; 1, 0; 2, 1; 3, 1; 4, 2; 5, 2]);
    base = [0, 0; 1, 0; 2, 1; 3, 1; 4, 2; 5, 2];
    for sx = [-1, 1]
        for sy = [-1, 1]
            same(line_cells(0, 0, 5 * sx, 2 * sy), 0 + base .* [sx, sy]);
            same(line_cells(0, 0, 2 * sx, 5 * sy), ...
                0 + base(:, [2, 1]) .* [sx, sy]);
        end
    end
end

function ties()
    % the middle of the line is just between two cells
    same(line_cells(0, 0, 2, 1), [0, 0; 1, 0; 2, 1]);
    same(line_cells(0, 0, 4, 1), [0, 0; 1, 0; 2, 0; 3, 1; 4, 1]);
    same(line_cells(0, 0, -2, -1), [0, 0; -1, 0; -2, -1]);
    same(line_cells(0, 0, 1, 2), [0, 0; 0, 1; 1, 2]);
    same(line_cells(2, 1, 0, 0), [2, 1; 1, 1; 0, 0]);
end

function cells = walk(gx0, gy0, gx1, gy1)
    % the contract's definition, step by step
    dx = abs(gx1 - gx0);
    dy = abs(gy1 - gy0);
    sx = sign(gx1 - gx0);
    sy = sign(gy1 - gy0);
    error_ = dx - dy;
    cells = zeros(max(dx, dy) + 1, 2);
    n = 1;
    cells(1, :) = [gx0, gy0];
    while any(cells(n, :) ~= [gx1, gy1])
        step = [0, 0];
        twice = 2 * error_;
        if twice > -dy
            error_ = error_ - dy;
            step(1) = sx;
        end
        if twice < dx
            error_ = error_ + dx;
            step(2) = sy;
        end
        cells(n + 1, :) = cells(n, :) + step;
        n = n + 1;
    end
    same(n, size(cells, 1));
end

function definition()
    for gx = -9:9
        for gy = -9:9
            same(line_cells(1, 2, 1 + gx, 2 + gy), ...
                walk(1, 2, 1 + gx, 2 + gy));
        end
    end
    rand('twister', 5); %#ok<RAND>
    for trial = 1:100
        ends = num2cell(floor(400 * rand(1, 4)) - 200);
        same(line_cells(ends{:}), walk(ends{:}));
    end
end

function lines_of_a_scan()
    % steps k of several lines at once, a column per line
    ends = [0, 0, 7, 3; 4, 4, -3, 9; 2, 2, 2, 2]';
    k = (0:2)' + zeros(1, 3);
    k(:, 3) = 0;
    [gx, gy] = occgrid.ray.bresenham( ...
        ends(1, :), ends(2, :), ends(3, :), ends(4, :), k);
    for i = 1:2
        cells = walk(ends(1, i), ends(2, i), ends(3, i), ends(4, i));
        same([gx(:, i), gy(:, i)], cells(1:3, :));
    end
    same([gx(:, 3), gy(:, 3)], [2, 2; 2, 2; 2, 2]);
end

function clipping()
    rand('twister', 6); %#ok<RAND>
    width = 12;
    height = 7;
    ends = floor(40 * rand(4, 4000)) - 14;
    [first, last] = occgrid.ray.clip_ray( ...
        ends(1, :), ends(2, :), ends(3, :), ends(4, :), width, height);
    for i = 1:size(ends, 2)
        cells = walk(ends(1, i), ends(2, i), ends(3, i), ends(4, i));
        inside = cells(:, 1) >= 0 & cells(:, 1) < width & ...
            cells(:, 2) >= 0 & cells(:, 2) < height;
        same(reshape(first(i):last(i), [], 1), find(inside) - 1);
    end
end

function clipping_far_away()
    % found without walking: robot 2e9 cells away
    [first, last] = occgrid.ray.clip_ray( ...
        [2000000000, -999990, -999990], [5, 5, 2000000000], ...
        [1999000000, 10, 10], [5, 5, 1999999990], 20, 10);
    same(last(1) < first(1), true);
    same([first(2), last(2)], [999990, 1000000]);
    same(last(3) < first(3), true);
end
