#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes the files of a release of the commit that is checked out here, in dist: Debian packages of
# both releases, wheels, the documentation site, the sources, licenses, and their checksums. Each is
# built in a clean Debian in a folder and tried in another one. As root; needs debootstrap.
#
#   Testing/Install/release.sh [OPTION...]
#
#   --only PARTS      some of debian,wheels,site,sources, with commas (default: all); the checksums
#                     are those of all files in dist
#   --release NAME    bookworm or trixie; repeatable (default: both)
#   --python PYTHON   a CPython with headers for one more wheel; repeatable (default: python3.12 and
#                     python3.13 where this system has them)
#   --folder FOLDER   of these, about 10 GB a release; default: vtkhelios-release in $TMPDIR or /tmp
#   --mirror MIRROR   of Debian's packages; default: the first one of this system
#   --no-test         build without trying
#   --list            prints what would be made, and makes nothing
#
# Wheels are built on bookworm: for its own Python, 3.11, and for each PYTHON, whose prefix is shown
# in that Debian. What is in the folder is used again. Each Debian has a cache of ccache, or that of
# CCACHE_DIR if this is set. The exit code is not 0 if a part failed.

set -euo pipefail
here=$(cd -P "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
# shellcheck source=../../Apps/debian_root.sh
source "$source/Apps/debian_root.sh"
# shellcheck source=times.sh
source "$here/times.sh"
dist=$source/dist

usage() { sed -n 's/^# \{0,1\}//; 4,22p' "$here/release.sh"; }
fail() { echo "$1" >&2 && usage >&2 && exit 2; }

read_arguments() {
  parts=debian,wheels,site,sources releases=() pythons=() folder='' mirror='' tests=true lists=false
  while [ $# -gt 0 ]; do
    case $1 in
      --only) parts=${2:?--only needs parts} && shift ;;
      --release) releases+=("${2:?--release needs a name}") && shift ;;
      --python) pythons+=("${2:?--python needs a program}") && shift ;;
      --folder) folder=${2:?--folder needs a folder} && shift ;;
      --mirror) mirror=${2:?--mirror needs an address} && shift ;;
      --no-test) tests=false ;;
      --list) lists=true ;;
      -h | --help) usage && exit ;;
      *) fail "$1 is not an option" ;;
    esac
    shift
  done
  local part
  for part in ${parts//,/ }; do
    case $part in debian | wheels | site | sources) ;; *) fail "$part is not a part of a release" ;; esac
  done
  [ ${#releases[@]} -gt 0 ] || releases=(bookworm trixie)
  for part in "${releases[@]}"; do
    case $part in bookworm | trixie) ;; *) fail "$part is not a release: bookworm or trixie" ;; esac
  done
  folder=$(realpath -m "${folder:-${TMPDIR:-/tmp}/vtkhelios-release}")
  found=()
  ! has wheels || find_pythons
}

