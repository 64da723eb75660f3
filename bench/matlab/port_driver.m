% The MATLAB/Octave port at the benchmark's work.
%
% usage: octave-cli port_driver.m WORK log|scan|plain
%
% log: batches of about 8192 beams, as the port maps a log; scan: one scan
% after another; plain: update_grid_from_scan, one scan after another.
bench_folder = fileparts(mfilename('fullpath'));
addpath(bench_folder);
addpath(fullfile(bench_folder, '..', '..', 'matlab'));
bench_arguments = argv();
bench_work = read_work(bench_arguments{1});
bench_batch = 1;
if strcmp(bench_arguments{2}, 'log')
    bench_batch = ceil(8192 / numel(bench_work.angles));
end
bench_plain = strcmp(bench_arguments{2}, 'plain');
answer_requests(@() map_with_port(bench_work, bench_batch, bench_plain));
