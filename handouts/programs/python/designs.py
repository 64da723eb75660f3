from dataclasses import replace

from occgrid.lesson import lesson_scenario, lesson_settings
from occgrid.mapper import map_scenario

for p_occ, p_free in [(0.6, 0.4), (0.75, 0.3), (0.9, 0.1)]:
    scenario = lesson_scenario()
    scenario.settings = replace(lesson_settings(), p_occ=p_occ, p_free=p_free)
    p = map_scenario(scenario, None).probability_grid()
    unsure = ((p > 0.05) & (p < 0.95) & (p != 0.5)).sum()
    print(f"p_occ = {p_occ}, p_free = {p_free}: {unsure} cells are unsure")
