classdef fast
    % FAST  The same maps in a fraction of the time: many beams at once.
    %
    %   [first, last] = occgrid.fast.clip_ray( ...
    %       gx0, gy0, gx1, gy1, width, height)
    %   grid = occgrid.fast.update_grid_from_scans( ...
    %       grid, scans, z_max, no_return)
    %   grid = occgrid.fast.map_scenario_fast(s, seed)
    %
    %   An interpreter spends its time on the number of operations, not on the
    %   length of the arrays in them. The plain path needs some forty
    %   operations for each beam; here a few hundred do for thousands of
    %   beams. Every bit is that of occgrid.mapper.map_scenario, because each
    %   cell gets the same updates in the same order.

    methods (Static)

        % [snippet: clip-ray]
        function [first, last] = clip_ray(gx0, gy0, gx1, gy1, width, height)
            % CLIP_RAY  First and last step of each line inside the grid.
            %
            %   A line that misses the grid gets last < first. gx0, gy0, gx1,
            %   gy1: arrays of one shape. More than 2^20 steps: occgrid:ray.
            %
            %   Cells outside the grid are skipped, so they need not be found:
            %   step k has gone m cells along the shorter axis, or more,
            %   exactly when 2 k b >= 2 a m - a + 1. The line from (-6, 0) to
            %   (2, 4) has a = 8 and b = 4. In a grid of 10 by 2 cells its
            %   longer axis is inside from step 6 on, its shorter one only
            %   before it has gone m = 2, at step ceil(25 / 8) = 4. So the
            %   line misses the grid, and no cell of it was looked at.
            dx = abs(gx1 - gx0);
            dy = abs(gy1 - gy0);
            a = max(dx, dy);
            b = min(dx, dy);
            if any(a(:) > 2^20)
                error('occgrid:ray', 'a line of more than 2^20 steps');
            end
            % steps that each axis may go: low <= step <= high
            [low, high] = occgrid.fast.steps_inside(gx0, gx1, width);
            [m_low, m_high] = occgrid.fast.steps_inside(gy0, gy1, height);
            along_y = dx < dy;
            [low(along_y), m_low(along_y)] = ...
                deal(m_low(along_y), low(along_y));
            [high(along_y), m_high(along_y)] = ...
                deal(m_high(along_y), high(along_y));
            enters = occgrid.fast.first_step(m_low, a, b);
            leaves = occgrid.fast.first_step(m_high + 1, a, b);
            first = max(max(low, 0), enters);
            last = min(min(high, a), leaves - 1);
        end

        function [low, high] = steps_inside(g0, g1, size_)
            % fewest and most cells to go from g0 towards g1 to be in
            % 0 .. size_ - 1
            low = g0 - (size_ - 1);
            high = g0;
            forward = g0 < g1;
            low(forward) = 0 - g0(forward);
            high(forward) = (size_ - 1) - g0(forward);
        end

        function k = first_step(m, a, b)
            % the first step that has gone m cells along the shorter axis;
            % a + 1 where none does. (Products above 2^53, of a robot far
            % from the grid, are not exact: they are among the latter.)
            k = ceil((2 .* a .* m - a + 1) ./ max(2 .* b, 1));
            k(m > b) = a(m > b) + 1;
            k(m <= 0) = 0;
        end

        % [/snippet]

        % [snippet: update-grid-from-scans]
        function grid = update_grid_from_scans(grid, scans, z_max, no_return)
            % UPDATE_GRID_FROM_SCANS  The inverse sensor model, many scans.
            %
            %   scans: a struct array of scans (see occgrid.sensor.scan), in
            %   order; z_max, no_return: as for update_grid_from_scan.
            for batch = occgrid.fast.batches(scans, 0)
                scan = occgrid.fast.side_by_side(scans(batch{1}));
                grid = occgrid.fast.update_batch( ...
                    grid, scan, z_max, no_return);
            end
        end

        function grid = update_batch(grid, scan, z_max, no_return)
            % scans side by side: pose (1, m), ranges (n, m)
            [z, hit, used] = occgrid.sensor.read_ranges( ...
                scan.ranges, z_max, no_return);
            [ex, ey] = occgrid.sensor.beam_endpoints( ...
                scan.pose, scan.angles, z);
            [gx0, gy0] = occgrid.grid.world_to_grid( ...
                grid, scan.pose.x, scan.pose.y);
            [gx1, gy1] = occgrid.grid.world_to_grid(grid, ex, ey);
            % from here on rows, an element per beam, in the beams' order
            gx0 = occgrid.fast.chosen(gx0 + zeros(size(z)), used);
            gy0 = occgrid.fast.chosen(gy0 + zeros(size(z)), used);
            gx1 = occgrid.fast.chosen(gx1, used);
            gy1 = occgrid.fast.chosen(gy1, used);
            hit = occgrid.fast.chosen(hit, used);
            [first, last] = occgrid.fast.clip_ray( ...
                gx0, gy0, gx1, gy1, grid.spec.width, grid.spec.height);
            counts = max(last - first + 1, 0);
            for run = occgrid.fast.runs(counts)
                pieces = occgrid.fast.pieces(run{1}, counts);
                cells = cell(size(pieces));
                beams = cell(size(pieces));
                occupied = cell(size(pieces));
                for i = 1:numel(pieces)
                    j = pieces{i};
                    [gx, gy, k, column] = occgrid.fast.trace( ...
                        gx0(j), gy0(j), gx1(j), gy1(j), first(j), last(j));
                    cells{i} = gx .* grid.spec.height + gy + 1;
                    beams{i} = reshape(j(column), [], 1);
                    a = max(abs(gx1(j) - gx0(j)), abs(gy1(j) - gy0(j)));
                    at_end = k == reshape(a(column), [], 1);
                    occupied{i} = at_end & reshape(hit(j(column)), [], 1);
                end
                grid = occgrid.fast.update_in_order( ...
                    grid, vertcat(cells{:}), vertcat(beams{:}), ...
                    vertcat(occupied{:}));
            end
        end

        % [/snippet]

        function grid = map_scenario_fast(scenario, seed, progress)
            % MAP_SCENARIO_FAST  Map all scans of a scenario, many at once.
            %
            %   scenario, seed: as for occgrid.mapper.map_scenario. progress: a
            %   function that is called with the number of scans mapped so
            %   far, now and then; may be left out.
            settings = scenario.settings;
            grid = occgrid.scenario.new_grid(settings);
            for batch = occgrid.fast.batches(scenario.scans, settings.beams)
                numbers = batch{1};
                scan = occgrid.fast.side_by_side(scenario.scans(numbers));
                if isempty(scan.ranges)
                    scan = occgrid.mapper.simulated_scan( ...
                        scenario, seed, scan.pose, numbers - 1);
                end
                grid = occgrid.fast.update_batch( ...
                    grid, scan, settings.max_range, settings.no_return);
                if nargin > 2
                    progress(numbers(end));
                end
            end
        end

    end

    methods (Static, Access = private)

        function b = batches(scans, beams_of_pose)
            % the numbers of the scans in a row of cells, such scans together
            % that can stand side by side: with the same bearings, or bare
            % poses, and with about 8192 beams, which bounds the memory. 120
            % scans of 181 beams are three batches, of 46, 46 and 28 scans.
            new_batch = false(1, numel(scans));
            size_ = Inf;
            angles = [];
            for i = 1:numel(scans)
                other = scans(i).angles;
                same = numel(other) == numel(angles) && all(other == angles);
                if size_ >= 8192 || ~same
                    new_batch(i) = true;
                    angles = other;
                    size_ = 0;
                end
                size_ = size_ + max(numel(other), ...
                                    isempty(other) * beams_of_pose);
            end
            b = occgrid.fast.split(1:numel(scans), new_batch(2:end));
        end

        function scan = side_by_side(scans)
            % scans of the same bearings as one: pose (1, m), ranges (n, m)
            poses = [scans.pose];
            pose = occgrid.world.pose([poses.x], [poses.y], [poses.theta]);
            scan = occgrid.sensor.scan( ...
                pose, scans(1).angles, [scans.ranges]);
        end

        function row = chosen(values, used)
            % the values of the beams in use, as a row
            row = reshape(values(used), 1, []);
        end

        function r = runs(counts)
            % the beams that have cells in the grid, in order, in runs of
            % about 2^20 cells: bounds the memory of an update, whatever the
            % scans are. Counts of 2^19, 2^19, 0 and 9 give {[1, 2], 4}.
            beams = find(counts > 0);
            n = counts(beams);
            run = floor((cumsum(n) - n) ./ 2^20);
            r = occgrid.fast.split(beams, diff(run) ~= 0);
        end

        function p = pieces(beams, counts)
            % the beams of a run in pieces that are traced side by side: of
            % about 2^15 cells, which fit the processor's cache, and of
            % similar length, because trace spends the time of the longest
            % line on each. Counts of 5, 70, 6 and 100 give {[1, 3], [2, 4]}:
            % from 4 to 7 and from 64 to 127 cells.
            [n, by_length] = sort(counts(beams));
            piece = floor((cumsum(n) - n) ./ 2^15);
            power = floor(log2(n));
            p = occgrid.fast.split(beams(by_length), ...
                                   diff(piece) ~= 0 | diff(power) ~= 0);
        end

        function c = split(items, cut_after)
            % a row vector cut into a row of cells
            if isempty(items)
                c = {};
            else
                ends = [find(cut_after), numel(items)];
                c = mat2cell(items, 1, diff([0, ends]));
            end
        end

        function [gx, gy, k, column] = trace(gx0, gy0, gx1, gy1, first, last)
            % the cells of lines from step first to step last, line by line
            %
            %   All arguments: (1, n). gx, gy: columns; k: the step of each
            %   cell, column: the line that it is of. It is bresenham's
            %   closed form on a table with a column for each line:
            %
            %       first, last     2, 4    0, 1
            %       k               2       0
            %                       3       1
            %                       4       (2, past last: left out)
            %
            %   Cells outside the grid are left out before an index is made
            %   of them, so that every number is exact.
            k = first + (0:max(last - first))';
            column = repmat(1:numel(first), size(k, 1), 1);
            inside = k <= last;
            dx = abs(gx1 - gx0);
            dy = abs(gy1 - gy0);
            sx = 2 .* (gx0 < gx1) - 1;
            sy = 2 .* (gy0 < gy1) - 1;
            a = max(max(dx, dy), 1);
            b = min(dx, dy);
            minor = floor((2 .* k .* b + (a - 1)) ./ (2 .* a));
            along_x = dx >= dy;
            gx = gx0 + (sx .* along_x) .* k + (sx .* ~along_x) .* minor;
            gy = gy0 + (sy .* ~along_x) .* k + (sy .* along_x) .* minor;
            gx = reshape(gx(inside), [], 1);
            gy = reshape(gy(inside), [], 1);
            k = reshape(k(inside), [], 1);
            column = reshape(column(inside), [], 1);
        end

        function grid = update_in_order(grid, cells, order, occupied)
            % update_cell for many cells, in order
            %
            %   cells: (n, 1) linear indices of log_odds, any of them
            %   repeated; order: (n, 1) whole numbers from 0; occupied:
            %   (n, 1), l_occ where true and l_free elsewhere. The updates of
            %   one cell are applied in ascending order.
            %
            %   Cells are independent of each other: only the order of the
            %   updates of one cell counts. So the first updates of all cells
            %   are applied at once, then the second ones, and so on:
            %
            %       order    0  1  2  3  4  5
            %       cell     A  B  A  C  A  B     first A B C, then A B, then A
            %
            %   and where all updates of a cell are free, even their order
            %   does not count, only their number. (The same index twice on
            %   the left of one assignment would lose an update.)
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
            free = grid.l_free - grid.l0;
            counts = accumarray(cells, 1, [window, 1]);
            touched = find(counts > 0 & ~mixed);
            counts = counts(touched);
            values = reshape(grid.log_odds(touched + before), [], 1);
            left = (1:numel(touched))';
            j = 0;
            while ~isempty(left)
                old = values(left);
                new = min(max(old + free, grid.l_min), grid.l_max);
                values(left) = new;
                j = j + 1;
                % an update that changed nothing would change nothing again
                left = left(counts(left) > j & new ~= old);
            end
            grid.log_odds(touched + before) = values;

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
            steps(occupied(i)) = grid.l_occ - grid.l0;
            starts = find([true; diff(cells) ~= 0]);
            counts = diff([starts; numel(cells) + 1]);
            [counts, most_first] = sort(counts, 'descend');
            starts = starts(most_first);
            touched = cells(starts) + before;
            values = reshape(grid.log_odds(touched), [], 1);
            % how many cells have a j-th update, j = 1, 2, ...
            reached = flipud(cumsum(flipud(accumarray(counts, 1))));
            for j = 1:numel(reached)
                head = 1:reached(j);
                new = values(head) + steps(starts(head) + j - 1);
                values(head) = min(max(new, grid.l_min), grid.l_max);
            end
            grid.log_odds(touched) = values;
        end

    end
end
