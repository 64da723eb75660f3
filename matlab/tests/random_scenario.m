function s = random_scenario()
    % RANDOM_SCENARIO  A small scenario with what is rare in others.
    %
    %   Robots outside the grid, hits in the robot's own cell, ranges one
    %   unit in the last place from max_range, poses on the edges of cells,
    %   evidence with its sign reversed, narrow limits, coordinates of 1e7 m;
    %   bare poses between recorded scans, with several sets of bearings.
    settings = occgrid.lesson.lesson_settings();
    settings.width = randi(25);
    settings.height = randi(25);
    settings.resolution = 0.1 * randi(9);
    far = (rand < 0.2) * 1e7 * [1, -1];
    settings.origin_x = far(1) - randi(9) / 4;
    settings.origin_y = far(2) - randi(9) / 4;
    settings.max_range = 1 + randi(5);
    odds = [0.3, 0.5, 0.75];
    if rand < 0.3
        odds = fliplr(odds); % free cells gain, hits lose
    end
    settings.p_free = odds(1) + 0.1 * rand;
    settings.p0 = odds(2);
    settings.p_occ = odds(3) + 0.1 * rand;
    limits = [1, 2, 8];
    settings.l_min = -limits(randi(3));
    settings.l_max = limits(randi(3));
    modes = {'free', 'ignore'};
    settings.no_return = modes{randi(2)};
    settings.beams = randi(30);
    settings.fov = 6 * rand;
    settings.noise_std = 0.3 * (rand < 0.7);
    walls = cell(randi(5), 1);
    for i = 1:numel(walls)
        ends = 8 * rand(1, 4) - 4;
        walls{i} = occgrid.world.segment( ...
            far(1) + ends(1), far(2) + ends(2), ...
            far(1) + ends(3), far(2) + ends(4));
    end
    bearings = {6 * rand(randi(20), 1) - 3, 0, 6 * rand(randi(20), 1) - 3};
    scans = cell(1, randi(12));
    for i = 1:numel(scans)
        at = 12 * rand(1, 2) - 6;
        if rand < 0.5
            at = round(at / settings.resolution) * settings.resolution;
        end
        pose = occgrid.world.pose(far(1) + at(1), far(2) + at(2), 7 * rand);
        angles = [];
        ranges = [];
        if rand < 0.7
            angles = bearings{randi(3)};
            ranges = 1.3 * settings.max_range * rand(size(angles));
            rare = settings.max_range * [1, 1 - eps / 2, 1 + eps, 0, ...
                                         1 - 1e-12 / settings.max_range];
            rare = [rare, NaN, Inf, 0.01]; %#ok<AGROW>
            odd = rand(size(angles)) < 0.4;
            ranges(odd) = rare(randi(numel(rare), nnz(odd), 1));
        end
        scans{i} = occgrid.sensor.scan(pose, angles, ranges);
    end
    s = occgrid.scenario.new_scenario( ...
        'random', settings, vertcat(walls{:}), [scans{:}]);
end
