function log_odds = map_with_port(work, batch)
    % MAP_WITH_PORT  Log-odds (height, width) of the work, batch scans at once.
    spec = occgrid.grid.grid_spec( ...
        work.width, work.height, work.resolution, ...
        work.origin_x, work.origin_y);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.30, -8, 8);
    scan.angles = work.angles;
    scans = size(work.poses, 1);
    for first = 1:batch:scans
        numbers = first:min(first + batch - 1, scans);
        scan.pose = work.poses(numbers, :);
        scan.ranges = work.ranges(:, numbers);
        map = occgrid.sensor.update_grid_from_scan( ...
            map, scan, work.max_range, 'free');
    end
    log_odds = map.log_odds;
end
