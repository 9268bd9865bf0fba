# Sourced by what builds (packaging/run, test, fuzz, deb, docs …): says what is being done and how far it is.

# Ninja would start two compilers more, which wait for memory: a sixth slower.
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}

say() { printf '== %d:%02d %s\n' "$((SECONDS / 60))" "$((SECONDS % 60))" "$*"; }

# Reads ninja's lines: "[7 of 60] …" becomes a line of progress every 15 seconds, with the minutes that are left if the
# rest takes as long as what is done. They are said only where they have become fewer since they were said last: the
# largest files may come at the end. Whatever else it prints (warnings, errors) is passed on.
show_progress() {
  local line begun=$SECONDS shown=$((SECONDS - 15)) pattern='^\[([0-9]+) of ([0-9]+)\]' done_steps=0 steps=0 said_min=1000000
  while IFS= read -r line; do
    if ! [[ $line =~ $pattern ]]; then
      printf '%s\n' "$line"
      continue
    fi
    done_steps=${BASH_REMATCH[1]} steps=${BASH_REMATCH[2]}
    local elapsed=$((SECONDS - begun))
    if [ "$done_steps" -gt 0 ] && [ "$done_steps" -lt "$steps" ] && [ "$((SECONDS - shown))" -ge 15 ]; then
      shown=$SECONDS
      local left_min=$(((elapsed * (steps - done_steps) / done_steps + 59) / 60))
      if [ "$elapsed" -lt 20 ] || [ "$done_steps" -lt 3 ] || [ "$left_min" -ge "$said_min" ]; then
        say "   step $done_steps of $steps"
      else
        said_min=$left_min
        say "   step $done_steps of $steps, about $left_min min left"
      fi
    fi
  done
  if [ "$done_steps" -gt 0 ]; then say "   built: $done_steps of $steps steps, $((SECONDS - begun)) s"; fi
}

# build PRESET [TARGET…]
build() {
  local preset=$1 targets=()
  shift
  if [ "$#" -gt 0 ]; then targets=(--target "$@"); fi
  NINJA_STATUS='[%f of %t] ' cmake --build --preset "$preset" "${targets[@]}" | show_progress
}
