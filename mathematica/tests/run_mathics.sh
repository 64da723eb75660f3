#!/bin/sh
# Runs the unit tests on Mathics3, from build/mathics in the suite's folder,
# where it is installed if it is missing.
#
#   sh mathematica/tests/run_mathics.sh [NAME...]

here=$(cd "$(dirname "$0")" && pwd)
environment=$here/../../build/mathics
if ! "$environment/bin/python" -c "import mathics.session" 2> /dev/null; then
    echo "run_mathics.sh: installing Mathics3 into build/mathics" >&2
    python3 -m venv "$environment" &&
        "$environment/bin/pip" install -q "Mathics3==10.0.1" packaging || exit 1
fi
exec "$environment/bin/python" "$here/run_mathics.py" "$@"
