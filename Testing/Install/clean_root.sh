#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs vtkHelios as a new user does, in a clean Debian in a folder: clones the commit that is
# checked out here, runs what is asked for, and prints how long each step took. As root; needs
# debootstrap. A Debian and a clone that are in the folder are used and updated.
#
#   Testing/Install/clean_root.sh RELEASE [OPTION...]   RELEASE: bookworm (Debian 12) or trixie (13)
#
#   --demo            ./Apps/demo.sh, and the checksums of its clouds (default)
#   --tests           ./Testing/run.sh
#   --readme          all commands of README.md, by readme.sh
#   --folder FOLDER   of that Debian, about 8 GB; default: vtkhelios-RELEASE in $TMPDIR or /tmp
#   --mirror MIRROR   of Debian's packages; default: the first one of this system
#
# The clone is FOLDER/opt/vtkhelios. The exit code is not 0 if a step failed.

set -euo pipefail
here=$(cd -P "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
# shellcheck source=../../Apps/debian_root.sh
source "$source/Apps/debian_root.sh"
# shellcheck source=times.sh
source "$here/times.sh"

usage() { sed -n 's/^# \{0,1\}//; 4,17p' "$here/clean_root.sh"; }

read_arguments() {
  release='' folder='' mirror='' tasks=()
  while [ $# -gt 0 ]; do
    case $1 in
      bookworm | trixie) release=$1 ;;
      --demo | --tests | --readme) tasks+=("${1#--}") ;;
      --folder) folder=${2:?--folder needs a folder} && shift ;;
      --mirror) mirror=${2:?--mirror needs an address} && shift ;;
      -h | --help) usage && exit ;;
      *) echo "$1 is not an option, nor a release: bookworm or trixie" >&2 && usage >&2 && exit 2 ;;
    esac
    shift
  done
  [ -n "$release" ] || { echo "no release is given: bookworm or trixie" >&2 && usage >&2 && exit 2; }
  folder=$(realpath -m "${folder:-${TMPDIR:-/tmp}/vtkhelios-$release}")
  [ ${#tasks[@]} -gt 0 ] || tasks=(demo)
}

make_root() {
  helios_make_root "$release" "$folder" "$mirror"
  mkdir -p "$folder/mnt/source"
  mount --bind "$source" "$folder/mnt/source"
}

# in_clone COMMAND...: in the clone in that Debian.
in_clone() { helios_enter env -C /opt/vtkhelios "$@"; }

clone() {
  helios_enter sh -c 'command -v git >/dev/null || { apt-get update -q && apt-get install -y -q git; }'
  helios_enter git config --global safe.directory '*'
  if [ ! -d "$folder/opt/vtkhelios/.git" ]; then
    helios_enter git clone -q --no-hardlinks /mnt/source /opt/vtkhelios
  else
    in_clone git fetch -q /mnt/source HEAD
    in_clone git checkout -q --force --detach FETCH_HEAD
  fi
}

demo() {
  in_clone ./Apps/demo.sh
  in_clone sh -c 'cd build/demo && find scene village_* -type f ! -name run_summary.json | sort | xargs sha256sum'
}

tests() { in_clone ./Testing/run.sh; }

readme() {
  helios_enter apt-get install -y -q xdotool # for the script, not for the README
  in_clone env HELIOS_README_START="$began" Testing/Install/readme.sh --here .
}

read_arguments "$@"
helios_own_mounts "$here/clean_root.sh" "$@"
helios_root=$folder
helios_time "Debian $release" make_root
began=$(date +%s)
$helios_failed || helios_time clone clone
$helios_failed || for task in "${tasks[@]}"; do
  helios_time "$task" "$task"
done
helios_print_times
! $helios_failed
