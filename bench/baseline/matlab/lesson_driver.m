% The lesson's mapping written down plainly.
%
% usage: octave-cli lesson_driver.m WORK
bench_folder = fileparts(mfilename('fullpath'));
addpath(bench_folder);
addpath(fullfile(bench_folder, '..', '..', 'matlab'));
bench_arguments = argv();
bench_work = read_work(bench_arguments{1});
answer_requests(@() map_as_lesson(bench_work));