# The Pythons of more wheels, as their programs: a shim of a version manager is none.
find_pythons() {
  local given=("${pythons[@]}") name program
  [ ${#given[@]} -gt 0 ] || given=(python3.12 python3.13)
  for name in "${given[@]}"; do
    program=$("$name" -c 'import os, sys, sysconfig
assert os.path.exists(sysconfig.get_path("include") + "/Python.h")
print(os.path.realpath(sys.executable))' 2>/dev/null) && found+=("$program") && continue
    [ ${#pythons[@]} -eq 0 ] || fail "$name is no CPython with headers"
    [ -n "${HELIOS_OWN_MOUNTS:-}" ] || echo "$name is not here, or without headers: no wheel for it"
  done
}

has() { [[ ,$parts, == *,$1,* ]]; }

list() {
  local release program
  ! has sources || echo "sources"
  for release in "${releases[@]}"; do ! has debian || echo "Debian packages for $release"; done
  ! has site || echo "site"
  ! has wheels || echo "wheel for CPython 3.11"
  for program in "${found[@]}"; do ! has wheels || echo "wheel for $program"; done
}

# enter_clone RELEASE: makes the Debian of a release with a clone of the commit, as helios_root.
enter_clone() {
  helios_make_root "$1" "$folder/$1" "$mirror"
  helios_enter sh -c 'command -v git >/dev/null || { apt-get update -q && apt-get install -y -q --no-install-recommends git ca-certificates; }' >/dev/null
  show_folder "$source" /mnt/source
  helios_enter git config --global safe.directory '*'
  [ -d "$helios_root/opt/vtkhelios/.git" ] ||
    helios_enter git clone -q --no-hardlinks --no-checkout /mnt/source /opt/vtkhelios
  in_clone git fetch -q /mnt/source HEAD
  in_clone git checkout -q --force --detach FETCH_HEAD
  [ -z "${CCACHE_DIR:-}" ] || show_folder "$(realpath "$CCACHE_DIR")" /opt/ccache
}

# show_folder FOLDER AS: a folder of this system, in that Debian.
show_folder() {
  mkdir -p "$1" "$helios_root$2"
  mount --bind "$1" "$helios_root$2"
}

in_clone() { helios_enter env -C /opt/vtkhelios "$@"; }

# The build of the packages, which the site and the trial of the wheels need, too.
build_clone() {
  in_clone bash -c '. Apps/setup.sh && helios_setup && helios_configure release "$(helios_warnings OFF)" &&
    helios_build release vtkhelios_package vtkhelios-viewer'
}

# copy_built PATTERN FOLDER: files of the clone, to a folder of dist.
copy_built() {
  mkdir -p "$dist/$2"
  # shellcheck disable=SC2086 # a pattern
  cp "$helios_root"/opt/vtkhelios/$1 "$dist/$2"
}

make_debian() { # RELEASE
  enter_clone "$1"
  in_clone Apps/Packages/Debian/build.sh
  rm -f "$dist/$1"/*.deb
  copy_built 'build/debian/*.deb' "$1"
}

# In a Debian that has never seen the sources.
try_debian() { # RELEASE
  HELIOS_DEBS=$dist/$1 "$here/packages.sh" "$folder/$1-packages" "$1" ${mirror:+"$mirror"}
}

# make_wheel PYTHON: on bookworm, with the prefix of that Python.
make_wheel() {
  enter_clone bookworm
  show_prefix "$1"
  in_clone Python/wheel/build.sh "$1"
  copy_built 'dist/vtkhelios-*.whl' .
}

show_prefix() { # PYTHON
  local prefix
  [ "$1" != /usr/bin/python3 ] || return 0
  prefix=$("$1" -c 'import sys; print(sys.base_prefix)')
  show_folder "$prefix" "$prefix"
}

# Beside Debian's own build and PyPI's VTK: test_wheel.py.
try_wheel() { # PYTHON
  enter_clone bookworm
  show_prefix "$1"
  build_clone
  helios_enter sh -c 'python3 -c "import pytest" 2>/dev/null || apt-get install -y -q --no-install-recommends python3-pytest' >/dev/null
  in_clone env HELIOS_PYTHON="$1" build/venv/bin/python -m pytest -q Python/wheel/test_wheel.py
}

make_site() {
  enter_clone bookworm
  build_clone
  in_clone Docs/site/build.sh
  tar -C "$helios_root/opt/vtkhelios/build/site" --sort=name --owner=0 --group=0 \
    --transform "s,^html,vtkhelios-$version-site," -czf "$dist/vtkhelios-$version-site.tar.gz" html
}

make_sources() {
  git -C "$source" archive --prefix="vtkhelios-$version/" -o "$dist/vtkhelios-$version.tar.gz" HEAD
}

# The licenses of what is in the files: ours, and those of what is in our sources or data. Packages
# and wheels have those of the libraries that they bring or use.
make_licenses() {
  mkdir -p "$dist/licenses"
  cp "$source/LICENSE" "$dist/licenses/vtkHelios.txt"
  cp "$source/Filters/IO/LASzip/COPYING.txt" "$dist/licenses/LASzip.txt"
  cp "$source/Python/vtkhelios/webcloud/page/twgl-license.txt" "$dist/licenses/twgl.txt"
  cp "$source/Data/DATA_LICENSES.md" "$dist/licenses/data.md"
}

make_checksums() {
  (cd "$dist" && find . -type f ! -name SHA256SUMS -printf '%P\n' | sort | xargs -d '\n' sha256sum >SHA256SUMS &&
    sha256sum --quiet -c SHA256SUMS)
}

# step NAME COMMAND...: unless --no-test leaves it out.
try() { ! $tests || helios_time "$@"; }

read_arguments "$@"
if $lists; then
  list
  exit
fi
helios_own_mounts "$here/release.sh" "$@"
version=$(sed -n 's/^project(vtkHelios VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
mkdir -p "$dist" "$folder"
helios_time licenses make_licenses
! has sources || helios_time sources make_sources
if has debian; then
  for release in "${releases[@]}"; do
    helios_time "packages for $release" make_debian "$release"
    try "packages for $release in a clean Debian" try_debian "$release"
  done
fi
! has site || helios_time site make_site
if has wheels; then
  for program in /usr/bin/python3 "${found[@]}"; do
    helios_time "wheel for $program" make_wheel "$program"
    try "wheel for $program beside PyPI's VTK" try_wheel "$program"
  done
fi
helios_time checksums make_checksums
helios_print_times
cat "$dist/SHA256SUMS"
! $helios_failed
