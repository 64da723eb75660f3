function tests = test_world()
    % TEST_WORLD  Walls and what a ray meets.
    tests = {@box, @walls, @hits, @ends_of_a_wall, @misses, @parallel, ...
             @several_rays, @nearest_wall, @nothing_in_range, @several_poses};
end

function box()
    same(occgrid.world.build_box_world(-1, -2, 3, 4), ...
        [-1, -2, 3, -2; 3, -2, 3, 4; 3, 4, -1, 4; -1, 4, -1, -2]);
end

function walls()
    same(occgrid.world.add_vertical_wall(1, -2, 3), [1, -2, 1, 3]);
    same(occgrid.world.add_horizontal_wall(1, -2, 3), [-2, 1, 3, 1]);
end

function t = ray(varargin)
    t = occgrid.world.ray_segment_intersection(varargin{:});
end

function hits()
    same(ray(0, 0, 1, 0, [2, -1, 2, 1]), 2);
    same(ray(0, 0, 1, 0, [2, 1, 2, -1]), 2);
    same(ray(1, 1, 0, -1, [-5, -3, 5, -3]), 4);
    same(ray(2, 0, 1, 0, [2, -1, 2, 1]), 0);
end

function ends_of_a_wall()
    same(ray(0, 1, 1, 0, [2, -1, 2, 1]), 2);
    same(ray(0, -1, 1, 0, [2, -1, 2, 1]), 2);
end

function misses()
    same(ray(0, 0, -1, 0, [2, -1, 2, 1]), Inf); % behind
    same(ray(0, 1.001, 1, 0, [2, -1, 2, 1]), Inf); % beside
end

function parallel()
    same(ray(0, 0, 1, 0, [2, 0, 3, 0]), Inf);
    same(ray(0, 0, 1, 0, [2, 1, 3, 1]), Inf);
    same(ray(0, 0, 1, 0, [0, -2e-13, 1, 3e-13]), Inf); % |rxs| below 1e-12
    same(ray(0, 0, 1, 0, [0, -2e-12, 1, 2e-12]), 0.5); % and above
    same(ray(0, 0, 1, 0, [3, 3, 3, 3]), Inf); % a wall without length
end

function several_rays()
    same(ray(0, 0, [1; 0; -1], [0; 1; 0], [2, -1, 2, 1]), [2; Inf; Inf]);
end

function nearest_wall()
    walls_ = [5, -1, 5, 1; 2, -1, 2, 1; 3, -1, 3, 1];
    same(occgrid.world.simulate_lidar_scan([0, 0, 0], walls_, 0, 10), 2);
    % bearings count from the heading
    same(occgrid.world.simulate_lidar_scan([1, 0, 1], walls_, -1, 10), 1);
end

function nothing_in_range()
    wall = [2, -1, 2, 1];
    same(occgrid.world.simulate_lidar_scan([0, 0, 0], wall, [0; 3], 1.5), ...
        [1.5; 1.5]);
    same(occgrid.world.simulate_lidar_scan([0, 0, 0], wall, 0, 2), 2);
    same(occgrid.world.simulate_lidar_scan( ...
        [0, 0, 0], zeros(0, 4), [0; 1], 7), [7; 7]);
end

function several_poses()
    walls_ = occgrid.lesson.lesson_world();
    poses = occgrid.lesson.lesson_poses();
    angles = occgrid.sensor.beam_angles(pi, 181);
    together = occgrid.world.simulate_lidar_scan( ...
        poses(1:5, :), walls_, angles, 10);
    for i = 1:5
        same(together(:, i), occgrid.world.simulate_lidar_scan( ...
            poses(i, :), walls_, angles, 10));
    end
end
