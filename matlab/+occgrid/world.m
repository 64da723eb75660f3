classdef world
    % WORLD  The simulated world: walls, ray casting, range scans.
    %
    %   wall = occgrid.world.segment(x0, y0, x1, y1)
    %   walls = occgrid.world.build_box_world(xmin, ymin, xmax, ymax)
    %   wall = occgrid.world.add_vertical_wall(x, y0, y1)
    %   wall = occgrid.world.add_horizontal_wall(y, x0, x1)
    %   t = occgrid.world.ray_segment_intersection(rx, ry, rdx, rdy, wall)
    %   ranges = occgrid.world.simulate_lidar_scan(pose, walls, angles, z_max)
    %
    %   Lesson section 6. A pose is a row (x, y, theta) in metres and
    %   radians, a wall a row (x0, y0, x1, y1) in metres.

    methods (Static)

        function wall = segment(x0, y0, x1, y1)
            % SEGMENT  A wall from (x0, y0) to (x1, y1), metres.
            wall = [x0, y0, x1, y1];
        end

        % [snippet: box-world]
        function walls = build_box_world(xmin, ymin, xmax, ymax)
            % BUILD_BOX_WORLD  A rectangle's walls, counterclockwise.
            walls = [xmin, ymin, xmax, ymin
                     xmax, ymin, xmax, ymax
                     xmax, ymax, xmin, ymax
                     xmin, ymax, xmin, ymin];
        end

        function wall = add_vertical_wall(x, y0, y1)
            % ADD_VERTICAL_WALL  A wall along y.
            wall = occgrid.world.segment(x, y0, x, y1);
        end

        function wall = add_horizontal_wall(y, x0, x1)
            % ADD_HORIZONTAL_WALL  A wall along x.
            wall = occgrid.world.segment(x0, y, x1, y);
        end

        % [/snippet]

        % [snippet: ray-segment-intersection]
        function t = ray_segment_intersection(rx, ry, rdx, rdy, wall)
            % RAY_SEGMENT_INTERSECTION  Distances at which rays meet a wall.
            %
            %   rx, ry: where the rays start, metres, (1, m); rdx, rdy:
            %   directions, (n, m). t: (n, m) metres; infinity where a ray is
            %   parallel or misses.
            sx = wall(3) - wall(1);
            sy = wall(4) - wall(2);
            rxs = rdx .* sy - rdy .* sx;
            parallel = abs(rxs) < 1e-12;
            qpx = wall(1) - rx;
            qpy = wall(2) - ry;
            t = (qpx .* sy - qpy .* sx) ./ rxs;
            u = (qpx .* rdy - qpy .* rdx) ./ rxs;
            t(parallel | ~(t >= 0 & u >= 0 & u <= 1)) = Inf;
        end

        % [/snippet]

        % [snippet: simulate-lidar-scan]
        function ranges = simulate_lidar_scan(pose, walls, angles, z_max)
            % SIMULATE_LIDAR_SCAN  Ranges along bearings from a pose.
            %
            %   pose: (1, 3), or (m, 3) for m scans at once; walls: (w, 4);
            %   angles: (n, 1). ranges: (n, m) metres. A beam that meets no
            %   wall within z_max reads z_max.
            x = pose(:, 1)';
            y = pose(:, 2)';
            beam = pose(:, 3)' + angles;
            rdx = occgrid.portable_math.cos(beam);
            rdy = occgrid.portable_math.sin(beam);
            nearest = Inf(size(beam));
            for i = 1:size(walls, 1)
                t = occgrid.world.ray_segment_intersection( ...
                    x, y, rdx, rdy, walls(i, :));
                nearest = min(nearest, t);
            end
            ranges = nearest;
            ranges(~(nearest <= z_max)) = z_max;
        end

        % [/snippet]

    end
end
