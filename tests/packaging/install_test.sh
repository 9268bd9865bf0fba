#!/usr/bin/env bash
# Usage: install_test.sh CMAKE BUILD   installs the component cli into a folder, and runs the program there
set -euo pipefail
cmake=$1 build=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
fail() { echo "$*" >&2; exit 1; }

"$cmake" --install "$build" --component cli --prefix "$room/usr" > "$room/log" || { cat "$room/log"; fail "not installed"; }
told=$(HOME=$(realpath "$room") "$room/usr/bin/remount-cli" doctor)
grep -qx "sample drive: ~/usr/share/remount/sample" <<< "$told" || fail "doctor does not find the sample: $told"
scans=$(find "$room/usr/share/remount/sample/scans" -name "*.pcd" | wc -l)
[ "$scans" -gt 10 ] || fail "the sample has $scans scans"
"$room/usr/bin/remount-cli" inspect "$room/usr/share/remount/sample" > "$room/inspected" || fail "$(cat "$room/inspected")"
[ -s "$room/usr/share/doc/remount-cli/copyright" ] || fail "no copyright file"
[ ! -e "$room/usr/bin/remount" ] || fail "the window is in the component of the command line"
[ ! -e "$room/usr/share/remount/sample/make_sample.sh" ] || fail "what makes the sample is installed"
echo "installed: $(find "$room/usr" -type f | wc -l) files, $scans scans"
