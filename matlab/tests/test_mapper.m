function tests = test_mapper()
    % TEST_MAPPER  Scan after scan into the grid.
    tests = {@definition, @noise_free, @seeds_differ, @recorded};
end

function s = short_lesson(scans)
    s = occgrid.lesson.lesson_scenario();
    s.poses = s.poses(1:scans, :);
    s.bearings = s.bearings(1:scans);
    s.ranges = s.ranges(1:scans);
end

function definition()
    % one scan at a time is the same as many together
    s = short_lesson(60);
    angles = occgrid.sensor.beam_angles(pi, 181);
    map = occgrid.scenario.new_grid(s.settings);
    for i = 1:60
        ranges = occgrid.world.simulate_lidar_scan( ...
            s.poses(i, :), s.walls, angles, 10);
        ranges = occgrid.noise.add_range_noise(ranges, 0.02, 5, i - 1, 10);
        scan = struct('pose', s.poses(i, :), 'angles', angles, ...
            'ranges', ranges);
        map = occgrid.sensor.update_grid_from_scan(map, scan, 10, 'free');
    end
    together = occgrid.mapper.map_scenario(s, 5);
    same(together.log_odds, map.log_odds);
end

function noise_free()
    s = short_lesson(3);
    a = occgrid.mapper.map_scenario(s, []);
    s.settings.noise_std = 0;
    b = occgrid.mapper.map_scenario(s, 1);
    same(a.log_odds, b.log_odds);
end

function seeds_differ()
    s = short_lesson(3);
    a = occgrid.mapper.map_scenario(s, 0);
    b = occgrid.mapper.map_scenario(s, 1);
    assert(~isequal(a.log_odds, b.log_odds));
end

function s = recorded_scans()
    % scans of two kinds of bearings and a simulated one
    s = short_lesson(1);
    s.poses = [0, 0, 0; -3, 1, 2; 1, 1, 1; -3, 1, 2];
    s.bearings = [1; 2; 0; 2];
    s.ranges = {[1; NaN; 2]; [4; 12]; []; [3; 3]};
    s.angles = {[-0.5; 0; 0.5], [0.1; 0.2]};
end

function recorded()
    s = recorded_scans();
    map = occgrid.scenario.new_grid(s.settings);
    for i = 1:4
        if s.bearings(i) > 0
            scan.angles = s.angles{s.bearings(i)};
            scan.ranges = s.ranges{i};
        else
            scan.angles = occgrid.sensor.beam_angles(pi, 181);
            scan.ranges = occgrid.world.simulate_lidar_scan( ...
                s.poses(i, :), s.walls, scan.angles, 10);
            % scans are numbered alike, simulated and recorded
            scan.ranges = occgrid.noise.add_range_noise( ...
                scan.ranges, 0.02, 9, i - 1, 10);
        end
        scan.pose = s.poses(i, :);
        map = occgrid.sensor.update_grid_from_scan(map, scan, 10, 'free');
    end
    together = occgrid.mapper.map_scenario(s, 9);
    same(together.log_odds, map.log_odds);
end
