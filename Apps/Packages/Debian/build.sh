#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds Debian packages of this checkout into build/debian: vtkhelios (command line and viewer),
# python3-vtkhelios, libvtkhelios0.3, libvtkhelios-dev. They are for the Debian that builds them.
#
#   Apps/Packages/Debian/build.sh
#   apt install ./build/debian/*.deb

# shellcheck source=../../setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../setup.sh"
helios_packages+=(dpkg-dev file help2man)

# Manual pages: one for vtkhelios, one for each command, from what --help prints.
make_manuals() { # FOLDER COMMAND...
  local folder=$1 command version
  version=$(build/bin/vtkhelios --version)
  mkdir -p "$folder"
  make_manual "$folder" vtkhelios "simulation of laser scanning" ""
  for command in "${@:2}"; do
    make_manual "$folder" "vtkhelios-$command" "$command of vtkHelios" "$command"
  done
}

make_manual() { # FOLDER NAME SUMMARY COMMAND, with the version of make_manuals
  local program=build/debian/$2
  # help2man looks for "Usage"; argparse prints "usage"
  printf '#!/bin/sh\nbuild/bin/vtkhelios %s "$@" | sed "s/^usage: /Usage: /"\n' "$4" >"$program"
  chmod +x "$program"
  COLUMNS=2000 help2man --no-info --no-discard-stderr --name "$3" \
    --version-string="$2 ${version#vtkhelios }" "$program" | gzip -9n >"$1/$2.1.gz"
  rm "$program"
}

# Completions, where Debian's bash, zsh and fish look for them.
make_completions() { # FOLDER
  local bash=$1/bash-completion/completions zsh=$1/zsh/vendor-completions fish=$1/fish/vendor_completions.d
  mkdir -p "$bash" "$zsh" "$fish"
  build/bin/vtkhelios completion bash >"$bash/vtkhelios"
  build/bin/vtkhelios completion zsh >"$zsh/_vtkhelios"
  build/bin/vtkhelios completion fish >"$fish/vtkhelios.fish"
}

helios_setup
helios_configure release "$(helios_warnings OFF)"
helios_build release vtkhelios_package vtkhelios-viewer # not the tests
helios_say "manual pages"
names=$(build/venv/bin/python -c 'from vtkhelios import cli; print(*cli.command_names())')
# shellcheck disable=SC2086 # words
make_manuals build/debian/share/man/man1 $names
helios_say "completions"
make_completions build/debian/share
helios_say "packages"
rm -f build/debian/*.deb
cpack --config build/CPackConfig.cmake -B build/debian | grep -v '^CPack.*: - '
ls -l build/debian/*.deb
