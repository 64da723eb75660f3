scenario = occgrid.lesson.lesson_scenario();
map = occgrid.fast.map_scenario_fast(scenario, []);
p = occgrid.grid.probability_grid(map);
fprintf('%d cells were seen\n', nnz(p ~= 0.5));
if ~isempty(getenv('DISPLAY')) || ispc || ismac
    imagesc([-10.95, 10.95], [-8.95, 8.95], 1 - p);
    axis xy equal tight;
    colormap(gray);
    xlabel('x [m]');
    ylabel('y [m]');
end
