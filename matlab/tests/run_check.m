% matlab_check on Octave's command line, see matlab.sh.
addpath(fileparts(fileparts(mfilename('fullpath'))));
matlab_check();
