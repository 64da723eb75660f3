#!/bin/sh
# The command as a shell sees it: names, outputs, pipes, signals. Prints what
# failed, then N passed, N failed; ends with status 1 where something failed.
#
#   sh mathematica/tests/command.sh

port=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export TMPDIR="$folder/tmp"
mkdir "$TMPDIR"
cd "$folder" || exit 1
scenarios=$port/../scenarios
one=$scenarios/one-beam.log
passed=0
failed=0

occgrid() {
    sh "$port/wolfram.sh" "$port/occgrid.wls" "$@"
}

# is NAME ACTUAL EXPECTED
is() {
    if [ "$2" = "$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED %s\n  is       %s\n  expected %s\n' "$1" "$2" "$3"
    fi
}

# no temporary file, neither in the folder for them nor in an output folder
left() {
    find "$folder" -name '*.part' -o -path "$TMPDIR/*" | head -5
}

occgrid --noise-free "$one" > map.pgm
cmp -s map.pgm "$scenarios/golden/one-beam.noise-free.pgm"
is "the map on standard output" $? 0

# Names that a source text would make something of.
bad='a", Run["touch PWNED"], "x.log'
cp "$one" "$bad"
cp "$one" 'b\c.log'
cp "$one" "d'e \$HOME.log"
cp "$one" "$(printf 'f\tg.log')"
cp "$one" "$(printf 'h\303\274.log')"
occgrid --noise-free --out odd "$bad" 'b\c.log' "d'e \$HOME.log" "$(printf 'f\tg.log')" "$(printf 'h\303\274.log')"
is "odd names: status" $? 0
is "odd names: files" "$(find odd -type f | wc -l)" 15
is "odd names: nothing is run" "$(ls PWNED 2> /dev/null)" ""
is "odd names: the map" "$(cmp odd/'b\c.pgm' map.pgm && echo same)" same

cp "$one" "$(printf 'i\377.log')"
is "a name that is not UTF-8" "$(occgrid "$(printf 'i\377.log')" 2>&1 | LC_ALL=C sed 's/^.*:0/FILE:0/')" "FILE:0: cannot be read"
is "a line break in a name" "$(occgrid "$(printf 'no\nsuch.log')" 2>&1)" "no?such.log:0: cannot be read"
is "no argument is lost" "$(occgrid --out '' 2>&1 | head -1)" "occgrid: --out needs a value"
is "options reach the script" "$(occgrid --version | cut -d' ' -f1)" occgrid

occgrid --noise-free --out ./o//q/ "$one"
is "slashes in DIR" "$(ls o/q | tr '\n' ' ')" "one-beam.logodds one-beam.pgm one-beam.yaml "
mkdir -p r/one-beam.yaml
is "PATH of an error" "$(occgrid --noise-free --out ./r// "$one" 2>&1)" "./r/one-beam.yaml: cannot be written"
is "all or nothing" "$(ls -A r)" one-beam.yaml

for arguments in --version --help "$one"; do
    is "a full disk: $arguments" "$(occgrid "$arguments" 2>&1 > /dev/full)" "standard output: cannot be written"
    is "a closed pipe: $arguments" "$( (occgrid "$arguments" 2> error; echo $? > status) | true; cat error status | tr '\n' ' ')" \
        "standard output: cannot be written 1 "
done

# Signals. (A function in the background is a shell of its own, which would
# get the signal: so not occgrid here.)
interrupted() {
    signal=$1
    shift
    sh "$port/wolfram.sh" "$port/occgrid.wls" "$@" > /dev/null 2>&1 &
    pid=$!
    tries=0
    while ! ls "$TMPDIR"/occgrid-*/arguments > /dev/null 2>&1 && [ $tries -lt 1200 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    sleep 1
    kill -s "$signal" "$pid"
    wait "$pid"
}
mkdir s
interrupted TERM --out s
is "SIGTERM: status" $? 143
is "SIGTERM: no file" "$(ls -A s; left)" ""
# A script's background has SIGINT ignored, and a shell cannot change that; so
# it comes from a program that a terminal might have started.
python3 - "$port" <<'PYTHON'
import signal, subprocess, sys, time, os
port = sys.argv[1]
run = subprocess.Popen(["sh", f"{port}/wolfram.sh", f"{port}/occgrid.wls", "--out", "s"],
    preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
while not any(name.startswith("occgrid-") for name in os.listdir(os.environ["TMPDIR"])):
    if run.poll() is not None:
        sys.exit("the run has ended")
    time.sleep(0.05)
time.sleep(1)
run.send_signal(signal.SIGINT)
sys.exit(-run.wait())
PYTHON
is "SIGINT: status" $? 2
is "SIGINT: no file" "$(ls -A s; left)" ""
# The temporary files are there already when the signal comes; the engine may
# not be.
sh "$port/wolfram.sh" "$port/occgrid.wls" --out s > /dev/null 2>&1 &
pid=$!
tries=0
while ! ls "$TMPDIR"/occgrid-* > /dev/null 2>&1 && [ $tries -lt 1200 ]; do
    sleep 0.05
    tries=$((tries + 1))
done
run=$(basename "$TMPDIR"/occgrid-*)
touch "s/.$run-1.part" "s/.occgrid-other-1.part"
kill -s TERM "$pid"
wait "$pid"
is "SIGTERM: the run's files go, others stay" "$(ls -A s)" .occgrid-other-1.part
is "nothing is left" "$(rm -r s; left)" ""

echo "$passed passed, $failed failed"
[ $failed -eq 0 ] && [ $passed -gt 0 ]
