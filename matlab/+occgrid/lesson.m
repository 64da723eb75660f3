classdef lesson
    % LESSON  The lesson, built in (lesson section 6).
    %
    %   settings = occgrid.lesson.lesson_settings()
    %   walls = occgrid.lesson.lesson_world()
    %   poses = occgrid.lesson.lesson_poses()
    %   s = occgrid.lesson.lesson_scenario()
    %
    %   A robot drives an ellipse in a box with two inner walls.

    methods (Static)

        % [snippet: lesson-settings]
        function settings = lesson_settings()
            % LESSON_SETTINGS  Grid, inverse sensor model, simulated sensor.
            settings.width = 220;
            settings.height = 180;
            settings.resolution = 0.1;
            settings.origin_x = -11;
            settings.origin_y = -9;
            settings.max_range = 10;
            settings.min_range = 0;
            settings.p0 = 0.5;
            settings.p_occ = 0.75;
            settings.p_free = 0.30;
            settings.l_min = -8;
            settings.l_max = 8;
            settings.no_return = 'free';
            settings.fov = pi;
            settings.beams = 181;
            settings.noise_std = 0.02;
        end

        % [/snippet]

        % [snippet: lesson-world]
        function walls = lesson_world()
            % LESSON_WORLD  A box of 20 m x 16 m with two walls in it.
            walls = [occgrid.world.build_box_world(-10, -8, 10, 8)
                     occgrid.world.add_vertical_wall(0, -6, 6)
                     occgrid.world.add_horizontal_wall(2, -8, -2)];
        end

        % [/snippet]

        % [snippet: lesson-poses]
        function poses = lesson_poses()
            % LESSON_POSES  120 poses on an ellipse, heading along it.
            %
            %   Side by side: x, y and theta are rows (1, 120).
            t = 0:119;
            ang = (2.0 .* pi) .* (t ./ 120);
            x = -6 + 6 .* occgrid.portable_math.cos(ang);
            y = 0 + 4 .* occgrid.portable_math.sin(ang);
            poses = occgrid.world.pose(x, y, ang + pi ./ 2);
        end

        % [/snippet]

        function s = lesson_scenario()
            % LESSON_SCENARIO  The lesson as a scenario, named lesson.
            poses = occgrid.lesson.lesson_poses();
            scans = cell(1, numel(poses.x));
            for i = 1:numel(scans)
                pose = occgrid.world.pose( ...
                    poses.x(i), poses.y(i), poses.theta(i));
                scans{i} = occgrid.sensor.scan(pose, [], []);
            end
            s = occgrid.scenario.new_scenario( ...
                'lesson', occgrid.lesson.lesson_settings(), ...
                occgrid.lesson.lesson_world(), [scans{:}]);
        end

    end
end
