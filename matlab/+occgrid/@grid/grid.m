classdef grid
    % GRID  The grid of log-odds (lesson sections 1 and 3).
    %
    %   spec = occgrid.grid.grid_spec(width, height, resolution, ...
    %                                 origin_x, origin_y)
    %   map = occgrid.grid.occupancy_grid(spec, p0, p_occ, p_free, ...
    %                                     l_min, l_max)
    %   [gx, gy] = occgrid.grid.world_to_grid(map, x, y)
    %   [x, y] = occgrid.grid.grid_to_world_center(map, gx, gy)
    %   inside = occgrid.grid.in_bounds(map, gx, gy)
    %   map = occgrid.grid.update_cell(map, gx, gy, l_update)
    %   p = occgrid.grid.probability_grid(map)
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

        function map = occupancy_grid(spec, p0, p_occ, p_free, l_min, l_max)
            % OCCUPANCY_GRID  Log-odds of every cell, and what an update adds.
            %
            %   map.log_odds: (height, width); row 1 is the row with the
            %   smallest y. Every cell starts at l0 = logit(p0). l_min and
            %   l_max bound each cell after each update; l0 lies between them.
            %   The lesson's values: 0.5, 0.75, 0.30, -8, 8.
            map.spec = spec;
            map.l0 = occgrid.grid.logit(p0);
            map.l_occ = occgrid.grid.logit(p_occ);
            map.l_free = occgrid.grid.logit(p_free);
            map.l_min = l_min;
            map.l_max = l_max;
            map.log_odds = repmat(map.l0, spec.height, spec.width);
        end

        % [snippet: world-to-grid]
        function [gx, gy] = world_to_grid(map, x, y)
            % WORLD_TO_GRID  Cells of points in metres; also outside.
            spec = map.spec;
            gx = floor((x - spec.origin_x) ./ spec.resolution);
            gy = floor((y - spec.origin_y) ./ spec.resolution);
        end

        function [x, y] = grid_to_world_center(map, gx, gy)
            % GRID_TO_WORLD_CENTER  Centres of cells in metres.
            spec = map.spec;
            x = spec.origin_x + (gx + 0.5) .* spec.resolution;
            y = spec.origin_y + (gy + 0.5) .* spec.resolution;
        end

        function inside = in_bounds(map, gx, gy)
            % IN_BOUNDS  Whether cells lie in the grid.
            inside = 0 <= gx & gx < map.spec.width & ...
                0 <= gy & gy < map.spec.height;
        end

        % [/snippet]

        % [snippet: update-cell]
        function map = update_cell(map, gx, gy, l_update)
            % UPDATE_CELL  Add the evidence l_update - l0 to one cell, clamped.
            %
            %   A cell outside the grid is skipped.
            if occgrid.grid.in_bounds(map, gx, gy)
                value = map.log_odds(gy + 1, gx + 1) + (l_update - map.l0);
                value = min(max(value, map.l_min), map.l_max);
                map.log_odds(gy + 1, gx + 1) = value;
            end
        end

        % [/snippet]

        function map = update_cells(map, cells, order, occupied)
            % UPDATE_CELLS  update_cell for many cells, in order.
            %
            %   cells: (n, 1) linear indices of log_odds, any of them
            %   repeated; order: (n, 1) whole numbers from 0; occupied:
            %   (n, 1), l_occ where true and l_free elsewhere. The updates of
            %   one cell are applied in ascending order.
            %
            %   Cells are independent of each other: only the order of the
            %   updates of one cell counts, and not even that where they are
            %   all free. A loop over cells is slow in Octave; so the j-th
            %   updates of all cells are applied at once.
            if isempty(cells)
                return
            end
            % the part of the grid that is touched, for grids larger than
            % what a scan sees
            before = min(cells) - 1;
            cells = cells - before;
            window = max(cells);
            mixed = false(window, 1);
            mixed(cells(occupied)) = true;

            % most cells: free updates only, so that their number is enough
            free = map.l_free - map.l0;
            counts = accumarray(cells, 1, [window, 1]);
            touched = find(counts > 0 & ~mixed);
            counts = counts(touched);
            values = reshape(map.log_odds(touched + before), [], 1);
            left = (1:numel(touched))';
            j = 0;
            while ~isempty(left)
                old = values(left);
                new = min(max(old + free, map.l_min), map.l_max);
                values(left) = new;
                j = j + 1;
                % an update that changed nothing would change nothing again
                left = left(counts(left) > j & new ~= old);
            end
            map.log_odds(touched + before) = values;

            % cells with a hit among the updates: sorted by cell, in order
            % within it
            i = find(mixed(cells));
            if isempty(i)
                return
            end
            [~, by_cell] = sort(cells(i) .* (max(order) + 1) + order(i));
            i = i(by_cell);
            cells = cells(i);
            steps = repmat(free, numel(i), 1);
            steps(occupied(i)) = map.l_occ - map.l0;
            starts = find([true; diff(cells) ~= 0]);
            counts = diff([starts; numel(cells) + 1]);
            [counts, most_first] = sort(counts, 'descend');
            starts = starts(most_first);
            touched = cells(starts) + before;
            values = reshape(map.log_odds(touched), [], 1);
            % how many cells have a j-th update, j = 1, 2, ...
            reached = flipud(cumsum(flipud(accumarray(counts, 1))));
            for j = 1:numel(reached)
                head = 1:reached(j);
                new = values(head) + steps(starts(head) + j - 1);
                values(head) = min(max(new, map.l_min), map.l_max);
            end
            map.log_odds(touched) = values;
        end

        % [snippet: probability-grid]
        function p = probability_grid(map)
            % PROBABILITY_GRID  P(occupied) of every cell, (height, width).
            p = occgrid.grid.sigmoid(map.log_odds);
        end

        % [/snippet]

    end
end
