% The probe on Octave's command line:
%
%   octave-cli --no-history --norc --quiet run_probe.m FUNCTION INPUT OUTPUT
%
% On MATLAB call probe(FUNCTION, INPUT, OUTPUT).
addpath(fileparts(mfilename('fullpath')));
addpath(fileparts(fileparts(mfilename('fullpath'))));
octave_is_up();
run_probe_arguments = argv();
probe(run_probe_arguments{:});
