#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs every shell command of README.md in its order, after writing the files that it shows, and
# prints how long each took and when the first point cloud was there.
#
#   Testing/Install/readme.sh RELEASE [ARGUMENT...]   in a clean Debian: clean_root.sh RELEASE --readme
#   Testing/Install/readme.sh --here [FOLDER]         with this clone, in FOLDER (build/readme)
#   Testing/Install/readme.sh --commands              prints the commands
#   Testing/Install/readme.sh --files FOLDER          writes the files
#
# Commands are the code blocks of README.md without a language; a file is the block after a line that
# ends with its `name`: and windows are closed by the key q, with xdotool. HELIOS_README_START: when
# cloning began, in seconds since 1970.

set -euo pipefail
here=$(cd -P "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
start=${HELIOS_README_START:-$(date +%s)}
# shellcheck source=times.sh
source "$here/times.sh"

print_commands() {
  awk '/^```/ { shown = !inside && $0 == "```"; inside = !inside; next } shown' "$clone/README.md"
}

write_files() { # FOLDER
  mkdir -p "$1"
  awk -v folder="$1" '
    /^```/ { inside = !inside; if (!inside) name = ""; next }
    inside && name != "" { print > (folder "/" name); next }
    NF { name = "" }
    match($0, /`[^`\/]+\.[a-z]+`:$/) { name = substr($0, RSTART + 1, RLENGTH - 3) }' "$clone/README.md"
}

# A display, of one's own where there is none and Xvfb is installed.
start_display() {
  [ -z "${DISPLAY:-}" ] && command -v Xvfb >/dev/null || return 0
  local number=$clone/build/display
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset 3>"$number" 2>/dev/null &
  trap 'kill $! 2>/dev/null' EXIT
  until [ -s "$number" ]; do sleep 0.1; done
  DISPLAY=:$(cat "$number")
  export DISPLAY
}

# A program that stays until its window is closed.
run_window() { # COMMAND
  local window
  bash -c "$1" &
  if ! window=$(timeout 300 xdotool search --sync --onlyvisible --name '^vtkHelios' | head -1); then
    kill $!
    echo "no window after 5 minutes: $1" >&2
    return 1
  fi
  sleep 10
  xdotool mousemove --window "$window" 100 100 key q
  wait $!
}

run_command() { # COMMAND
  case $1 in
    *--html*) bash -c "$1" ;;
    */vtkhelios\ view\ *) run_window "$1" ;;
    *) bash -c "$1" ;;
  esac
}

# The time at which the first point cloud was complete.
print_first_cloud() {
  local first
  first=$(find build/demo/ output -name '*_points.xyz' -newermt "@$start" -printf '%T@\n' 2>/dev/null | sort -n | head -1 || true)
  [ -z "$first" ] || echo "first point cloud: $(helios_minutes $((${first%.*} - start))) after the clone began"
}

run_all() { # FOLDER
  local command
  command -v xdotool >/dev/null || { echo "install xdotool: it closes the windows" >&2 && return 1; }
  write_files "$1"
  cd "$1"
  if [ "$PWD" != "$clone" ]; then
    ln -sfn "$clone/build" "$clone/Apps" .
  fi
  while IFS= read -r command <&4; do
    start_display
    helios_time "$command" run_command "$command"
  done 4< <(print_commands)
  helios_print_times
  print_first_cloud
  ! $helios_failed
}

case ${1:-} in
  bookworm | trixie) exec "$here/clean_root.sh" "$@" --readme ;;
  --here)
    mkdir -p "$clone/build"
    run_all "${2:-$clone/build/readme}"
    ;;
  --commands) print_commands ;;
  --files) write_files "${2:?--files needs a FOLDER}" ;;
  *) sed -n 's/^# \{0,1\}//; 4,14p' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac
