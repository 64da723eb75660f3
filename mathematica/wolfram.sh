#!/bin/sh
# Runs a Wolfram Language script: on wolframscript where it is on the PATH,
# else on woxi, the project's own or one on the PATH. WOLFRAM=woxi asks for
# woxi where both are there.
#
#   sh wolfram.sh SCRIPT.wls [ARGUMENT...]
#
# The arguments go to the script in a file, each with a byte 0 at its end:
# wolframscript takes some options for its own, and woxi runs an argument with
# quotes in it as source text. The file lies in OCCGRID_FOLDER, a folder of
# this run, which is removed at its end. So are the temporary files that the
# run was writing into --out DIR, when SIGINT or SIGTERM ends it.

here=$(dirname "$0")
if [ "$WOLFRAM" != woxi ] && command -v wolframscript > /dev/null; then
    engine="wolframscript"
    verb="-file"
elif [ -x "$here/../.venv/bin/woxi" ]; then
    engine="$here/../.venv/bin/woxi"
    verb="run"
elif command -v woxi > /dev/null; then
    engine="woxi"
    verb="run"
else
    echo "wolfram.sh: neither wolframscript nor woxi is there (pip install woxi)" >&2
    exit 1
fi

script=$1
shift

clean() {
    rm -rf "$OCCGRID_FOLDER"
    if [ -n "$out" ]; then
        rm -f "$out/.occgrid-${OCCGRID_FOLDER##*/occgrid-}"-*.part
    fi
}

# The engine is ended first, so that it writes no more; then this shell ends by
# the same signal. ($! is empty until the engine has been started.)
end_by() {
    trap '' INT TERM
    kill -TERM "$!" 2> /dev/null
    wait "$!" 2> /dev/null
    clean
    trap - "$1"
    kill -s "$1" $$
}

out=
OCCGRID_FOLDER=
trap 'end_by INT' INT
trap 'end_by TERM' TERM
OCCGRID_FOLDER=$(mktemp -d "${TMPDIR:-/tmp}/occgrid-XXXXXXXXXX") || exit 1
export OCCGRID_FOLDER

previous=
for argument; do
    if [ "$previous" = --out ]; then
        out=$argument
    fi
    previous=$argument
    printf '%s\0' "$argument" 2> /dev/null || {
        echo "$OCCGRID_FOLDER/arguments: cannot be written" >&2
        rm -rf "$OCCGRID_FOLDER"
        exit 1
    }
done > "$OCCGRID_FOLDER/arguments"
case $out in
-*) out=./$out ;;
esac

"$engine" "$verb" "$script" &
wait "$!"
status=$?
clean
exit "$status"
