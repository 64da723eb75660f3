function cells = line_walk(gx0, gy0, gx1, gy1)
    % LINE_WALK  The contract's definition of a line, step by step: (n, 2).
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
