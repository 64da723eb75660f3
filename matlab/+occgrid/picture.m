classdef picture
    % PICTURE  The lesson's picture (lesson section 6.4).
    %
    %   occgrid.picture.draw_map(map, file)
    %
    %   P(occupied) in colour, a colour bar, axes in metres.

    methods (Static)

        function draw_map(map, file)
            % DRAW_MAP  Draw the map into a PNG file; needs no display.
            %
            %   Raises occgrid:output.
            if exist('OCTAVE_VERSION', 'builtin')
                % the other toolkits want a display or OpenGL; Octave
                % warns that it is old
                before = warning('off', 'Octave:gnuplot-graphics');
                restores = onCleanup(@() warning(before));
                graphics_toolkit('gnuplot');
            end
            fig = figure('Visible', 'off');
            closes = onCleanup(@() close(fig));
            spec = map.spec;
            [x, y] = occgrid.grid.grid_to_world_center( ...
                map, [0, spec.width - 1], [0, spec.height - 1]);
            imagesc(x, y, occgrid.grid.probability_grid(map));
            axis('image');
            set(gca, 'YDir', 'normal');
            caxis([0, 1]);
            bar_ = colorbar();
            ylabel(bar_, 'P(occupied)');
            title('Occupancy Grid Map (probability)');
            xlabel('x [m]');
            ylabel('y [m]');

            path = occgrid.scenario.absolute(file);
            beside = [path, '.part.png'];
            id = fopen(beside, 'w'); % print would say more than one line
            if id < 0
                occgrid.map_writer.fail(file);
            end
            fclose(id);
            removes = onCleanup(@() occgrid.map_writer.remove({beside}));
            print(fig, beside, '-dpng', '-r150');
            occgrid.map_writer.rename_file(beside, path);
        end

    end
end
