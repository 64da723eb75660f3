% Occupancy grid mapping on Octave's command line:
%
%   octave-cli --no-history --norc --quiet occgrid_cli.m [OPTION...]
%
% On MATLAB:  matlab -batch "exit(occgrid.main('--out', 'maps'))"

addpath(fileparts(mfilename('fullpath')));
octave_is_up();
occgrid_arguments = argv();
exit(occgrid.main(occgrid_arguments{:}));
