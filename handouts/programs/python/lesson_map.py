import matplotlib.pyplot as plt

from occgrid.lesson import lesson_scenario
from occgrid.mapper import map_scenario

grid = map_scenario(lesson_scenario(), None)
free = 1.0 - grid.probability_grid()
plt.imshow(free, cmap="gray", origin="lower", extent=(-11, 11, -9, 9))
plt.xlabel("x [m]")
plt.ylabel("y [m]")
plt.show()
