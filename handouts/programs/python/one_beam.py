from occgrid.mapper import map_scenario
from occgrid.scenario import read_scenario

with read_scenario("scenarios/one-beam.log") as scenario:
    grid = map_scenario(scenario, None)
for row in grid.log_odds[::-1]:  # the row with the largest y first
    print("  ".join(f"{value:+.4f}" for value in row))
