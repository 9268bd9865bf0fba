#!/usr/bin/env bash
# The minutes that a build is said to take still become fewer each time they are said, also where the last files take
# four times as long as the first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source packaging/build_steps.sh

# Time passes with each line that is read.
lines=0
read() {
  lines=$((lines + 1))
  SECONDS=$((SECONDS + (lines > 40 ? 32 : 8)))
  builtin read "$@"
}

said=$(for step in $(seq 1 60); do echo "[$step of 60] Building"; done | show_progress)
minutes=$(grep -o 'about [0-9]* min' <<<"$said" | grep -o '[0-9]*')
echo "said: $(tr '\n' ' ' <<<"$minutes")minutes"
[ "$(wc -l <<<"$minutes")" -ge 4 ]
[ "$minutes" = "$(sort -rnu <<<"$minutes")" ]
