function tests = test_world()
    % TEST_WORLD  Walls and what a ray meets.
    tests = {@box, @walls, @hits, @ends_of_a_wall, @misses, @parallel, ...
             @several_rays, @nearest_wall, @nothing_in_range, @several_poses};
end

function box()
    same(numbers(occgrid.world.build_box_world(-1, -2, 3, 4)), ...
        [-1, -2, 3, -2; 3, -2, 3, 4; 3, 4, -1, 4; -1, 4, -1, -2]);
end

function walls()
    same(numbers(occgrid.world.add_vertical_wall(1, -2, 3)), [1, -2, 1, 3]);
    same(numbers(occgrid.world.add_horizontal_wall(1, -2, 3)), [-2, 1, 3, 1]);
end

function v = numbers(walls_)
    v = [[walls_.x0]', [walls_.y0]', [walls_.x1]', [walls_.y1]'];
end

function walls_ = segments(v)
    % walls with these ends, one row each
    walls_ = cell(size(v, 1), 1);
    for i = 1:size(v, 1)
        walls_{i} = occgrid.world.segment(v(i, 1), v(i, 2), v(i, 3), v(i, 4));
    end
    walls_ = vertcat(walls_{:});
end

function t = ray(rx, ry, rdx, rdy, wall)
    t = occgrid.world.ray_segment_intersection( ...
        rx, ry, rdx, rdy, segments(wall));
end

function ranges = scan(pose, walls_, angles, z_max)
    ranges = occgrid.world.simulate_lidar_scan( ...
        occgrid.world.pose(pose(1), pose(2), pose(3)), ...
        segments(walls_), angles, z_max);
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
    same(scan([0, 0, 0], walls_, 0, 10), 2);
    % bearings count from the heading
    same(scan([1, 0, 1], walls_, -1, 10), 1);
end

function nothing_in_range()
    wall = [2, -1, 2, 1];
    same(scan([0, 0, 0], wall, [0; 3], 1.5), ...
        [1.5; 1.5]);
    same(scan([0, 0, 0], wall, 0, 2), 2);
    same(scan( ...
        [0, 0, 0], zeros(0, 4), [0; 1], 7), [7; 7]);
end

function several_poses()
    walls_ = occgrid.lesson.lesson_world();
    poses = occgrid.lesson.lesson_poses();
    angles = occgrid.sensor.beam_angles(pi, 181);
    together = occgrid.world.simulate_lidar_scan(poses, walls_, angles, 10);
    same(size(together), [181, 120]);
    for i = [1, 2, 77, 120]
        pose = occgrid.world.pose(poses.x(i), poses.y(i), poses.theta(i));
        same(together(:, i), occgrid.world.simulate_lidar_scan( ...
            pose, walls_, angles, 10));
    end
end
