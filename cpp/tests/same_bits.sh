#!/bin/sh
# The same bits from every compiler, whatever it optimises: maps the lesson and
# the scenarios named, noise-free and with noise, and compares all files.
#
# usage: same_bits.sh [SCENARIO...]      (COMPILERS="g++ clang++" by default)
set -eu

port=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

reference=
different=0
for compiler in ${COMPILERS:-g++ clang++}; do
    for flags in "-O0" "-O2" "-O3 -march=native" "-O3 -march=native -ffp-contract=fast"; do
        build=$work/build
        rm -rf "$build"
        cmake -S "$port" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" \
            -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" >"$work/log" 2>&1 &&
            cmake --build "$build" --target occgrid --parallel 2 >>"$work/log" 2>&1 ||
            { cat "$work/log" >&2; exit 1; }
        maps=$work/maps${reference:+-other}
        rm -rf "$maps"
        for mode in "--noise-free" "--seed 0"; do
            # $mode is one or two words
            "$build/occgrid" $mode --out "$maps/lesson $mode"
            [ $# = 0 ] || "$build/occgrid" $mode --out "$maps/files $mode" "$@"
        done
        if [ -z "$reference" ]; then
            reference="$compiler $flags"
            echo "reference: $reference"
        elif diff -rq "$work/maps" "$maps"; then
            echo "same bits: $compiler $flags"
        else
            echo "DIFFERENT: $compiler $flags"
            different=1
        fi
    done
done
exit $different
