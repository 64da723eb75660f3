function tests = test_mapper()
    % TEST_MAPPER  Scan after scan into the grid.
    tests = {@definition, @mapped_again, @noise_free, @seeds_differ};
end

function s = mixed_scans()
    % recorded scans with two sets of bearings, and simulated ones
    s = occgrid.lesson.lesson_scenario();
    scan = @(x, y, theta, angles, ranges) occgrid.sensor.scan( ...
        occgrid.world.pose(x, y, theta), angles, ranges);
    s.scans = [scan(0, 0, 0, [-0.5; 0; 0.5], [1; NaN; 2]), s.scans(1:3), ...
               scan(-3, 1, 2, [0.1; 0.2], [4; 12]), s.scans(9), ...
               scan(-3, 1, 2, [0.1; 0.2], [3; 3])];
end

function definition()
    s = mixed_scans();
    grid = occgrid.scenario.new_grid(s.settings);
    for i = 1:numel(s.scans)
        scan = s.scans(i);
        if isempty(scan.ranges)
            scan.angles = occgrid.sensor.beam_angles(pi, 181);
            scan.ranges = occgrid.world.simulate_lidar_scan( ...
                scan.pose, s.walls, scan.angles, 10);
            % scans are numbered alike, simulated and recorded
            scan.ranges = occgrid.noise.add_range_noise( ...
                scan.ranges, 0.02, 9, i - 1, 10);
        end
        grid = occgrid.sensor.update_grid_from_scan(grid, scan, 10, 'free');
    end
    mapped = occgrid.mapper.map_scenario(s, 9);
    same(mapped.log_odds, grid.log_odds);
end

function mapped_again()
    % noise-free, then with noise, then noise-free again
    for map_scenario = {@occgrid.mapper.map_scenario, ...
                        @occgrid.fast.map_scenario_fast}
        s = mixed_scans();
        first = map_scenario{1}(s, []);
        noisy = map_scenario{1}(s, 7);
        again = map_scenario{1}(s, []);
        assert(nnz(first.log_odds) > 100);
        same(again.log_odds, first.log_odds);
        assert(~isequal(noisy.log_odds, first.log_odds));
    end
end

function noise_free()
    s = mixed_scans();
    a = occgrid.mapper.map_scenario(s, []);
    s.settings.noise_std = 0;
    b = occgrid.mapper.map_scenario(s, 1);
    same(a.log_odds, b.log_odds);
end

function seeds_differ()
    s = mixed_scans();
    a = occgrid.mapper.map_scenario(s, 0);
    b = occgrid.mapper.map_scenario(s, 1);
    assert(~isequal(a.log_odds, b.log_odds));
end
