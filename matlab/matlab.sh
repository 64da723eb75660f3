#!/bin/sh
# Runs the port: on MATLAB where matlab is on the PATH, else on Octave.
# MATLAB=octave asks for Octave where both are there.
#
#   sh matlab.sh occgrid [OPTION...] [SCENARIO...]
#   sh matlab.sh probe FUNCTION INPUT OUTPUT
#   sh matlab.sh check

here=$(cd "$(dirname "$0")" && pwd)

# Prints its arguments as the arguments of a MATLAB function: 'a', 'it''s'. A
# line end cannot stand between quotes: ['a', newline, 'b'].
literals() {
    separator=
    for argument in "$@"; do
        printf "%s[" "$separator"
        printf '%s\n' "$argument" | LC_ALL=C awk -v q="'" '{
            gsub(q, q q)
            printf "%s%s%s%s", (NR > 1 ? ", newline, " : ""), q, $0, q
        }'
        printf ']'
        separator=', '
    done
}

# Ends the command by a signal, and then this script. Octave can lose one that
# comes while it starts, so the signal is sent until the command has ended. One
# that it does not lose then makes it write a file octave-workspace: as long as
# the file $OCCGRID_STARTING is there, Octave has written nothing and is killed.
end_by() {
    trap '' HUP INT TERM
    child=${child:-$!}
    [ -e "$OCCGRID_STARTING" ] && kill -s KILL $child
    (while kill -s "$1" $child; do sleep 2; done) > /dev/null 2>&1 &
    again=$!
    wait $child
    kill -s KILL $again
    [ -z "$OCCGRID_STARTING" ] || rm -f "$OCCGRID_STARTING"
    trap - "$1"
    kill -s "$1" $$
}

# Runs a command. A signal that ends this script goes to the command first,
# which removes its temporary files; its input is this script's own. A shell
# has its background ignore SIGINT: Octave would, too, until it is up.
run() {
    exec 3<&0
    if env --default-signal=INT true 2> /dev/null; then
        set -- env --default-signal=INT "$@"
    fi
    child=
    for signal in HUP INT TERM; do
        trap "end_by $signal" $signal
    done
    "$@" <&3 3<&- &
    child=$!
    wait $child
    status=$?
    [ -z "$OCCGRID_STARTING" ] || rm -f "$OCCGRID_STARTING"
    exit $status
}

verb=$1
shift
OCCGRID_STARTING=
case $verb in
    occgrid) octave=$here/occgrid_cli.m ;;
    probe) octave=$here/tests/run_probe.m ;;
    check) octave=$here/tests/run_check.m ;;
    *) echo "usage: sh matlab.sh occgrid|probe|check [ARGUMENT...]" >&2
       exit 2 ;;
esac
if [ "$MATLAB" != octave ] && command -v matlab > /dev/null; then
    paths="addpath($(literals "$here")); addpath($(literals "$here/tests"));"
    case $verb in
        occgrid) call="exit(occgrid.main($(literals "$@")))" ;;
        probe) call="probe($(literals "$@"))" ;;
        check) call="matlab_check" ;;
    esac
    run matlab -batch "$paths $call"
elif command -v octave-cli > /dev/null; then
    OCCGRID_STARTING=$(mktemp) && export OCCGRID_STARTING
    run octave-cli --no-history --norc --quiet "$octave" "$@"
fi
echo "matlab.sh: neither matlab nor octave-cli is there" >&2
exit 1
