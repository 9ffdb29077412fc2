#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds vtkHelios and runs every test; first sets up what is missing (Debian 12 or 13).
#
#   Testing/run.sh              the release build, the build without optional libraries, the tests
#   Testing/run.sh --asan       also the C++ tests under address and undefined-behaviour sanitizers
#   Testing/run.sh --fuzz [N]   also N damaged files (100,000) for all readers
#   Testing/run.sh --slow       also tests marked as slow: pip install, which builds everything again
#   Testing/run.sh --tidy       also clang-tidy over all sources, by .clang-tidy
#   Testing/run.sh --browser    also pages in headless Chromium (installs 0.4 GB), and notebooks
#
# Ends with the summaries of ctest and pytest; the exit code is not 0 if a test failed.

# shellcheck source=../Apps/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../Apps/setup.sh"

usage() { sed -n 's/^# \{0,1\}//; 5,12p' Testing/run.sh; }
asan=false
fuzz=0
slow=false
tidy=false
browser=false
while [ $# -gt 0 ]; do
  case $1 in
    --asan) asan=true ;;
    --fuzz)
      fuzz=100000
      [[ ${2:-} =~ ^[0-9]+$ ]] && fuzz=$2 && shift
      ;;
    --slow) slow=true ;;
    --tidy)
      tidy=true
      helios_packages+=(clang-tidy-14)
      ;;
    --browser)
      browser=true
      helios_packages+=(chromium)
      ;;
    -h | --help) usage && exit ;;
    *) echo "unknown option $1" >&2 && usage >&2 && exit 2 ;;
  esac
  shift
done

helios_packages+=("${helios_test_packages[@]}")
helios_setup
helios_install_test_libraries
if $browser; then helios_install_notebooks; fi
failed=()

run_ctest() { # BUILD-FOLDER [ARGUMENT...]
  helios_say "ctest: $1"
  ctest --test-dir "$@" --output-on-failure --no-tests=error -j2 || failed+=("ctest in $1")
}

run_tidy() { # FILE-EXPRESSION [ARGUMENT...]
  helios_say "clang-tidy: $1"
  run-clang-tidy-14 -quiet -p build/tidy "${@:2}" "^$PWD/(Filters|Scanner|Planning|Apps)/$1" 2>/dev/null |
    sed '/^clang-tidy-14 /d' || failed+=("clang-tidy of $1")
}

if $tidy; then
  helios_configure tidy
  run_tidy '(?!.*/Testing/)'
  # Tests may be slow and spell out that a text is empty; they divide integers for patterns and
  # compare doubles by their bits.
  unchecked='-performance-*,-readability-*,-cert-err34-c'
  unchecked+=',-bugprone-integer-division,-bugprone-suspicious-memory-comparison'
  run_tidy '.*/Testing/' -checks="$unchecked"
fi

helios_configure minimal -DVTKHELIOS_WRAP_PYTHON=OFF "$(helios_warnings ON)"
helios_build minimal
run_ctest build/minimal --label-exclude "ScannerSurvey|ScannerRun" # long, and the same without the libraries
if $asan; then
  helios_configure asan
  helios_build asan
  ASAN_OPTIONS=detect_leaks=0 run_ctest build/asan
fi

helios_configure release "$(helios_warnings ON)"
helios_build release
run_ctest build

helios_say "pytest"
kinds=(-m "not slow")
$slow && kinds=()
build/venv/bin/python -m pytest -n 2 --dist loadfile "${kinds[@]}" || failed+=(pytest)

if [ "$fuzz" -gt 0 ]; then
  helios_say "fuzz: $fuzz damaged files"
  build/venv/bin/python Testing/Fuzz/fuzz.py --cases "$fuzz" || failed+=(fuzz)
fi

for what in "${failed[@]}"; do
  echo "FAILED: $what" >&2
done
[ ${#failed[@]} -eq 0 ]
