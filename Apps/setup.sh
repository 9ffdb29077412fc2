# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by demo.sh and Testing/run.sh: all packages to build this checkout on a fresh Debian 12
# or 13, and the build. Fast if nothing is to be done.

set -euo pipefail
cd -P "$(dirname "${BASH_SOURCE[0]}")/.."

# All packages to build and run vtkHelios; Docs/install.md refers to this list.
helios_packages=(
  # to build
  git g++ cmake ninja-build ccache pkgconf
  # libraries
  libvtk9-dev libembree-dev libpugixml-dev libyaml-dev libre2-dev librandom123-dev libjsoncpp-dev libssl-dev
  libgdal-dev libgeographiclib-dev libproj-dev libopenmesh-dev libcgal-dev libeigen3-dev
  coinor-libcbc-dev liblzf-dev libpng-dev libjpeg-dev libtiff-dev libpcl-dev pybind11-dev libcli11-dev libx11-dev
  # Python
  python3 python3-dev python3-venv python3-vtk9 python3-numpy python3-rich python3-matplotlib
  python3-jinja2
  # the tests that are built
  catch2
  # pictures without a display, and the font of the viewer
  xvfb xauth libgl1-mesa-dri fonts-dejavu-core
)
# What tests need besides.
helios_test_packages=(
  cloudcompare python3-pytest python3-pytest-xdist python3-gdal python3-pil imagemagick python3-lxml python3-yaml black codespell strace
  xdotool zsh fish
)

# What differs by the release of Debian. A PyVista contemporary with its VTK, for the test of its
# interoperability; newer ones install their own vtk.
helios_release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
case $helios_release in
  bookworm) # 12: VTK 9.1
    helios_test_packages+=(clang-format-14)
    helios_pyvista=('pyvista==0.36.1' 'scooby<1' 'appdirs<2')
    ;;
  trixie) # 13: VTK 9.3
    helios_pyvista=('pyvista==0.44.2' 'scooby<1' 'pooch<2' 'platformdirs<5')
    ;;
  *)
    echo "this system is not Debian 12 or 13 (bookworm, trixie) but ${helios_release:-without a name}:" \
      "its packages may have other names" >&2
    helios_pyvista=()
    ;;
esac

helios_say() { printf '\n== %s\n' "$*"; }

helios_install_packages() {
  local missing=() package
  for package in "${helios_packages[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "run as root: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  helios_say "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends -o DPkg::Lock::Timeout=300 "${missing[@]}"
}

# The Python of build/bin/vtkhelios: Debian's, which VTK's modules are built for. It finds the
# package of this build by itself.
helios_make_venv() {
  [ -x build/venv/bin/python ] || /usr/bin/python3 -m venv --system-site-packages build/venv
  local site
  for site in build/venv/lib/python3*/site-packages; do
    echo ../../../../lib/python3/dist-packages >"$site/vtkhelios.pth"
  done
  # LAS, LAZ, COPC and E57 files; Debian has no packages for them.
  helios_pip 'import laspy, lazrs' "laspy: records of LAS in vtkhelios convert; lazrs: the tests" \
    --no-deps 'laspy>=2.7,<3' 'lazrs<1'
  helios_pip 'import copclib, laszip, pye57, plyfile' "pye57: E57; copclib, laszip, plyfile: the tests" \
    --no-deps copclib laszip pye57 pyquaternion plyfile
}

# helios_pip IMPORT WHAT PIP-ARGUMENT...: installs into build/venv unless the import works there.
# Without the packages something is missing or tests are skipped, but no more. --no-deps keeps the
# numpy of Debian, which its VTK was built with.
helios_pip() {
  build/venv/bin/python -c "$1" 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --timeout 10 --retries 1 \
    "${@:3}" || echo "cannot be installed here: $2" >&2
}

# What tests need in build/venv; without it they are skipped. Newer versions of ruff have other rules.
helios_install_test_libraries() {
  [ ${#helios_pyvista[@]} -eq 0 ] ||
    helios_pip 'import pyvista' "PyVista" --no-deps "${helios_pyvista[@]}"
  helios_pip 'import pandas, trimesh, meshio, mcap, rosbags.rosbag2' "pandas, trimesh, meshio, mcap, rosbags" \
    --no-deps 'pandas==2.2.3' 'python-dateutil<3' pytz tzdata six 'trimesh==4.12.2' 'meshio==5.3.5' \
    'mcap==1.6.0' 'rosbags==0.11.9' apsw backports.zstd lz4 ruamel.yaml typing-extensions zstandard
  helios_pip 'import dask, distributed' "Dask" dask distributed
  helios_pip 'import mypy.api, pathspec; pathspec.GitIgnoreSpec' "mypy" 'mypy==2.4.1'
  helios_pip 'import ruff' "ruff" --no-deps 'ruff==0.17.6'
}

# Notebooks, for Testing/run.sh --browser.
helios_install_notebooks() {
  helios_pip 'import nbclient, ipykernel' "nbclient and ipykernel" 'nbclient==0.10.2' 'ipykernel==6.29.5' \
    'matplotlib-inline<0.2' # newer ones need a newer matplotlib than Debian's
}

# helios_warnings ON|OFF: the argument of CMake that makes warnings errors in build/, or not. A build
# that is there already keeps what it has, since a change compiles everything again.
helios_warnings() {
  local kept
  kept=$(sed -n 's/^VTKHELIOS_WARNINGS_AS_ERRORS:BOOL=//p' build/CMakeCache.txt 2>/dev/null || true)
  echo "-DVTKHELIOS_WARNINGS_AS_ERRORS=${kept:-$1}"
}

# helios_configure PRESET [CMAKE-ARGUMENT...]: one of CMakePresets.json.
helios_configure() {
  local log=build/configure-$1.log
  helios_say "configuring: $1"
  cmake --preset "$@" >"$log" 2>&1 || {
    cat "$log" >&2
    return 1
  }
}

# helios_build PRESET [TARGET...]: everything without a target.
helios_build() {
  local preset=$1
  shift
  helios_say "building: $preset"
  cmake --build --preset "$preset" ${1:+--target "$@"}
}

helios_setup() {
  helios_install_packages
  mkdir -p build
  helios_make_venv
}
