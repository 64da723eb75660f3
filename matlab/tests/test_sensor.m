function tests = test_sensor()
    % TEST_SENSOR  Bearings, readings and the inverse sensor model.
    tests = {@simulated_bearings, @recorded_bearings, @readings, ...
             @ignored_readings, @endpoints, @hit, @hit_in_own_cell, ...
             @no_return_marks_no_wall, @ignored_beams_change_nothing, ...
             @robot_outside, @definition, @several_scans_at_once};
end

function simulated_bearings()
    same(occgrid.sensor.beam_angles(pi, 1), 0);
    same(occgrid.sensor.beam_angles(2, 3), [-1; 0; 1]);
    angles = occgrid.sensor.beam_angles(pi, 181);
    same(angles(34), -(pi / 2) + (pi * 33) / 180);
end

function recorded_bearings()
    for n = [180, 181, 360, 361, 400, 401, 2, 541, 1]
        switch n
            case {180, 181}
                step = pi / 180;
            case {360, 361}
                step = pi / 360;
            case {400, 401}
                step = pi / 720;
            case 1
                step = 0;
            otherwise
                step = pi / (n - 1);
        end
        angles = occgrid.sensor.flaser_angles(n);
        same(size(angles), [n, 1]);
        same(angles(end), -(pi / 2) + (n - 1) * step);
    end
end

function readings()
    ranges = [0; 9.9; 10 - 1e-12; 10; 11; Inf; NaN];
    [z, hit_, used] = occgrid.sensor.read_ranges(ranges, 10, 'free');
    same(z, [0; 9.9; 10; 10; 10; 10; 10]);
    same(hit_, [true; true; false; false; false; false; false]);
    same(used, [true; true; true; true; true; true; false]);
end

function ignored_readings()
    ranges = [0, 9.9, 10, Inf, NaN];
    [~, hit_, used] = occgrid.sensor.read_ranges(ranges, 10, 'ignore');
    same(hit_, [true, true, false, false, false]);
    same(used, hit_);
end

function endpoints()
    [ex, ey] = occgrid.sensor.beam_endpoints(1, 2, 0.25, [-0.25; 0.5], [3; 4]);
    same(ex, [4; 1 + 4 * occgrid.portable_math.cos(0.75)]);
    same(ey, [2; 2 + 4 * occgrid.portable_math.sin(0.75)]);
end

function map = small_map()
    spec = occgrid.grid.grid_spec(6, 3, 1, 0, 0);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
end

function map = update(map, pose, angles, ranges, z_max, no_return)
    scan = struct('pose', pose, 'angles', angles, 'ranges', ranges);
    map = occgrid.sensor.update_grid_from_scan(map, scan, z_max, no_return);
end

function hit()
    % robot in cell (0, 1), hit in cell (3, 1)
    map = update(small_map(), [0.5, 1.5, 0], 0, 3, 10, 'free');
    f = map.l_free;
    same(map.log_odds, [0, 0, 0, 0, 0, 0
                        f, f, f, map.l_occ, 0, 0
                        0, 0, 0, 0, 0, 0]);
end

function hit_in_own_cell()
    map = update(small_map(), [0.5, 1.5, 0], 0, 0.2, 10, 'free');
    same(map.log_odds(2, :), [map.l_occ, 0, 0, 0, 0, 0]);
end

function no_return_marks_no_wall()
    % Problem 3: at the maximum range nothing was hit
    map = update(small_map(), [0.5, 1.5, 0], 0, 3, 3, 'free');
    same(map.log_odds(2, :), [map.l_free * [1, 1, 1, 1], 0, 0]);
end

function ignored_beams_change_nothing()
    map = update(small_map(), [0.5, 1.5, 0], [0; 0.1], [3; Inf], 3, 'ignore');
    same(nnz(map.log_odds), 0);
    map = update(small_map(), [0.5, 1.5, 0], 0, NaN, 3, 'free');
    same(nnz(map.log_odds), 0);
end

function robot_outside()
    map = update(small_map(), [-2.5, 1.5, 0], 0, 5, 10, 'free');
    same(map.log_odds(2, :), [map.l_free, map.l_free, map.l_occ, 0, 0, 0]);
    map = update(small_map(), [-2.5, 1.5, 0], 0, 20, 100, 'free');
    same(map.log_odds(2, :), repmat(map.l_free, 1, 6));
    map = update(small_map(), [-2.5, 1.5, pi], 0, 20, 100, 'free');
    same(nnz(map.log_odds), 0);
end

function definition()
    % the contract, beam by beam and cell by cell
    rand('twister', 3); %#ok<RAND>
    for trial = 1:20
        spec = occgrid.grid.grid_spec(15, 11, 0.3, -2, -1.5);
        map = occgrid.grid.occupancy_grid(spec, 0.5, 0.8, 0.35, -2, 3);
        pose = [5 * rand - 2, 4 * rand - 2, 7 * rand];
        angles = 6 * rand(25, 1) - 3;
        ranges = 4 * rand(25, 1);
        expected = map;
        for i = 1:25
            is_hit = ranges(i) < 3 - 1e-12;
            z = ranges(i);
            if ~is_hit
                z = 3;
            end
            [ex, ey] = occgrid.sensor.beam_endpoints( ...
                pose(1), pose(2), pose(3), angles(i), z);
            [gx0, gy0] = occgrid.grid.world_to_grid( ...
                map, pose(1), pose(2));
            [gx1, gy1] = occgrid.grid.world_to_grid(map, ex, ey);
            [gx, gy] = occgrid.ray.bresenham(gx0, gy0, gx1, gy1);
            for k = 1:numel(gx)
                l = map.l_free;
                if is_hit && k == numel(gx)
                    l = map.l_occ;
                end
                expected = occgrid.grid.update_cell( ...
                    expected, gx(k), gy(k), l);
            end
        end
        map = update(map, pose, angles, ranges, 3, 'free');
        same(map.log_odds, expected.log_odds);
    end
end

function several_scans_at_once()
    rand('twister', 4); %#ok<RAND>
    for beams = [1, 30]
        poses = [4 * rand(7, 1), 3 * rand(7, 1), rand(7, 1)];
        angles = 3 * rand(beams, 1);
        ranges = 4 * rand(beams, 7);
        one = small_map();
        for i = 1:7
            one = update(one, poses(i, :), angles, ranges(:, i), 3, 'free');
        end
        many = update(small_map(), poses, angles, ranges, 3, 'free');
        same(many.log_odds, one.log_odds);
    end
end
