#!/usr/bin/env bash
# Usage: library_test.sh CMAKE BUILD EXAMPLES SAMPLE COMPILER   installs the component dev into a folder, and builds and
# runs the examples against what lies there
set -euo pipefail
cmake=$1 build=$2 examples=$3 sample=$4 compiler=$5
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() { echo "$*" >&2; exit 1; }

"$cmake" --install "$build" --component dev --prefix "$room/usr" > "$room/log" || { cat "$room/log"; fail "not installed"; }
"$cmake" -G Ninja -S "$examples" -B "$room/build" -DCMAKE_PREFIX_PATH="$room/usr" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" > "$room/log" 2>&1 || { cat "$room/log"; fail "not configured"; }
"$cmake" --build "$room/build" > "$room/log" 2>&1 || { cat "$room/log"; fail "not built"; }

cd "$room"
build/calibrate_folder "$sample" result.yaml | tee calibrated
grep -q '^ok: ' calibrated || fail "the sample is not solved"
build/own_exporter result.yaml mine.txt > exported || fail "not exported"
[ "$(grep -vc '^#' mine.txt)" = 3 ] || fail "three rows were expected: $(cat mine.txt)"
build/register_scans "$sample" 0 2 || fail "not registered"
build/own_reader || fail "the drive of the own reader is not solved"
# What is wrong is an error of the interface, not the end of the program.
code=0
build/calibrate_folder "$room/nowhere" 2> error || code=$?
[ "$code" = 2 ] || fail "a folder that is not there ends with $code"
grep -q "$room/nowhere: " error || fail "the error does not name the place: $(cat error)"
# Nothing but the interface is seen.
seen=$(nm -D --defined-only --demangle "$room"/usr/lib/*/libremount.so | grep -v 'remount::api::' || true)
[ -z "$seen" ] || fail "symbols beside the interface: $(head -n 5 <<< "$seen")"
