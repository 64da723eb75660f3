spec = occgrid.grid.grid_spec(220, 180, 0.1, -11, -9);
map = occgrid.grid.occupancy_grid(spec, 0.5, 0.75, 0.30, -8, 8);
points = [-11, -9; 0, 0; 0.05, -0.05; -12, 0];
[gx, gy] = occgrid.grid.world_to_grid( ...
    map, points(:, 1), points(:, 2));
inside = occgrid.grid.in_bounds(map, gx, gy);
fprintf('(%g, %g) m lies in cell (%d, %d), inside: %d\n', ...
    [points, gx, gy, inside]');
