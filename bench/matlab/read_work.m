function work = read_work(file)
    % READ_WORK  Poses and ranges that every contestant maps.
    %
    %   angles (n, 1); poses (m, 3); ranges (n, m); metres, radians.
    id = fopen(file, 'r');
    head = fscanf(id, '%f', 8);
    beams = head(8);
    work.width = head(1);
    work.height = head(2);
    work.resolution = head(3);
    work.origin_x = head(4);
    work.origin_y = head(5);
    work.max_range = head(6);
    work.angles = fscanf(id, '%f', beams);
    scans = fscanf(id, '%f', [beams + 3, head(7)]);
    fclose(id);
    work.poses = scans(1:3, :)';
    work.ranges = scans(4:end, :);
end
