#!/bin/sh
# Makes the bundled sample session anew: a simulated street, small enough to ship. The truth is in truth.yaml.
# Usage: resources/sample/make_sample.sh [path of remount-cli]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cli=${1:-$here/../../build/headless/bin/remount-cli}
new=$(mktemp -d)
trap 'rm -rf "$new"' EXIT
"$cli" simulate street "$new/sample" --duration-s 9.6 --scan-rate-hz 5 --beams 32 --azimuth-steps 200 \
  --max-range-m 60 --moving-objects 2 --ins-rate-hz 50 --seed 7
rm -rf "$here/scans" "$here/ins.csv" "$here/scan_stamps.csv" "$here/session.yaml" "$here/truth.yaml"
cp -r "$new/sample/." "$here/"
du -sh "$here"
