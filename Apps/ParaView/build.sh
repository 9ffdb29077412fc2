#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the ParaView plugin in a Debian 12 of its own, since python3-paraview cannot be installed
# beside python3-vtk9, and tries it there with pvpython and two ranks of pvbatch. Run as root, after
# Apps/demo.sh or Testing/run.sh. Continues where an earlier call ended.
#
#   Apps/ParaView/build.sh [ROOT [MIRROR]]
#
# ROOT: the folder of that Debian, about 5 GB; default build/paraview. MIRROR: of Debian packages;
# default: the first one of this system. The plugin is then ROOT/vtkhelios/build/lib/.../vtkHelios.so.

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
root=$(realpath -m "${1:-$here/build/paraview}")
mirror=${2:-}
# shellcheck source=../debian_root.sh
source "$here/Apps/debian_root.sh"

# What paraview-dev does not depend on although its CMake files look for it, and our own libraries.
packages=(
  paraview-dev python3-paraview mpi-default-dev g++ cmake ninja-build ccache pkgconf
  qtbase5-dev qttools5-dev qtdeclarative5-dev libqt5opengl5-dev libqt5svg5-dev libqt5x11extras5-dev
  libdouble-conversion-dev libutfcpp-dev libeigen3-dev libboost-dev libprotobuf-dev protobuf-compiler
  libhdf5-dev libnetcdf-dev libcgns-dev libxml2-dev libexpat1-dev nlohmann-json3-dev libfmt-dev
  libgl2ps-dev libglew-dev libxt-dev libfreetype-dev libjpeg-dev libpng-dev libtiff-dev libogg-dev
  libtheora-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev liblz4-dev liblzma-dev
  libpugixml-dev libyaml-dev libre2-dev librandom123-dev libjsoncpp-dev libssl-dev libgdal-dev
  libgeographiclib-dev libproj-dev liblzf-dev
  python3-dev python3-numpy python3-mpi4py xvfb xauth libgl1-mesa-dri
)

say() { printf '\n== %s\n' "$*"; }

make_root() {
  helios_make_root bookworm "$root" "$mirror"
  mkdir -p "$root/vtkhelios/source" "$root/vtkhelios/build" "$root/vtkhelios/trial"
  mount --bind "$here" "$root/vtkhelios/source"
}

# enter COMMAND...: in that Debian.
enter() {
  helios_enter env CCACHE_DIR=/vtkhelios/ccache OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "$@"
}

install_packages() {
  enter dpkg -s "${packages[@]}" >/dev/null 2>&1 && return
  say "packages"
  enter apt-get update -q
  enter apt-get install -y -q --no-install-recommends "${packages[@]}"
}

build_plugin() {
  say "building"
  enter cmake -G Ninja -S /vtkhelios/source/Apps/ParaView -B /vtkhelios/build >"$root/vtkhelios/configure.log" 2>&1 ||
    { cat "$root/vtkhelios/configure.log" >&2; return 1; }
  enter cmake --build /vtkhelios/build
}

# A survey of the tests, and its echoes by the vtkhelios of this clone.
make_trial() {
  local trial=$root/vtkhelios/trial
  "$here/build/venv/bin/python" - "$here/Python/tests" "$trial" <<'PYTHON'
import pathlib
import sys

sys.path.insert(0, sys.argv[1])
import _small_run

_small_run.write_survey(pathlib.Path(sys.argv[2]))
PYTHON
  "$here/build/bin/vtkhelios" run "$trial/survey.xml" --seed 5 --output "$trial/output" --overwrite --quiet
  cat "$trial"/output/fence/leg*_points.xyz >"$trial/points.xyz"
}

try_plugin() {
  local plugin
  plugin=$(cd "$root" && find vtkhelios/build -name vtkHelios.so | head -1)
  # ParaView opens a window and closes it first, after which the server would reset.
  local server=(xvfb-run -a -s "-screen 0 1280x1024x24 -noreset")
  local trial=(/vtkhelios/source/Apps/ParaView/try_plugin.py "/$plugin" /vtkhelios/trial)
  make_trial
  say "pvpython"
  enter "${server[@]}" pvpython "${trial[@]}"
  say "pvbatch, two ranks"
  enter "${server[@]}" mpiexec -n 2 --oversubscribe pvbatch "${trial[@]}"
  say "the plugin: $root/$plugin"
}

helios_own_mounts "${BASH_SOURCE[0]}" "$root" "$mirror"
make_root
install_packages
build_plugin
try_plugin
