function tests = test_lesson()
    % TEST_LESSON  The built-in lesson.
    tests = {@settings, @walls, @poses, @same_as_its_file};
end

function settings()
    s = occgrid.lesson.lesson_settings();
    same([s.width, s.height, s.beams], [220, 180, 181]);
    same([s.resolution, s.origin_x, s.origin_y, s.max_range], ...
        [0.1, -11, -9, 10]);
    same([s.p0, s.p_occ, s.p_free, s.l_min, s.l_max], ...
        [0.5, 0.75, 0.30, -8, 8]);
    same([s.fov, s.noise_std], [pi, 0.02]);
    same(s.no_return, 'free');
end

function walls()
    same(occgrid.lesson.lesson_world(), ...
        [-10, -8, 10, -8; 10, -8, 10, 8; 10, 8, -10, 8; -10, 8, -10, -8
         0, -6, 0, 6; -8, 2, -2, 2]);
end

function poses()
    p = occgrid.lesson.lesson_poses();
    same(size(p), [120, 3]);
    same(p(1, :), [0, 0, pi / 2]);
    same(p(61, :), [-12, 4 * occgrid.portable_math.sin(pi), pi + pi / 2]);
end

function same_as_its_file()
    here = fileparts(mfilename('fullpath'));
    file = fullfile(here, '..', '..', 'scenarios', 'lesson.log');
    if ~exist(file, 'file')
        skip('scenarios/lesson.log is not beside the port');
    end
    a = occgrid.scenario.read_scenario(file);
    b = occgrid.lesson.lesson_scenario();
    same(a.name, b.name);
    same(a.walls, b.walls);
    same(a.poses, b.poses);
    same(a.bearings, b.bearings);
    for name = fieldnames(b.settings)'
        same(a.settings.(name{1}), b.settings.(name{1}));
    end
end
