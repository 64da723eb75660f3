spec = occgrid.grid.grid_spec(1, 1, 1, 0, 0);
map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.30, -8, 8);
for update = [map.l_occ, map.l_free, map.l_free, map.l_occ]
    map = occgrid.grid.update_cell(map, 0, 0, update);
    p = occgrid.grid.probability_grid(map);
    fprintf('log-odds %+.4f, p = %.4f\n', map.log_odds, p);
end
