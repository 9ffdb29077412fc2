#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Builds the documentation site: the documents of this checkout, the commands, and every class.
#
#   Docs/site/build.sh [FOLDER]    build/site/html by default; open index.html in a browser
#
# Needs the build of Apps/demo.sh or Testing/run.sh. The first time it installs Sphinx into
# build/site/venv; after that it needs no network. A broken link is an error.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

case ${1:-} in
  -h | --help) sed -n 's/^# \{0,1\}//; 4,9p' Docs/site/build.sh && exit ;;
esac
output=${1:-build/site/html}
if [ ! -x build/venv/bin/python ]; then
  echo "build/venv is missing: run Apps/demo.sh first" >&2
  exit 1
fi

tools=build/site/venv
if ! cmp -s Docs/site/requirements.txt "$tools/requirements.txt"; then
  build/venv/bin/python -m venv --clear "$tools"
  "$tools/bin/python" -m pip install -q --disable-pip-version-check -r Docs/site/requirements.txt
  cp Docs/site/requirements.txt "$tools/"
fi

PYTHONPATH=Docs/site build/venv/bin/python -m pages build/site/source
"$tools/bin/python" -m sphinx -q -W --keep-going -j auto -d build/site/doctrees \
  -c Docs/site build/site/source "$output"
echo "$output/index.html"
