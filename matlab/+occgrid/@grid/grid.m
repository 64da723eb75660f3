classdef grid
    % GRID  The grid of log-odds (lesson sections 1 and 3).
    %
    %   spec = occgrid.grid.grid_spec(width, height, resolution, ...
    %                                 origin_x, origin_y)
    %   l = occgrid.grid.logit(p)
    %   p = occgrid.grid.sigmoid(log_odds)
    %   grid = occgrid.grid.occupancy_grid(spec, p0, p_occ, p_free, ...
    %                                      l_min, l_max)
    %   [gx, gy] = occgrid.grid.world_to_grid(grid, x, y)
    %   [x, y] = occgrid.grid.grid_to_world_center(grid, gx, gy)
    %   inside = occgrid.grid.in_bounds(grid, gx, gy)
    %   grid = occgrid.grid.update_cell(grid, gx, gy, l_update)
    %   grid = occgrid.grid.update_cells(grid, gx, gy, l_update)
    %   p = occgrid.grid.probability_grid(grid)
    %
    %   A grid is a struct, so it is a value: an update returns the grid with
    %   the update in it, and leaves every other grid as it was.
    %
    %   Cells are numbered from 0, as in the lesson; only the array log_odds
    %   is indexed from 1. This class has a folder of its own because Octave
    %   warns of a file ../grid.m that it hides Octave's own grid.

    methods (Static)

        % [snippet: grid-spec]
        function spec = grid_spec( ...
                width, height, resolution, origin_x, origin_y)
            % GRID_SPEC  Where the cells lie in the world (lesson section 1).
            spec.width = width; % number of columns
            spec.height = height; % number of rows
            spec.resolution = resolution; % side of a cell, m
            spec.origin_x = origin_x; % world x of the lower left corner, m
            spec.origin_y = origin_y; % world y of the lower left corner, m
        end

        % [/snippet]

        % [snippet: logit]
        function l = logit(p)
            % LOGIT  Log-odds of probabilities, kept in [1e-9, 1 - 1e-9].
            q = min(max(p, 1e-9), 1 - 1e-9);
            l = occgrid.portable_math.log(q ./ (1 - q));
        end

        % [/snippet]

        % [snippet: sigmoid]
        function p = sigmoid(log_odds)
            % SIGMOID  Probability of log-odds, of any shape; no overflow.
            z = occgrid.portable_math.exp(-abs(log_odds));
            p = z ./ (1 + z);
            upper = log_odds >= 0;
            p(upper) = 1 ./ (1 + z(upper));
        end

        % [/snippet]

        function grid = occupancy_grid(spec, p0, p_occ, p_free, l_min, l_max)
            % OCCUPANCY_GRID  Log-odds of every cell, and what an update adds.
            %
            %   grid.log_odds: (height, width); row 1 is the row with the
            %   smallest y. Every cell starts at l0 = logit(p0). l_min and
            %   l_max bound each cell after each update; l0 lies between them.
            %   The lesson's values: 0.5, 0.75, 0.30, -8, 8.
            grid.spec = spec;
            grid.l0 = occgrid.grid.logit(p0);
            grid.l_occ = occgrid.grid.logit(p_occ);
            grid.l_free = occgrid.grid.logit(p_free);
            grid.l_min = l_min;
            grid.l_max = l_max;
            grid.log_odds = repmat(grid.l0, spec.height, spec.width);
        end

        % [snippet: world-to-grid]
        function [gx, gy] = world_to_grid(grid, x, y)
            % WORLD_TO_GRID  Cells of points in metres; also outside.
            spec = grid.spec;
            gx = floor((x - spec.origin_x) ./ spec.resolution);
            gy = floor((y - spec.origin_y) ./ spec.resolution);
        end

        function inside = in_bounds(grid, gx, gy)
            % IN_BOUNDS  Whether cells lie in the grid.
            inside = 0 <= gx & gx < grid.spec.width & ...
                0 <= gy & gy < grid.spec.height;
        end

        % [/snippet]

        function [x, y] = grid_to_world_center(grid, gx, gy)
            % GRID_TO_WORLD_CENTER  Centres of cells in metres.
            spec = grid.spec;
            x = spec.origin_x + (gx + 0.5) .* spec.resolution;
            y = spec.origin_y + (gy + 0.5) .* spec.resolution;
        end

        % [snippet: update-cell]
        function grid = update_cell(grid, gx, gy, l_update)
            % UPDATE_CELL  Add the evidence l_update - l0 to one cell, clamped.
            %
            %   A cell outside the grid is skipped.
            if occgrid.grid.in_bounds(grid, gx, gy)
                value = grid.log_odds(gy + 1, gx + 1) + (l_update - grid.l0);
                value = min(max(value, grid.l_min), grid.l_max);
                grid.log_odds(gy + 1, gx + 1) = value;
            end
        end

        function grid = update_cells(grid, gx, gy, l_update)
            % UPDATE_CELLS  The same for several cells, no cell twice.
            %
            %   gx, gy: of one shape. A cell outside the grid is skipped.
            inside = occgrid.grid.in_bounds(grid, gx, gy);
            cells = gx(inside) .* grid.spec.height + gy(inside) + 1;
            values = grid.log_odds(cells) + (l_update - grid.l0);
            values = min(max(values, grid.l_min), grid.l_max);
            grid.log_odds(cells) = values;
        end

        % [/snippet]

        % [snippet: probability-grid]
        function p = probability_grid(grid)
            % PROBABILITY_GRID  P(occupied) of every cell, (height, width).
            p = occgrid.grid.sigmoid(grid.log_odds);
        end

        % [/snippet]

    end
end
