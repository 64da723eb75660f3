classdef sensor
    % SENSOR  The range sensor: bearings, what a range means, the update.
    %
    %   angles = occgrid.sensor.beam_angles(fov, n_beams)
    %   angles = occgrid.sensor.flaser_angles(n_beams)
    %   [z, hit, used] = occgrid.sensor.read_ranges(ranges, z_max, no_return)
    %   [ex, ey] = occgrid.sensor.beam_endpoints(x, y, theta, angles, z)
    %   map = occgrid.sensor.update_grid_from_scan(map, scan, z_max, no_return)
    %
    %   Lesson section 4. A scan is a struct: pose (1, 3), the sensor's x, y
    %   and theta in metres and radians; angles (n, 1), bearings in radians
    %   from its heading; ranges (n, 1) in metres. Octave and MATLAB are quick
    %   on long arrays, so a scan may also hold m scans in order that have
    %   the same bearings: pose (m, 3), ranges (n, m).

    methods (Static)

        % [snippet: beam-angles]
        function angles = beam_angles(fov, n_beams)
            % BEAM_ANGLES  Bearings (n_beams, 1) of a simulated scan.
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
            %   3): the beam is free up to z_max, or ignored. z, hit, used:
            %   of the shape of ranges.
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
        function [ex, ey] = beam_endpoints(x, y, theta, angles, z)
            % BEAM_ENDPOINTS  World points, metres, where beams end.
            %
            %   x, y, theta: (1, m); angles: (n, 1); z, ex, ey: (n, m).
            beam = theta + angles;
            ex = x + z .* occgrid.portable_math.cos(beam);
            ey = y + z .* occgrid.portable_math.sin(beam);
        end

        % [/snippet]

        % [snippet: update-grid-from-scan]
        function map = update_grid_from_scan(map, scan, z_max, no_return)
            % UPDATE_GRID_FROM_SCAN  The inverse sensor model.
            %
            %   Free along each beam, occupied at its hit. no_return: 'free'
            %   or 'ignore'.
            x = scan.pose(:, 1)';
            y = scan.pose(:, 2)';
            theta = scan.pose(:, 3)';
            [z, hit, used] = occgrid.sensor.read_ranges( ...
                scan.ranges, z_max, no_return);
            [ex, ey] = occgrid.sensor.beam_endpoints( ...
                x, y, theta, scan.angles, z);
            x = x + zeros(size(ex));
            y = y + zeros(size(ey));
            % from here on a row vector, an element per beam
            hit = reshape(hit(used), 1, []);
            [gx0, gy0] = occgrid.grid.world_to_grid( ...
                map, reshape(x(used), 1, []), reshape(y(used), 1, []));
            [gx1, gy1] = occgrid.grid.world_to_grid( ...
                map, reshape(ex(used), 1, []), reshape(ey(used), 1, []));

            [first, last] = occgrid.ray.clip_ray( ...
                gx0, gy0, gx1, gy1, map.spec.width, map.spec.height);
            counts = max(last - first + 1, 0);
            a = max(abs(gx1 - gx0), abs(gy1 - gy0));
            for run = occgrid.sensor.runs(counts)
                pieces = occgrid.sensor.pieces(run{1}, counts);
                cells = cell(size(pieces));
                beams = cell(size(pieces));
                occupied = cell(size(pieces));
                for i = 1:numel(pieces)
                    j = pieces{i};
                    % a column per beam, a row per step
                    k = first(j) + (0:max(counts(j)) - 1)';
                    [gx, gy] = occgrid.ray.bresenham( ...
                        gx0(j), gy0(j), gx1(j), gy1(j), k);
                    inside = k <= last(j);
                    index = gx .* map.spec.height + gy + 1;
                    beam = repmat(j, size(k, 1), 1);
                    at_hit = hit(j) & k == a(j);
                    cells{i} = reshape(index(inside), [], 1);
                    beams{i} = reshape(beam(inside), [], 1);
                    occupied{i} = reshape(at_hit(inside), [], 1);
                end
                map = occgrid.grid.update_cells( ...
                    map, vertcat(cells{:}), vertcat(beams{:}), ...
                    vertcat(occupied{:}));
            end
        end

        % [/snippet]

    end

    methods (Static, Access = private)

        function r = runs(counts)
            % beams that have cells, in runs of about 2^20 cells: bounds the
            % memory of an update, whatever the scans
            beams = find(counts > 0);
            n = counts(beams);
            run = floor((cumsum(n) - n) ./ 2^20);
            r = occgrid.sensor.split(beams, diff(run) ~= 0);
        end

        function p = pieces(beams, counts)
            % the beams of a run in pieces of about 2^15 cells, which fit the
            % processor's cache, the beams of a piece of similar length
            [n, by_length] = sort(counts(beams));
            piece = floor((cumsum(n) - n) ./ 2^15);
            octave_ = floor(log2(n));
            p = occgrid.sensor.split(beams(by_length), ...
                                     diff(piece) ~= 0 | diff(octave_) ~= 0);
        end

        function c = split(items, cut_after)
            % a row vector cut into a row of cells
            if isempty(items)
                c = {};
            else
                ends = [find(cut_after), numel(items)];
                c = mat2cell(items, 1, diff([0, ends]));
            end
        end

    end
end
