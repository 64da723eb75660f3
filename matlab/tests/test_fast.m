function tests = test_fast()
    % TEST_FAST  The fast path: every bit is that of the plain one.
    tests = {@random_worlds, @several_batches, @large_updates, ...
             @scans_of_a_recording, @one_scan, ...
             @one_row_and_one_column, @progress, @clipping, ...
             @clipping_far_away, @too_long};
end

function random_worlds()
    restores = seeded(3); %#ok<NASGU>
    touched = 0;
    for trial = 1:25
        s = random_scenario();
        for seed = {[], trial}
            plain = occgrid.mapper.map_scenario(s, seed{1});
            fast = occgrid.fast.map_scenario_fast(s, seed{1});
            same(fast.log_odds, plain.log_odds);
            touched = touched + any(plain.log_odds(:) ~= plain.l0);
        end
    end
    assert(touched > 25); % the worlds are not empty
end

function several_batches()
    % more than 8192 beams, their noise numbered through
    s = occgrid.lesson.lesson_scenario();
    s.scans = s.scans(1:47);
    plain = occgrid.mapper.map_scenario(s, 4);
    fast = occgrid.fast.map_scenario_fast(s, 4);
    same(fast.log_odds, plain.log_odds);
end

function large_updates()
    % more than 2^20 cells in a batch, and lines of many lengths
    spec = occgrid.grid.grid_spec(20000, 3, 0.01, 0, 0);
    plain = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
    pose = occgrid.world.pose(100, 0.015, 0);
    angles = [linspace(-1e-4, 1e-4, 80)'; pi; 2; -1];
    ranges = [linspace(0.001, 150, 80)'; 150; 1; 2];
    ranges(20:60) = 99.995;
    scan = occgrid.sensor.scan(pose, angles, ranges);
    scans = [scan, scan, scan];
    fast = occgrid.fast.update_grid_from_scans(plain, scans, 200, 'free');
    for i = 1:3
        plain = occgrid.sensor.update_grid_from_scan(plain, scan, 200, 'free');
    end
    assert(nnz(plain.log_odds) > 19000);
    same(fast.log_odds, plain.log_odds);
end

function scans_of_a_recording()
    % update_grid_from_scans is update_grid_from_scan, scan after scan
    restores = seeded(8); %#ok<NASGU>
    for trial = 1:10
        s = random_scenario();
        s.scans = s.scans(~cellfun(@isempty, {s.scans.ranges}));
        plain = occgrid.scenario.new_grid(s.settings);
        for scan = s.scans
            plain = occgrid.sensor.update_grid_from_scan( ...
                plain, scan, s.settings.max_range, 'free');
        end
        fast = occgrid.fast.update_grid_from_scans( ...
            occgrid.scenario.new_grid(s.settings), s.scans, ...
            s.settings.max_range, 'free');
        same(fast.log_odds, plain.log_odds);
    end
end

function one_scan()
    % a hit, a beam into the robot's own cell, one that is ignored
    spec = occgrid.grid.grid_spec(6, 3, 1, 0, 0);
    grid = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
    pose = occgrid.world.pose(0.5, 1.5, 0);
    scan = occgrid.sensor.scan(pose, [0; 0; 0], [3; 0.2; NaN]);
    updated = occgrid.fast.update_grid_from_scans(grid, scan, 10, 'free');
    f = grid.l_free;
    same(updated.log_odds, [zeros(1, 6)
                            f + grid.l_occ, f, f, grid.l_occ, 0, 0
                            zeros(1, 6)]);
    same(grid.log_odds, zeros(3, 6)); % the grid that was given is as before
end

function one_row_and_one_column()
    for shape = [1, 9, 1; 7, 1, 1]
        spec = occgrid.grid.grid_spec(shape(1), shape(2), 1, 0, 0);
        grid = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
        along = (shape(2) > 1) * pi / 2;
        pose = occgrid.world.pose(0.5, 0.5, along);
        scan = occgrid.sensor.scan(pose, [0; 0], [2.2; 20]);
        fast = occgrid.fast.update_grid_from_scans( ...
            grid, [scan, scan], 10, 'free');
        plain = occgrid.sensor.update_grid_from_scan(grid, scan, 10, 'free');
        plain = occgrid.sensor.update_grid_from_scan(plain, scan, 10, 'free');
        same(fast.log_odds, plain.log_odds);
    end
end

function progress()
    s = occgrid.lesson.lesson_scenario();
    text = evalc(['occgrid.fast.map_scenario_fast(s, [], ' ...
                  '@(done) fprintf(''%d '', done));']); %#ok<NASGU>
    same(text, '46 92 120 ');
end

function clipping()
    restores = seeded(6); %#ok<NASGU>
    width = 12;
    height = 7;
    ends = floor(40 * rand(4, 600)) - 14;
    [first, last] = occgrid.fast.clip_ray( ...
        ends(1, :), ends(2, :), ends(3, :), ends(4, :), width, height);
    for i = 1:size(ends, 2)
        cells = line_walk(ends(1, i), ends(2, i), ends(3, i), ends(4, i));
        inside = cells(:, 1) >= 0 & cells(:, 1) < width & ...
            cells(:, 2) >= 0 & cells(:, 2) < height;
        same(reshape(first(i):last(i), [], 1), find(inside) - 1);
    end
end

function clipping_far_away()
    % found without walking, exactly: the robot 1e10 cells away
    gx0 = [10000000000, -999990, -999990, 3, 3];
    gy0 = [5, 5, 10000000000, 4, -1000000];
    gx1 = [9999000000, 10, 10, 10000, 13];
    gy1 = [5, 5, 9999999990, 1000004, 4];
    [first, last] = occgrid.fast.clip_ray(gx0, gy0, gx1, gy1, 20, 10);
    same(last([1, 3]) < first([1, 3]), [true, true]);
    same([first(2), last(2)], [999990, 1000000]);
    for i = 4:5
        [gx, gy] = occgrid.ray.bresenham(gx0(i), gy0(i), gx1(i), gy1(i));
        inside = find(gx >= 0 & gx < 20 & gy >= 0 & gy < 10) - 1;
        same([first(i), last(i)], [inside(1), inside(end)]);
    end
end

function too_long()
    raises(@() occgrid.fast.clip_ray(0, [0, 0], 2^20 + 1, [0, 0], 9, 9), ...
        'occgrid:ray', 'a line of more than 2^20 steps');
    [first, last] = occgrid.fast.clip_ray(0, 0, 2^20, 0, 9, 9);
    same([first, last], [0, 8]);
end
