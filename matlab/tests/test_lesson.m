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
    w = occgrid.lesson.lesson_world();
    same([[w.x0]', [w.y0]', [w.x1]', [w.y1]'], ...
        [-10, -8, 10, -8; 10, -8, 10, 8; 10, 8, -10, 8; -10, 8, -10, -8
         0, -6, 0, 6; -8, 2, -2, 2]);
end

function poses()
    p = occgrid.lesson.lesson_poses();
    same(size(p.theta), [1, 120]);
    same([p.x(1), p.y(1), p.theta(1)], [0, 0, pi / 2]);
    same([p.x(61), p.y(61), p.theta(61)], ...
        [-12, 4 * occgrid.portable_math.sin(pi), pi + pi / 2]);
end

function same_as_its_file()
    here = fileparts(mfilename('fullpath'));
    file = fullfile(here, '..', '..', 'scenarios', 'lesson.log');
    if ~exist(file, 'file')
        skip('scenarios/lesson.log is not beside the port');
    end
    a = occgrid.scenario.read_scenario(file);
    b = occgrid.lesson.lesson_scenario();
    same(isequal(a, b), true);
    same(fieldnames(a.settings), fieldnames(b.settings));
end
