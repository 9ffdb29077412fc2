#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Sets up and builds what is missing (Debian 12 or 13), generates a village, scans it from a tripod and
# from the air, draws a picture of the point clouds, and builds the viewer. Output: build/demo.

# shellcheck source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

helios_setup
export CCACHE_DISABLE=1 # a first build has no cache hits, and filling it takes time
helios_configure release "$(helios_warnings OFF)"
helios_build release vtkhelios_core # sufficient for the clouds

demo=build/demo
python=build/venv/bin/python
mkdir -p "$demo"

helios_say "making the scene"
"$python" Data/Scenes/make_village.py "$demo/scene"

for survey in village_tls village_als; do
  helios_say "running Data/Surveys/$survey.xml"
  build/bin/vtkhelios run "Data/Surveys/$survey.xml" --assets Data --assets "$demo/scene" \
    --output "$demo" --overwrite
done

helios_say "drawing the picture"
clouds=("$demo"/village_tls/*_points.xyz "$demo"/village_als/*_points.xyz)
picture=$demo/village.png
display=()
[ -n "${DISPLAY:-}" ] || display=(xvfb-run -a -s "-screen 0 1280x1024x24")
"${display[@]}" "$python" -P -m vtkhelios.picture "${clouds[@]}" --output "$picture" \
  --title "a village, scanned from two positions on its lane and from the air" \
  --azimuth 210 --elevation 30 --zoom 2.0

helios_say "the clouds and the picture are ready"
for what in "${clouds[@]}"; do
  echo "point cloud  $what"
  echo "trajectory   ${what%_points.xyz}_trajectory.txt"
done
echo "picture      $picture"

helios_build release vtkhelios_package vtkhelios-viewer # last: nothing above needs the rest

helios_say "done"
echo "now try      build/bin/vtkhelios run --help"
echo "             build/bin/vtkhelios view $demo/village_tls"
