#!/usr/bin/env bash
# Usage: run_tests.sh PYTHON FOLDER   runs the tests of the Python module that lies there ("none": it is not built);
# 77 and the reason where they cannot run
set -euo pipefail
python=$1 folder=$2
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
skip() { echo "skipped: $*"; exit 77; }

[ "$folder" != none ] || skip "the module is not built (it needs pybind11-dev and python3-dev)"
ls "$folder"/remount/_remount.*.so > /dev/null 2>&1 || skip "the module is not built (target remount_python)"
for needed in numpy pytest; do
  "$python" -c "import $needed" 2> /dev/null || skip "$python has no $needed (package python3-$needed)"
done
MPLCONFIGDIR=$(mktemp -d)
export MPLCONFIGDIR
trap 'rm -rf "$MPLCONFIGDIR"' EXIT
PYTHONPATH=$folder PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg "$python" -m pytest -q -rP --durations=5 -p no:cacheprovider "$here"
