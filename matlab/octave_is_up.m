function octave_is_up()
    % OCTAVE_IS_UP  From here on, a signal leaves no file octave-workspace.
    %
    %   octave_is_up()
    %
    %   Removes the file that OCCGRID_STARTING names, if any: as long as it is
    %   there, matlab.sh ends Octave by SIGKILL.
    crash_dumps_octave_core(false);
    sighup_dumps_octave_core(false);
    sigterm_dumps_octave_core(false);
    starting = getenv('OCCGRID_STARTING');
    if ~isempty(starting)
        unlink(starting);
    end
end
