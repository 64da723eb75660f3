function tests = test_ray()
    % TEST_RAY  Which cells a line crosses.
    tests = {@one_cell, @straight, @octants, @ties, @definition, @too_long};
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

function definition()
    for gx = -9:9
        for gy = -9:9
            same(line_cells(1, 2, 1 + gx, 2 + gy), ...
                line_walk(1, 2, 1 + gx, 2 + gy));
        end
    end
    restores = seeded(5); %#ok<NASGU>
    for trial = 1:30
        ends = num2cell(floor(400 * rand(1, 4)) - 200);
        same(line_cells(ends{:}), line_walk(ends{:}));
    end
end

function too_long()
    same(size(line_cells(0, 0, 2^20, 5)), [2^20 + 1, 2]);
    raises(@() occgrid.ray.bresenham(0, 0, 5, -2^20 - 1), ...
        'occgrid:ray', 'a line of more than 2^20 steps');
end
