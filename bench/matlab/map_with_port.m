function log_odds = map_with_port(work, batch, plain)
    % MAP_WITH_PORT  Log-odds (height, width) of the work, batch scans at once,
    % or scan after scan by the plain program.
    spec = occgrid.grid.grid_spec( ...
        work.width, work.height, work.resolution, ...
        work.origin_x, work.origin_y);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.30, -8, 8);
    count = size(work.poses, 1);
    scans = cell(1, count);
    for i = 1:count
        pose = occgrid.world.pose( ...
            work.poses(i, 1), work.poses(i, 2), work.poses(i, 3));
        scans{i} = occgrid.sensor.scan(pose, work.angles, work.ranges(:, i));
    end
    scans = [scans{:}];
    if plain
        for scan = scans
            map = occgrid.sensor.update_grid_from_scan( ...
                map, scan, work.max_range, 'free');
        end
    else
        for first = 1:batch:count
            numbers = first:min(first + batch - 1, count);
            map = occgrid.fast.update_grid_from_scans( ...
                map, scans(numbers), work.max_range, 'free');
        end
    end
    log_odds = map.log_odds;
end
