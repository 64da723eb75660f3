scenario = occgrid.scenario.read_scenario('scenarios/one-beam.log');
map = occgrid.mapper.map_scenario(scenario, []);
for gy = map.spec.height - 1:-1:0 % the row with the largest y first
    fprintf('%+.4f  ', map.log_odds(gy + 1, :));
    fprintf('\n');
end
