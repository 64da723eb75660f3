% matlab_check on Octave's command line, see matlab.sh.
addpath(fileparts(fileparts(mfilename('fullpath'))));
octave_is_up();
matlab_check();
