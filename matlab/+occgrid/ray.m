classdef ray
    % RAY  Which cells a beam crosses: Bresenham's line (lesson section 4).
    %
    %   [gx, gy] = occgrid.ray.bresenham(gx0, gy0, gx1, gy1)

    methods (Static)

        % [snippet: bresenham]
        function [gx, gy] = bresenham(gx0, gy0, gx1, gy1)
            % BRESENHAM  Cells of the line from (gx0, gy0) to (gx1, gy1).
            %
            %   Bresenham's integer line (1965) in closed form: step k goes k
            %   cells along the longer axis and floor((2 k b + a - 1) / (2 a))
            %   along the shorter one, where a and b are the line's extents
            %   along the two. gx, gy: (a + 1, 1), both ends included, in
            %   order. More than 2^20 steps: occgrid:ray.
            dx = abs(gx1 - gx0);
            dy = abs(gy1 - gy0);
            sx = 2 .* (gx0 < gx1) - 1;
            sy = 2 .* (gy0 < gy1) - 1;
            a = max(dx, dy);
            b = min(dx, dy);
            if a > 2^20
                error('occgrid:ray', 'a line of more than 2^20 steps');
            end
            k = (0:a)';
            a = max(a, 1); % a line of one cell has step 0 only
            % exact: every number here is whole and below 2^53
            minor = floor((2 .* k .* b + a - 1) ./ (2 .* a));
            if dx >= dy
                gx = gx0 + sx .* k;
                gy = gy0 + sy .* minor;
            else
                gx = gx0 + sx .* minor;
                gy = gy0 + sy .* k;
            end
        end

        % [/snippet]

    end
end
