# Sourced by packaging/test-install and packaging/test-archive: a system where nothing of ours ever was, in a folder
# (debootstrap), with a user "tester" and, where it is wanted, a virtual screen of this machine. Needs root.
# It ends with the script that made it, however that ends.

room= root=                # a temporary folder, and the system below it
screen= program= display=  # the virtual screen and the window, while they run

# begin SCRIPT [ARGUMENT…]: makes the temporary folder. The script runs itself again in namespaces of its own, so that
# mounts and processes end with it.
begin() {
  if [ "$(id -u)" -ne 0 ]; then echo "${1##*/}: only root can make a system in a folder" >&2; exit 1; fi
  if [ "${REMOUNT_IN_NAMESPACE:-}" != yes ]; then
    REMOUNT_IN_NAMESPACE=yes exec unshare --mount --pid --fork --kill-child --mount-proc "$@"
  fi
  room=$(realpath "$(mktemp -d "${TMPDIR:-/tmp}/remount-install.XXXXXX")")
  root=$room/system
  trap leave EXIT
  trap 'exit 130' INT TERM
}

need_tools() {
  local tool
  for tool in "$@"; do
    if ! command -v "$tool" > /dev/null; then echo "${0##*/}: $tool is missing (packaging/setup --deb)" >&2; exit 1; fi
  done
}

# end PROCESS: it may have ended before. Where it is a shell that waits for a program, that ends first.
end() {
  [ -n "$1" ] || return 0
  local children
  children=$(cat "/proc/$1/task/$1/children" 2> /dev/null || true)
  kill $children "$1" 2> /dev/null || true
  wait "$1" 2> /dev/null || true
}
end_window() {
  end "$program"
  end "$screen"
  # A server that is killed leaves these behind.
  if [ -n "$display" ]; then rm -f "/tmp/.X${display#:}-lock" "/tmp/.X11-unix/X${display#:}"; fi
  program= screen= display=
}
# What is mounted below a folder, the innermost first. The kernel writes blanks and the like in octal.
mounted_below() {
  local place
  while read -r _ place _; do
    printf -v place '%b' "${place//\\/\\0}"
    case "$place" in "$1"/*) printf '%s\0' "$place" ;; esac
  done < /proc/mounts | sort -zr
}
leave() {
  local code=$? mounted
  trap - EXIT
  set +e
  end_window
  # Before the folder goes: what is mounted in it is not ours to empty.
  while IFS= read -r -d '' mounted; do umount -l "$mounted" || true; done < <(mounted_below "$room")
  rm -rf --one-file-system "$room" || true
  exit "$code"
}

fail() { say "FAILED: $*"; exit 1; }
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
as_user() { inside setpriv --reuid=tester --regid=tester --clear-groups env HOME=/home/tester "$@"; }
now_ms() { date +%s%3N; }

# make_system RELEASE MIRROR SCRIPT [OPTION…] (those of debootstrap): the lines of its sources.list come on the standard input, with
# keyrings of this machine.
make_system() {
  local release=$1 mirror=$2 script=$3 keyring sources
  shift 3
  sources=$(cat)
  [ -n "$sources" ] || fail "no sources of packages for $release"
  say "making a system of $release"
  debootstrap --variant=minbase --include=ca-certificates "$@" "$release" "$root" "$mirror" "$script" \
    > "$room/debootstrap.log" 2>&1 < /dev/null ||
    { tail -n 20 "$room/debootstrap.log"; fail "debootstrap"; }
  printf '%s\n' "$sources" > "$root/etc/apt/sources.list"
  sed -n 's/.*\[signed-by=\([^]]*\)\].*/\1/p' "$root/etc/apt/sources.list" | sort -u | while read -r keyring; do
    install -D -m 644 "$keyring" "$root$keyring"
  done
  apt-config dump | grep -E '^Acquire::((http|https)::Proxy|Check-|Retries|Languages)' > "$root/etc/apt/apt.conf.d/00machine" || true
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  mount -t proc proc "$root/proc"  # some packages need it while they are set up
  inside useradd --create-home tester
  inside apt-get update -q > "$room/update.log" 2>&1 || { cat "$room/update.log"; fail "apt-get update"; }
}

# install_in_system NAME…: with what apt recommends left out, the least that must be enough. What is downloaded is
# downloaded before, so that the time of the rest is that of the machine.
download_in_system() { inside_apt --download-only "$@"; }
install_in_system() { inside_apt "$@"; }
inside_apt() {
  inside apt-get install -q -y --no-install-recommends "$@" > "$room/install.log" 2>&1 ||
    { tail -n 30 "$room/install.log"; fail "apt install $*"; }
}

# calibrate_sample PROGRAM SAMPLE BEGUN_MS: the result must be a solved one, within a minute of when installing began.
calibrate_sample() {
  local program_file=$1 sample=$2 begun_ms=$3 took_ms
  as_user "$program_file" calibrate "$sample" -o /home/tester/result.yaml || fail "calibrating the sample"
  took_ms=$(($(now_ms) - begun_ms))
  say "   the sample is solved $took_ms ms after installing began"
  grep -q '^status: ok$' "$root/home/tester/result.yaml" || fail "the sample is not solved"
  if [ "$took_ms" -gt 60000 ]; then fail "that is more than a minute"; fi
}

# show_window PROGRAM: opens the window with the sample on a virtual screen, and closes it. The screen and who looks at
# it are this machine's: nothing else is installed beside what is tried.
show_window() {
  local program_file=$1 title= number=
  mkdir -p -m 1777 "$root/tmp/.X11-unix" /tmp/.X11-unix
  mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
  exec 5> "$room/display"
  Xvfb -displayfd 5 -screen 0 1280x1024x24 +extension GLX -nolisten tcp -ac > "$room/xvfb.log" 2>&1 &
  screen=$!
  exec 5>&-
  for _ in $(seq 100); do
    number=$(cat "$room/display")
    if [ -n "$number" ]; then break; fi
    sleep 0.1
  done
  [ -n "$number" ] || { cat "$room/xvfb.log"; fail "the virtual screen did not start"; }
  display=:$number
  as_user env DISPLAY="$display" "$program_file" --version | sed 's/^/   /'
  as_user env DISPLAY="$display" "$program_file" --sample > "$room/window.log" 2>&1 &
  program=$!
  for _ in $(seq 300); do
    title=$(DISPLAY=$display xdotool search --onlyvisible --name 'Remount$' getwindowname 2> /dev/null | head -n 1) || true
    if [ -n "$title" ] || ! kill -0 "$program" 2> /dev/null; then break; fi
    sleep 0.2
  done
  [ -n "$title" ] || { cat "$room/window.log"; DISPLAY=$display xwininfo -root -tree || true; fail "the window did not show"; }
  say "   the window shows \"$title\""
  sleep 5
  kill -0 "$program" 2> /dev/null || { cat "$room/window.log"; fail "the window ended by itself"; }
  if [ -n "${REMOUNT_SCREENSHOT:-}" ]; then import -display "$display" -window root "$REMOUNT_SCREENSHOT" || true; fi
  if [ -s "$room/window.log" ]; then sed 's/^/   it says: /' "$room/window.log"; fi
  end_window
  umount "$root/tmp/.X11-unix" || true
}
