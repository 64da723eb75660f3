for design = [0.6, 0.75, 0.9; 0.4, 0.3, 0.1]
    scenario = occgrid.lesson.lesson_scenario();
    scenario.settings.p_occ = design(1);
    scenario.settings.p_free = design(2);
    map = occgrid.fast.map_scenario_fast(scenario, []);
    p = occgrid.grid.probability_grid(map);
    unsure = nnz(p > 0.05 & p < 0.95 & p ~= 0.5);
    fprintf('p_occ = %g, p_free = %g: %d cells are unsure\n', ...
        design(1), design(2), unsure);
end
