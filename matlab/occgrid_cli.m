% Occupancy grid mapping on Octave's command line:
%
%   octave-cli --no-history --norc --quiet occgrid_cli.m [OPTION...]
%
% On MATLAB:  matlab -batch "exit(occgrid.main('--out', 'maps'))"

% a signal is not to leave a file octave-workspace behind
crash_dumps_octave_core(false);
sighup_dumps_octave_core(false);
sigterm_dumps_octave_core(false);
addpath(fileparts(mfilename('fullpath')));
occgrid_arguments = argv();
exit(occgrid.main(occgrid_arguments{:}));
