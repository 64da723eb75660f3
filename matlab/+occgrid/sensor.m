classdef sensor
    % SENSOR  The range sensor: bearings, what a range means, the update.
    %
    %   scan = occgrid.sensor.scan(pose, angles, ranges)
    %   angles = occgrid.sensor.beam_angles(fov, n_beams)
    %   angles = occgrid.sensor.flaser_angles(n_beams)
    %   [z, hit, used] = occgrid.sensor.read_ranges(ranges, z_max, no_return)
    %   [ex, ey] = occgrid.sensor.beam_endpoints(pose, angles, z)
    %   grid = occgrid.sensor.update_grid_from_scan( ...
    %       grid, scan, z_max, no_return)
    %
    %   Lesson section 4.

    methods (Static)

        function s = scan(pose, angles, ranges)
            % SCAN  One turn of the sensor.
            %
            %   pose: the sensor's (see occgrid.world.pose); angles: (n, 1)
            %   bearings in radians from its heading; ranges: (n, 1) metres,
            %   NaN for a beam to ignore. For m poses side by side: (n, m).
            s.pose = pose;
            s.angles = angles;
            s.ranges = ranges;
        end

        % [snippet: beam-angles]
        function angles = beam_angles(fov, n_beams)
            % BEAM_ANGLES  Bearings (n_beams, 1) of a simulated scan.
            %
            %   fov: the field of view, radians.
            if n_beams == 1
                angles = 0;
            else
                i = (0:n_beams - 1)';
                angles = -(fov ./ 2) + (fov .* i) ./ (n_beams - 1);
            end
        end

        % [/snippet]

        % [snippet: flaser-angles]
        function angles = flaser_angles(n_beams)
            % FLASER_ANGLES  Bearings (n_beams, 1) of a FLASER scan.
            %
            %   Its step is known by its count.
            if any(n_beams == [180, 181])
                step = pi ./ 180;
            elseif any(n_beams == [360, 361])
                step = pi ./ 360;
            elseif any(n_beams == [400, 401])
                step = pi ./ 720;
            elseif n_beams > 1
                step = pi ./ (n_beams - 1);
            else
                step = 0;
            end
            angles = -(pi ./ 2) + (0:n_beams - 1)' .* step;
        end

        % [/snippet]

        % [snippet: read-ranges]
        function [z, hit, used] = read_ranges(ranges, z_max, no_return)
            % READ_RANGES  What ranges in metres mean: distance, hit, used.
            %
            %   NaN is ignored. At z_max or beyond nothing was hit (Problem
            %   3): the beam is free up to z_max ('free'), or ignored
            %   ('ignore'). z, hit, used: of the shape of ranges.
            hit = ranges < z_max - 1e-12;
            z = ranges;
            z(~hit) = z_max;
            if strcmp(no_return, 'ignore')
                used = hit;
            else
                used = ~isnan(ranges);
            end
        end

        % [/snippet]

        % [snippet: beam-endpoints]
        function [ex, ey] = beam_endpoints(pose, angles, z)
            % BEAM_ENDPOINTS  World points, metres, where beams end.
            %
            %   angles: (n, 1) radians; z, ex, ey: (n, 1) metres, or (n, m)
            %   for m poses side by side.
            beam = pose.theta + angles;
            ex = pose.x + z .* occgrid.portable_math.cos(beam);
            ey = pose.y + z .* occgrid.portable_math.sin(beam);
        end

        % [/snippet]

        % [snippet: update-grid-from-scan]
        function grid = update_grid_from_scan(grid, scan, z_max, no_return)
            % UPDATE_GRID_FROM_SCAN  The inverse sensor model.
            %
            %   Free along each beam, occupied at its hit. z_max: metres;
            %   no_return: 'free' or 'ignore'.
            [z, hit, used] = occgrid.sensor.read_ranges( ...
                scan.ranges, z_max, no_return);
            [ex, ey] = occgrid.sensor.beam_endpoints( ...
                scan.pose, scan.angles, z);
            [gx0, gy0] = occgrid.grid.world_to_grid( ...
                grid, scan.pose.x, scan.pose.y);
            [gx1, gy1] = occgrid.grid.world_to_grid(grid, ex, ey);
            for i = reshape(find(used), 1, [])
                [gx, gy] = occgrid.ray.bresenham(gx0, gy0, gx1(i), gy1(i));
                n_free = numel(gx) - hit(i); % the cells before the hit
                % one beam's cells at once: none of them comes twice
                grid = occgrid.grid.update_cells( ...
                    grid, gx(1:n_free), gy(1:n_free), grid.l_free);
                if hit(i)
                    grid = occgrid.grid.update_cell( ...
                        grid, gx1(i), gy1(i), grid.l_occ);
                end
            end
        end

        % [/snippet]

    end
end
