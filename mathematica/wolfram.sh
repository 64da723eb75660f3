#!/bin/sh
# Runs a Wolfram Language script: on wolframscript where it is on the PATH,
# else on woxi, the project's own or one on the PATH. WOLFRAM=woxi asks for
# woxi where both are there.
#
#   sh wolfram.sh SCRIPT.wls [ARGUMENT...]

here=$(dirname "$0")
if [ "$WOLFRAM" != woxi ] && command -v wolframscript > /dev/null; then
    exec wolframscript -file "$@"
elif [ -x "$here/../.venv/bin/woxi" ]; then
    exec "$here/../.venv/bin/woxi" run "$@"
elif command -v woxi > /dev/null; then
    exec woxi run "$@"
fi
echo "wolfram.sh: neither wolframscript nor woxi is there (pip install woxi)" >&2
exit 1
