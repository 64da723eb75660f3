classdef mapper
    % MAPPER  The mapping loop: scan after scan into the grid.
    %
    %   grid = occgrid.mapper.map_scenario(scenario, seed)
    %   scan = occgrid.mapper.simulated_scan(scenario, seed, pose, number)
    %
    %   The lesson's first flow chart.

    methods (Static)

        % [snippet: map-scenario]
        function grid = map_scenario(scenario, seed)
            % MAP_SCENARIO  Map all scans of a scenario.
            %
            %   scenario: as occgrid.scenario.read_scenario returns it; seed: 0
            %   to 2^32 - 1, or [] for simulated ranges without noise.
            settings = scenario.settings;
            grid = occgrid.scenario.new_grid(settings);
            for i = 1:numel(scenario.scans)
                scan = scenario.scans(i);
                if isempty(scan.ranges) % a bare pose
                    scan = occgrid.mapper.simulated_scan( ...
                        scenario, seed, scan.pose, i - 1);
                end
                grid = occgrid.sensor.update_grid_from_scan( ...
                    grid, scan, settings.max_range, settings.no_return);
            end
        end

        function scan = simulated_scan(scenario, seed, pose, number)
            % SIMULATED_SCAN  What the sensor reads at a pose, with noise.
            %
            %   number: the scan's, from 0; a row (1, m) for m poses side by
            %   side.
            settings = scenario.settings;
            angles = occgrid.sensor.beam_angles(settings.fov, settings.beams);
            ranges = occgrid.world.simulate_lidar_scan( ...
                pose, scenario.walls, angles, settings.max_range);
            if ~isempty(seed)
                ranges = occgrid.noise.add_range_noise( ...
                    ranges, settings.noise_std, seed, number, ...
                    settings.max_range);
            end
            scan = occgrid.sensor.scan(pose, angles, ranges);
        end

        % [/snippet]

    end
end
