classdef mapper
    % MAPPER  The mapping loop: scan after scan into the grid.
    %
    %   map = occgrid.mapper.map_scenario(s, seed)
    %
    %   The lesson's first flow chart.

    methods (Static)

        % [snippet: map-scenario]
        function map = map_scenario(s, seed)
            % MAP_SCENARIO  Map all scans of a scenario.
            %
            %   s: as occgrid.scenario.read_scenario returns it; seed: 0 to
            %   2^32 - 1, or [] for simulated ranges without noise.
            settings = s.settings;
            map = occgrid.scenario.new_grid(settings);
            first = 1;
            while first <= numel(s.bearings)
                last = occgrid.mapper.last_of_batch(s, first);
                scan = occgrid.mapper.simulated_scan(s, seed, first:last);
                map = occgrid.sensor.update_grid_from_scan( ...
                    map, scan, settings.max_range, settings.no_return);
                first = last + 1;
            end
        end

        function scan = simulated_scan(s, seed, numbers)
            % SIMULATED_SCAN  Scans of a scenario that have the same bearings.
            %
            %   A bare pose is simulated, with noise.
            settings = s.settings;
            scan.pose = s.poses(numbers, :);
            bearings = s.bearings(numbers(1));
            if bearings > 0
                scan.angles = s.angles{bearings};
                scan.ranges = [s.ranges{numbers}];
                return
            end
            scan.angles = occgrid.sensor.beam_angles( ...
                settings.fov, settings.beams);
            scan.ranges = occgrid.world.simulate_lidar_scan( ...
                scan.pose, s.walls, scan.angles, settings.max_range);
            if ~isempty(seed)
                scan.ranges = occgrid.noise.add_range_noise( ...
                    scan.ranges, settings.noise_std, seed, numbers - 1, ...
                    settings.max_range);
            end
        end

        % [/snippet]

        function last = last_of_batch(s, first)
            % LAST_OF_BATCH  Up to which scan scans are traced together.
            %
            %   They have the same bearings and, for the memory's sake, about
            %   8192 beams.
            bearings = s.bearings(first);
            if bearings > 0
                beams = numel(s.angles{bearings});
            else
                beams = s.settings.beams;
            end
            last = min(first + ceil(8192 / beams) - 1, numel(s.bearings));
            other = find(s.bearings(first:last) ~= bearings, 1);
            if ~isempty(other)
                last = first + other - 2;
            end
        end

    end
end
