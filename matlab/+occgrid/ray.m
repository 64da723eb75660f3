classdef ray
    % RAY  Which cells a beam crosses: Bresenham's line (lesson section 4).
    %
    %   [gx, gy] = occgrid.ray.bresenham(gx0, gy0, gx1, gy1)
    %   [gx, gy] = occgrid.ray.bresenham(gx0, gy0, gx1, gy1, k)
    %   [first, last] = occgrid.ray.clip_ray(gx0, gy0, gx1, gy1, width, height)

    methods (Static)

        % [snippet: bresenham]
        function [gx, gy] = bresenham(gx0, gy0, gx1, gy1, k)
            % BRESENHAM  Cells of the line from (gx0, gy0) to (gx1, gy1).
            %
            %   Bresenham's integer line (1965), both ends included, in
            %   order. Step k goes k cells along the longer axis and
            %   floor((2 k b + a - 1) / (2 a)) along the shorter one, where a
            %   and b are the line's extents along the two. Without k: all
            %   steps of one line, k = 0 .. a, as columns. With k: arrays
            %   that expand to one shape, such as k (steps, 1) of lines
            %   (1, n).
            dx = abs(gx1 - gx0);
            dy = abs(gy1 - gy0);
            sx = 2 .* (gx0 < gx1) - 1;
            sy = 2 .* (gy0 < gy1) - 1;
            a = max(dx, dy);
            b = min(dx, dy);
            if nargin < 5
                k = (0:a)';
            end
            a = max(a, 1); % a line of one cell has step 0 only
            % exact: every number here is whole and below 2^53
            minor = floor((2 .* k .* b + (a - 1)) ./ (2 .* a));
            along_x = dx >= dy;
            gx = gx0 + (sx .* along_x) .* k + (sx .* ~along_x) .* minor;
            gy = gy0 + (sy .* ~along_x) .* k + (sy .* along_x) .* minor;
        end

        % [/snippet]

        % [snippet: clip-ray]
        function [first, last] = clip_ray(gx0, gy0, gx1, gy1, width, height)
            % CLIP_RAY  First and last step of each line inside the grid.
            %
            %   A line that misses the grid gets last < first. gx0, gy0, gx1,
            %   gy1: arrays of one shape. No cell outside is visited: step k
            %   has gone m cells along the shorter axis, or more, exactly
            %   when 2 k b >= 2 a m - a + 1.
            dx = abs(gx1 - gx0);
            dy = abs(gy1 - gy0);
            a = max(dx, dy);
            b = min(dx, dy);
            % steps that each axis may go: low <= step <= high
            [low, high] = occgrid.ray.steps_inside(gx0, gx1, width);
            [m_low, m_high] = occgrid.ray.steps_inside(gy0, gy1, height);
            along_y = dx < dy;
            [low(along_y), m_low(along_y)] = ...
                deal(m_low(along_y), low(along_y));
            [high(along_y), m_high(along_y)] = ...
                deal(m_high(along_y), high(along_y));
            enters = occgrid.ray.first_step(m_low, a, b);
            leaves = occgrid.ray.first_step(m_high + 1, a, b);
            first = max(max(low, 0), enters);
            last = min(min(high, a), leaves - 1);
        end

        function [low, high] = steps_inside(g0, g1, size_)
            % fewest and most cells to go from g0 towards g1 to be in
            % 0 .. size_ - 1
            low = g0 - (size_ - 1);
            high = g0;
            forward = g0 < g1;
            low(forward) = 0 - g0(forward);
            high(forward) = (size_ - 1) - g0(forward);
        end

        function k = first_step(m, a, b)
            % the first step that has gone m cells along the shorter axis
            k = ceil((2 .* a .* m - a + 1) ./ max(2 .* b, 1));
            k(b == 0) = a(b == 0) + 1; % never
            k(m <= 0) = 0;
        end

        % [/snippet]

    end
end
