function tests = test_sensor()
    % TEST_SENSOR  Bearings, readings and the inverse sensor model.
    tests = {@simulated_bearings, @recorded_bearings, @readings, ...
             @ignored_readings, @endpoints, @hit, @hit_in_own_cell, ...
             @no_return_marks_no_wall, @ignored_beams_change_nothing, ...
             @robot_outside, @edges_of_cells, @definition};
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
    [ex, ey] = occgrid.sensor.beam_endpoints( ...
        occgrid.world.pose(1, 2, 0.25), [-0.25; 0.5], [3; 4]);
    same(ex, [4; 1 + 4 * occgrid.portable_math.cos(0.75)]);
    same(ey, [2; 2 + 4 * occgrid.portable_math.sin(0.75)]);
end

function map = small_map()
    spec = occgrid.grid.grid_spec(6, 3, 1, 0, 0);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
end

function pose = robot(x, theta)
    pose = occgrid.world.pose(x, 1.5, theta);
end

function map = update(map, pose, angles, ranges, z_max, no_return)
    scan = occgrid.sensor.scan(pose, angles, ranges);
    map = occgrid.sensor.update_grid_from_scan(map, scan, z_max, no_return);
end

function hit()
    % robot in cell (0, 1), hit in cell (3, 1)
    map = update(small_map(), robot(0.5, 0), 0, 3, 10, 'free');
    f = map.l_free;
    same(map.log_odds, [0, 0, 0, 0, 0, 0
                        f, f, f, map.l_occ, 0, 0
                        0, 0, 0, 0, 0, 0]);
end

function hit_in_own_cell()
    map = update(small_map(), robot(0.5, 0), 0, 0.2, 10, 'free');
    same(map.log_odds(2, :), [map.l_occ, 0, 0, 0, 0, 0]);
end

function no_return_marks_no_wall()
    % Problem 3: at the maximum range nothing was hit
    map = update(small_map(), robot(0.5, 0), 0, 3, 3, 'free');
    same(map.log_odds(2, :), [map.l_free * [1, 1, 1, 1], 0, 0]);
end

function ignored_beams_change_nothing()
    map = update(small_map(), robot(0.5, 0), [0; 0.1], [3; Inf], 3, 'ignore');
    same(nnz(map.log_odds), 0);
    map = update(small_map(), robot(0.5, 0), 0, NaN, 3, 'free');
    same(nnz(map.log_odds), 0);
end

function robot_outside()
    map = update(small_map(), robot(-2.5, 0), 0, 5, 10, 'free');
    same(map.log_odds(2, :), [map.l_free, map.l_free, map.l_occ, 0, 0, 0]);
    map = update(small_map(), robot(-2.5, 0), 0, 20, 100, 'free');
    same(map.log_odds(2, :), repmat(map.l_free, 1, 6));
    map = update(small_map(), robot(-2.5, pi), 0, 20, 100, 'free');
    same(nnz(map.log_odds), 0);
end

function edges_of_cells()
    % a robot on a corner of cells, beams along their edges
    map = update(small_map(), occgrid.world.pose(2, 1, 0), [0; pi / 2], ...
        [2; 1], 10, 'free');
    f = map.l_free;
    o = map.l_occ;
    same(map.log_odds, [0, 0, 0, 0, 0, 0
                        0, 0, f + f, f, o, 0
                        0, 0, o, 0, 0, 0]);
end

function definition()
    % the contract, beam by beam and cell by cell
    restores = seeded(3); %#ok<NASGU>
    for trial = 1:6
        s = random_scenario();
        z_max = s.settings.max_range;
        pose = s.scans(1).pose;
        angles = 6 * rand(25, 1) - 3;
        ranges = 1.2 * z_max * rand(25, 1);
        map = occgrid.scenario.new_grid(s.settings);
        expected = map;
        for i = 1:25
            is_hit = ranges(i) < z_max - 1e-12;
            [ex, ey] = occgrid.sensor.beam_endpoints( ...
                pose, angles(i), min(ranges(i), z_max));
            [gx0, gy0] = occgrid.grid.world_to_grid(map, pose.x, pose.y);
            [gx1, gy1] = occgrid.grid.world_to_grid(map, ex, ey);
            cells = line_walk(gx0, gy0, gx1, gy1);
            for k = 1:size(cells, 1)
                l = map.l_free;
                if is_hit && k == size(cells, 1)
                    l = map.l_occ;
                end
                expected = occgrid.grid.update_cell( ...
                    expected, cells(k, 1), cells(k, 2), l);
            end
        end
        map = update(map, pose, angles, ranges, z_max, 'free');
        same(map.log_odds, expected.log_odds);
    end
end
