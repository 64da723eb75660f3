#!/bin/sh
# Runs README.md's example of the library as it is printed, and compares what
# it prints with what README.md says; then Get from a folder that woxi cannot
# find the package from. Ends with status 1 where something failed.
#
#   sh mathematica/tests/readme.sh

port=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# the indented lines that follow the line $1, up to the next that is not
block() {
    awk -v from="$1" 'index($0, from) == 1 && !done { on = 1; if (from !~ /^    /) next }
        on && /^    / { print substr($0, 5); some = 1; next }
        on && /^$/ { if (some) print ""; next }
        on { exit }' "$port/README.md" | sed -e :a -e '/^\n*$/{$d;N;ba' -e '}'
}

block '    (* two_maps.wls' > "$folder/two_maps.wls"
block 'It prints' > "$folder/expected"
cd "$port/.." || exit 1
sed -i "s|\"lesson.png\"|\"$folder/lesson.png\"|" "$folder/two_maps.wls"
sh "$port/wolfram.sh" "$folder/two_maps.wls" > "$folder/printed"
diff "$folder/expected" "$folder/printed" || { echo "FAILED README.md's example"; exit 1; }
[ -s "$folder/lesson.png" ] || { echo "FAILED README.md's picture"; exit 1; }

cd "$folder" || exit 1
echo "Get[\"$port/OccupancyGrid.wl\"]; Print[\"on\"];" > elsewhere.wls
if sh "$port/wolfram.sh" elsewhere.wls > message; then
    [ "$(cat message)" = on ]
else
    grep -q 'OccupancyGridFolder' message
fi || { echo "FAILED Get from elsewhere"; cat message; exit 1; }
{ echo "\$OccupancyGridFolder = \"$port\";"; cat elsewhere.wls; } > told.wls
[ "$(sh "$port/wolfram.sh" told.wls)" = on ] || { echo "FAILED \$OccupancyGridFolder"; exit 1; }
echo "README.md: passed"
