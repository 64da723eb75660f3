from occgrid.grid import GridSpec, OccupancyGrid

grid = OccupancyGrid(GridSpec(220, 180, 0.1, -11.0, -9.0))
for x, y in [(-11.0, -9.0), (0.0, 0.0), (0.05, -0.05), (-12.0, 0.0)]:
    gx, gy = map(int, grid.world_to_grid(x, y))
    where = "inside" if grid.in_bounds(gx, gy) else "outside"
    print(f"({x}, {y}) m lies in cell ({gx}, {gy}), {where}")
