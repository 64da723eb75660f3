from occgrid.grid import GridSpec, OccupancyGrid

grid = OccupancyGrid(GridSpec(1, 1, 1.0, 0.0, 0.0))
for update in [grid.l_occ, grid.l_free, grid.l_free, grid.l_occ]:
    grid.update_cell(0, 0, update)
    p = grid.probability_grid()[0, 0]
    print(f"log-odds {grid.log_odds[0, 0]:+.4f}, p = {p:.4f}")
