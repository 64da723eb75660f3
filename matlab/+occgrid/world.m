classdef world
    % WORLD  The simulated world: walls, ray casting, range scans.
    %
    %   pose = occgrid.world.pose(x, y, theta)
    %   wall = occgrid.world.segment(x0, y0, x1, y1)
    %   walls = occgrid.world.build_box_world(xmin, ymin, xmax, ymax)
    %   wall = occgrid.world.add_vertical_wall(x, y0, y1)
    %   wall = occgrid.world.add_horizontal_wall(y, x0, x1)
    %   t = occgrid.world.ray_segment_intersection(rx, ry, rdx, rdy, wall)
    %   ranges = occgrid.world.simulate_lidar_scan(pose, walls, angles, z_max)
    %
    %   Lesson section 6. Several walls are a struct array (w, 1).

    methods (Static)

        function p = pose(x, y, theta)
            % POSE  Where the sensor stands: metres, and its heading, radians.
            %
            %   x, y, theta: scalars, or rows (1, m) for m poses side by side.
            p.x = x;
            p.y = y;
            p.theta = theta;
        end

        function wall = segment(x0, y0, x1, y1)
            % SEGMENT  A wall from (x0, y0) to (x1, y1), metres.
            wall.x0 = x0;
            wall.y0 = y0;
            wall.x1 = x1;
            wall.y1 = y1;
        end

        % [snippet: box-world]
        function walls = build_box_world(xmin, ymin, xmax, ymax)
            % BUILD_BOX_WORLD  A rectangle's walls, counterclockwise.
            walls = [occgrid.world.segment(xmin, ymin, xmax, ymin)
                     occgrid.world.segment(xmax, ymin, xmax, ymax)
                     occgrid.world.segment(xmax, ymax, xmin, ymax)
                     occgrid.world.segment(xmin, ymax, xmin, ymin)];
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
            sx = wall.x1 - wall.x0;
            sy = wall.y1 - wall.y0;
            rxs = rdx .* sy - rdy .* sx;
            parallel = abs(rxs) < 1e-12;
            qpx = wall.x0 - rx;
            qpy = wall.y0 - ry;
            t = (qpx .* sy - qpy .* sx) ./ rxs;
            u = (qpx .* rdy - qpy .* rdx) ./ rxs;
            t(parallel | ~(t >= 0 & u >= 0 & u <= 1)) = Inf;
        end

        % [/snippet]

        % [snippet: simulate-lidar-scan]
        function ranges = simulate_lidar_scan(pose, walls, angles, z_max)
            % SIMULATE_LIDAR_SCAN  Ranges along bearings from a pose.
            %
            %   angles: (n, 1) radians; z_max: metres. ranges: (n, 1) metres,
            %   or (n, m) for m poses side by side. A beam that meets no wall
            %   within z_max reads z_max.
            beam = pose.theta + angles;
            rdx = occgrid.portable_math.cos(beam);
            rdy = occgrid.portable_math.sin(beam);
            nearest = Inf(size(beam));
            for i = 1:numel(walls)
                t = occgrid.world.ray_segment_intersection( ...
                    pose.x, pose.y, rdx, rdy, walls(i));
                nearest = min(nearest, t);
            end
            ranges = nearest;
            ranges(~(nearest <= z_max)) = z_max;
        end

        % [/snippet]

    end
end
