classdef picture
    % PICTURE  The lesson's picture (lesson section 6.4).
    %
    %   occgrid.picture.draw_map(grid, file)
    %
    %   P(occupied) in colour, a colour bar, axes in metres.

    methods (Static)

        function draw_map(grid, file)
            % DRAW_MAP  Draw the map into a PNG file; needs no display.
            %
            %   Raises occgrid:output, with the message FILE: cannot be
            %   written.
            file = char(file);
            if exist('OCTAVE_VERSION', 'builtin')
                % the other toolkits want a display or OpenGL; Octave
                % warns that it is old
                before = warning('off', 'Octave:gnuplot-graphics');
                restores = onCleanup(@() warning(before));
                graphics_toolkit('gnuplot');
            end
            fig = figure('Visible', 'off');
            closes = onCleanup(@() close(fig));
            spec = grid.spec;
            [x, y] = occgrid.grid.grid_to_world_center( ...
                grid, [0, spec.width - 1], [0, spec.height - 1]);
            imagesc(x, y, occgrid.grid.probability_grid(grid));
            axis('image');
            set(gca, 'YDir', 'normal', 'CLim', [0, 1]);
            bar_ = colorbar();
            ylabel(bar_, 'P(occupied)');
            title('Occupancy Grid Map (probability)');
            xlabel('x [m]');
            ylabel('y [m]');

            % first under a name that gnuplot understands, wherever the
            % picture is to stand
            drawn = [tempname(), '.png'];
            folder = fileparts(occgrid.files.absolute(file));
            beside = [folder, '/', occgrid.files.temporary_name()];
            removes = onCleanup(@() occgrid.files.remove({drawn, beside}));
            print(fig, drawn, '-dpng', '-r150');
            id = fopen(drawn, 'r');
            bytes = fread(id, [1, Inf], '*uint8');
            fclose(id);
            id = occgrid.files.open(beside, 'w');
            if id >= 0
                fwrite(id, bytes, 'uint8');
                fclose(id);
            end
            if occgrid.files.size_of(beside) ~= numel(bytes) || ...
                    ~occgrid.files.rename(beside, file)
                occgrid.map_writer.fail(file);
            end
        end

    end
end
