function tests = test_grid()
    % TEST_GRID  Cells, log-odds and their updates.
    tests = {@lesson_problem_1, @points_and_cells, @bounds, @odds, ...
             @update_adds_and_clamps, @outside_is_skipped, ...
             @lesson_problem_4, @cells_of_a_beam, @far_cells, @two_grids, ...
             @probabilities};
end

function map = lesson_map()
    spec = occgrid.grid.grid_spec(220, 180, 0.1, -11, -9);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.30, -8, 8);
end

function lesson_problem_1()
    % 30 m x 20 m in cells of 0.05 m: 600 x 400, 240,000 cells, 1.83 MB
    spec = occgrid.grid.grid_spec(30 / 0.05, 20 / 0.05, 0.05, 0, 0);
    same([spec.width, spec.height], [600, 400]);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.7, 0.3, -10, 10);
    same(size(map.log_odds), [400, 600]);
    log_odds = map.log_odds; %#ok<NASGU>
    bytes = whos('log_odds');
    same(bytes.bytes, 8 * 240000);
end

function points_and_cells()
    map = lesson_map();
    [gx, gy] = occgrid.grid.world_to_grid( ...
        map, [-11, -10.95, 0, -11.01, 10.99, 50], [-9, -9, 0, -9.2, 8.95, -50]);
    same(gx, [0, 0, 110, -1, 219, 610]);
    same(gy, [0, 0, 90, -2, 179, -410]);
    [x, y] = occgrid.grid.grid_to_world_center(map, 0, 179);
    same(x, -11 + 0.5 * 0.1);
    same(y, -9 + 179.5 * 0.1);
    [gx, gy] = ndgrid(0:219, 0:179);
    [x, y] = occgrid.grid.grid_to_world_center(map, gx, gy);
    [gx2, gy2] = occgrid.grid.world_to_grid(map, x, y);
    same(gx2, gx);
    same(gy2, gy);
end

function bounds()
    map = lesson_map();
    same(occgrid.grid.in_bounds( ...
        map, [0, 219, -1, 220, 0, 0], [0, 179, 0, 0, -1, 180]), ...
        [true, true, false, false, false, false]);
end

function odds()
    same(occgrid.grid.logit(0.5), 0);
    same(occgrid.grid.logit(0.75), hex2num('3ff193ea7aad030a'));
    % kept within [1e-9, 1 - 1e-9]
    same(occgrid.grid.logit([0, 1e-9, -3]), ...
        repmat(occgrid.grid.logit(1e-9), 1, 3));
    same(occgrid.grid.logit(1), ...
        occgrid.grid.logit(1 - 1e-9));
    same(occgrid.grid.sigmoid([0, 1000, -1000]), [0.5, 1, 0]);
    p = 0.01:0.01:0.99;
    back = occgrid.grid.sigmoid(occgrid.grid.logit(p));
    assert(max(abs(back - p)) < 1e-15);
end

function update_adds_and_clamps()
    map = lesson_map();
    map = occgrid.grid.update_cell(map, 3, 5, map.l_occ);
    same(map.log_odds(6, 4), map.l_occ);
    same(nnz(map.log_odds), 1);
    for i = 1:20
        map = occgrid.grid.update_cell(map, 3, 5, map.l_occ);
        map = occgrid.grid.update_cell(map, 4, 5, map.l_free);
    end
    same(map.log_odds(6, 4), 8);
    same(map.log_odds(6, 5), -8);
    % clamped after each update, so the way back starts at the bound
    map = occgrid.grid.update_cell(map, 3, 5, map.l_free);
    same(map.log_odds(6, 4), 8 + map.l_free);
end

function outside_is_skipped()
    map = lesson_map();
    for cell_ = [-1, 220, 0, 0; 0, 0, -1, 180]
        map = occgrid.grid.update_cell( ...
            map, cell_(1), cell_(2), map.l_occ);
    end
    same(map.log_odds, zeros(180, 220));
end

function lesson_problem_4()
    % t updates with p_inv: p = O / (1 + O), O = O0 (Oinv / O0)^t
    p0 = 0.4;
    spec = occgrid.grid.grid_spec(1, 1, 1, 0, 0);
    map = occgrid.grid.occupancy_grid(spec, p0, 0.75, 0.3, -50, 50);
    odds0 = p0 / (1 - p0);
    odds_inv = 0.3 / 0.7;
    for t = 1:20
        map = occgrid.grid.update_cell(map, 0, 0, map.l_free);
        o = odds0 * (odds_inv / odds0)^t;
        p = occgrid.grid.probability_grid(map);
        assert(abs(p - o / (1 + o)) < 1e-14 * p * 10);
    end
    assert(p < 0.01); % repeated free evidence drives it to 0
end

function cells_of_a_beam()
    % update_cells is update_cell, cell after cell
    restores = seeded(11); %#ok<NASGU>
    for shape = [1, 9, 6; 7, 1, 5]
        spec = occgrid.grid.grid_spec(shape(1), shape(2), 1, 0, 0);
        map = occgrid.grid.occupancy_grid(spec, 0.4, 0.75, 0.3, -1, 1);
        map.log_odds(:) = 2 * rand(shape(2), shape(1)) - 1;
        [gx, gy] = ndgrid(-2:shape(1) + 1, -2:shape(2) + 1);
        some = randperm(numel(gx), 12)';
        for l = [map.l_occ, map.l_free]
            one = map;
            for i = some'
                one = occgrid.grid.update_cell(one, gx(i), gy(i), l);
            end
            map = occgrid.grid.update_cells(map, gx(some), gy(some), l);
            same(map.log_odds, one.log_odds);
        end
        none = occgrid.grid.update_cells(map, zeros(0, 1), zeros(0, 1), 1);
        same(none.log_odds, map.log_odds);
    end
end

function far_cells()
    % cells whose index would not be exact are not in the grid
    spec = occgrid.grid.grid_spec(5, 25000, 0.001, -1e7, 1e7);
    map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.3, -8, 8);
    [gx, gy] = occgrid.grid.world_to_grid(map, [1e7, -1e7], [-1e7, 1e7]);
    same([gx, gy], [20000000000, 0, -20000000000, 0]);
    map = occgrid.grid.update_cells(map, gx, gy, map.l_occ);
    same(find(map.log_odds), 1);
end

function two_grids()
    % a grid is a value
    a = lesson_map();
    b = occgrid.grid.update_cell(a, 3, 5, a.l_occ);
    same(nnz(a.log_odds), 0);
    a = occgrid.grid.update_cell(a, 3, 5, a.l_free);
    same([a.log_odds(6, 4), b.log_odds(6, 4)], [a.l_free, b.l_occ]);
end

function probabilities()
    map = lesson_map();
    map = occgrid.grid.update_cell(map, 0, 0, map.l_occ);
    p = occgrid.grid.probability_grid(map);
    same(size(p), [180, 220]);
    assert(abs(p(1, 1) - 0.75) < 1e-15);
    same(p(2, 2), 0.5);
end
