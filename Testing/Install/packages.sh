#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages of Apps/Packages/Debian/build.sh in a clean Debian, and uses them there: the
# manual, the survey of README.md, its cloud in Python, a picture of the viewer, a project with the
# headers. Root.
#
#   Testing/Install/packages.sh [FOLDER [RELEASE [MIRROR]]]
#
# FOLDER: of the clean Debian, used again if it is there; default $TMPDIR/vtkhelios-packages.
# RELEASE: bookworm (default) or trixie, the one that built the packages.

set -euo pipefail
cd -P "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=../../Apps/debian_root.sh
source Apps/debian_root.sh

case ${1:-} in
  -h | --help) sed -n 's/^# \{0,1\}//; 4,11p' Testing/Install/packages.sh && exit ;;
esac
packages=("${HELIOS_DEBS:-build/debian}"/*.deb)
[ -e "${packages[0]}" ] || { echo "run Apps/Packages/Debian/build.sh first" >&2; exit 1; }
helios_own_mounts Testing/Install/packages.sh "$@"

helios_make_root "${2:-bookworm}" "$(realpath -m "${1:-${TMPDIR:-/tmp}/vtkhelios-packages}")" "${3:-}"
trial=$helios_root/opt/trial
rm -rf "$trial"
mkdir -p "$trial"
cp "${packages[@]}" "$trial"
Testing/Install/readme.sh --files "$trial"
cp -r Testing/Install/main.cxx Testing/Install/own* Testing/Install/CMakeLists.txt "$trial"

helios_enter sh -c 'apt-get update -q && apt-get install -y -q --no-install-recommends man-db \
  xvfb xauth libgl1-mesa-dri desktop-file-utils cmake ninja-build g++ /opt/trial/*.deb' \
  >"$trial/apt.log" 2>&1 || { tail -20 "$trial/apt.log" >&2; exit 1; }

cat >"$trial/use.sh" <<'USE'
set -eux
cd /opt/trial
vtkhelios --version
man vtkhelios-run | grep -q -- --resume
desktop-file-validate /usr/share/applications/vtkhelios.desktop
vtkhelios run my_survey.xml --quiet
test "$(wc -l <output/yard/leg000_points.xyz)" -gt 10000
python3 -c 'import vtkhelios; print(len(vtkhelios.read_survey("my_survey.xml").run()), "echoes")'
xvfb-run -a vtkhelios view output/yard --offscreen --still picture.png
test -s picture.png
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build build >/dev/null
build/own_deflector
USE
helios_enter bash /opt/trial/use.sh
echo "the packages work; a picture of the viewer is $trial/picture.png"
