function log_odds = map_as_lesson(work)
    % MAP_AS_LESSON  Log-odds (height, width) of the work, cell by cell.
    %
    %   The list of a beam's cells grows by one at each step, and each update
    %   looks at the borders.
    l0 = logit(0.5);
    steps.free = logit(0.30) - l0;
    steps.occ = logit(0.75) - l0;
    log_odds = l0 * ones(work.height, work.width);
    for s = 1:size(work.poses, 1)
        log_odds = update_from_scan( ...
            log_odds, work, steps, work.poses(s, :), work.ranges(:, s));
    end
end

function l = logit(p)
    l = log(p / (1 - p));
end

function [gx, gy] = world_to_grid(work, x, y)
    gx = floor((x - work.origin_x) / work.resolution);
    gy = floor((y - work.origin_y) / work.resolution);
end

function cells = bresenham(x, y, x_end, y_end)
    dx = abs(x_end - x);
    dy = abs(y_end - y);
    x_step = 2 * (x < x_end) - 1;
    y_step = 2 * (y < y_end) - 1;
    error_ = dx - dy;
    cells = [];
    while true
        cells = [cells; x, y]; % grows as in the lesson
        if x == x_end && y == y_end
            return
        end
        twice = 2 * error_;
        if twice > -dy
            error_ = error_ - dy;
            x = x + x_step;
        end
        if twice < dx
            error_ = error_ + dx;
            y = y + y_step;
        end
    end
end

function log_odds = update_from_scan(log_odds, work, steps, pose, ranges)
    [gx0, gy0] = world_to_grid(work, pose(1), pose(2));
    for i = 1:numel(work.angles)
        heading = pose(3) + work.angles(i);
        z = min(ranges(i), work.max_range);
        [gx1, gy1] = world_to_grid(work, pose(1) + z * cos(heading), ...
                                   pose(2) + z * sin(heading));
        cells = bresenham(gx0, gy0, gx1, gy1);
        hit = z < work.max_range - 1e-12;
        for k = 1:size(cells, 1) - hit
            gx = cells(k, 1);
            gy = cells(k, 2);
            if gx >= 0 && gx < work.width && gy >= 0 && gy < work.height
                log_odds(gy + 1, gx + 1) = ...
                    clamp(log_odds(gy + 1, gx + 1) + steps.free);
            end
        end
        if hit
            gx = cells(end, 1);
            gy = cells(end, 2);
            if gx >= 0 && gx < work.width && gy >= 0 && gy < work.height
                log_odds(gy + 1, gx + 1) = ...
                    clamp(log_odds(gy + 1, gx + 1) + steps.occ);
            end
        end
    end
end

function l = clamp(l)
    l = min(max(l, -8), 8);
end
