# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by demo.sh and Testing/run.sh: all packages to build this checkout on a fresh Debian 12
# or 13, and the build. Fast if nothing is to be done.

set -euo pipefail
cd -P "$(dirname "${BASH_SOURCE[0]}")/.."

# All packages to build, run and test vtkHelios; Docs/install.md refers to this list.
helios_packages=(
  # to build
  git g++ cmake ninja-build ccache pkgconf
  # libraries
  libvtk9-dev libembree-dev libpugixml-dev libre2-dev librandom123-dev libjsoncpp-dev libssl-dev
  libgdal-dev libgeographiclib-dev libproj-dev libopenmesh-dev libcgal-dev libeigen3-dev
  coinor-libcbc-dev liblzf-dev libpcl-dev pybind11-dev libcli11-dev libx11-dev
  # Python
  python3 python3-dev python3-venv python3-vtk9 python3-numpy python3-rich python3-matplotlib
  python3-jinja2
  # to test
  catch2 cloudcompare zsh fish python3-pytest python3-gdal python3-lxml black codespell
  # pictures without a display
  xvfb xauth libgl1-mesa-dri xdotool
)

# What differs by the release of Debian. A PyVista contemporary with its VTK, for the test of its
# interoperability; newer ones install their own vtk.
helios_release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
case $helios_release in
  bookworm) # 12: VTK 9.1
    helios_packages+=(clang-format-14)
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
  helios_install_laspy
  helios_install_pyvista
  helios_install_formats
  helios_install_exchange
  helios_install_dask
  helios_install_ruff
}

# LAS and LAZ files as scenes; Debian has no package for it. Without it their tests are skipped.
# --no-deps keeps the numpy of Debian, which its VTK was built with.
helios_install_laspy() {
  build/venv/bin/python -c 'import laspy, lazrs' 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --no-deps --timeout 10 --retries 1 \
    'laspy>=2.5,<3' 'lazrs<1' || echo "laspy cannot be installed here: LAS and LAZ files cannot be read" >&2
}

helios_install_pyvista() {
  [ ${#helios_pyvista[@]} -gt 0 ] || return 0
  build/venv/bin/python -c 'import pyvista' 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --no-deps --timeout 10 --retries 1 \
    "${helios_pyvista[@]}" || echo "PyVista cannot be installed here: its test is skipped" >&2
}

# COPC and E57 files, LAZ with waveforms of several channels, and a reader of PLY files in tests.
# Without them their tests are skipped.
helios_install_formats() {
  build/venv/bin/python -c 'import copclib, laszip, pye57, plyfile' 2>/dev/null && return
  local package
  for package in copclib laszip pye57 pyquaternion plyfile; do
    build/venv/bin/python -m pip install -q --disable-pip-version-check --no-deps --timeout 10 --retries 1 \
      "$package" || echo "$package cannot be installed here: some formats of vtkhelios convert are missing" >&2
  done
}

# Other libraries that clouds and meshes are exchanged with, and those of vtkhelios export --mcap. Without them their tests are skipped;
# those of Open3D also run if it is installed (pip install --no-deps open3d), which takes 1.4 GB.
helios_install_exchange() {
  build/venv/bin/python -c 'import pandas, trimesh, meshio, mcap, rosbags' 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --no-deps --timeout 10 --retries 1 \
    'pandas==2.2.3' 'python-dateutil<3' 'pytz' 'tzdata' 'six' 'trimesh==4.12.2' 'meshio==5.3.5' \
    'mcap==1.6.0' 'rosbags==0.11.9' 'lz4' 'ruamel.yaml' 'typing-extensions' 'zstandard' ||
    echo "pandas, trimesh, meshio, mcap and rosbags cannot be installed here: their tests are skipped" >&2
}

# Surveys on the workers of Dask; needs no numpy. Without it their tests are skipped.
helios_install_dask() {
  build/venv/bin/python -c 'import dask, distributed' 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --timeout 10 --retries 1 \
    dask distributed || echo "Dask cannot be installed here: its tests are skipped" >&2
}

# Notebooks, for Testing/run.sh --browser. Without them their test is skipped.
helios_install_notebooks() {
  build/venv/bin/python -c 'import nbclient, ipykernel' 2>/dev/null && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --timeout 10 --retries 1 \
    'nbclient==0.10.2' 'ipykernel==6.29.5' || echo "nbclient cannot be installed here: its test is skipped" >&2
}

# The linter of Testing/Integration/test_style.py; Debian has no package for it. Without it that
# test is skipped. Newer versions have other rules.
helios_install_ruff() {
  [ -x build/venv/bin/ruff ] && return
  build/venv/bin/python -m pip install -q --disable-pip-version-check --no-deps --timeout 10 --retries 1 \
    'ruff==0.17.6' || echo "ruff cannot be installed here: Python code is not linted" >&2
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
