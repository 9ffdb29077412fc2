# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flight plans of airborne surveys.

>>> plan = vtkhelios.plan_flight(scene, density=8, flying_height=800)
>>> plan.survey().run_to("output", format="las")
"""

from ._plan import FlightPlan

__all__ = ["FlightPlan", "plan_flight"]


def plan_flight(scene, assets=(), name=None, **settings):
    """Plans the flight lines of an airborne survey; returns a vtkhelios.flight.FlightPlan.

    scene
        a Scene, a vtkPolyData of triangles, an algorithm that makes one, or a file: a scene (HELIOS
        XML) or a mesh.
    assets
        folders to search for scenes, scanners and platforms.
    name
        of the plan, its survey and its folder. Default: that of the scene, and _als.

    What is asked for:

    area
        what is to be scanned, in the coordinates of the scene: a polygon in WKT; a file (.geojson,
        .json, .wkt, .txt or .csv with x y per line, .vtp); a vtkPolyData of polygons; or corners
        (n x 2 [m]). GeoJSON is in degrees if the scene has a coordinate system and no corner is in it.
        Default: the box of the scene.
    density
        least pulse density of a strip [1/m2], (0, 1e6]. Default: 4.
    spacing
        instead: largest distance of pulses in a strip, along and across the path [m], (0, 1e4].
    side_overlap
        of neighbouring strips [%], [0, 90]. Default: 20.

    The instrument:

    scanner, platform
        ids in the catalogue, or "file.xml#id". Default: "rotating_als"; "airplane_linearpath", for
        unmanned scanners "copter_linearpath".
    pulse_frequency, scan_frequency
        [Hz], as supported by the scanner. Default: those of the shortest flight.
    scan_angle
        half the scan angle [deg], (0, 85]. Default: the scanner's largest, at most 45.

    The flight:

    flying_height
        height of the lines above the ground [m], (0, 1e5]: above the highest ground of the area, or
        with terrain_following above the ground below.
    min_flying_height, max_flying_height
        instead: limits of the height [m], which is chosen. Default: as nohd and the scanner's range
        require.
    nohd
        nominal ocular hazard distance: the least height above any ground of the area [m], [0, 1e5].
        Default: 0.
    terrain_following
        True: lines follow the ground below, with climbs up to max_climb [deg], [0, 89]. Default:
        False, a constant altitude; 10.
    speed; min_speed, max_speed
        over the ground [m/s], (0, 1e4]; or its limits. Default: 40 to 80, of unmanned scanners 3 to
        15.
    turn_time, turn_radius
        of a turn to the next line [s], [0, 1e5], and [m], [0, 1e6]; a time above 0 is used rather
        than the radius. Default: the radius of a coordinated turn with 20 degrees of bank, of
        unmanned scanners 30.
    heading
        of the first line, clockwise from north [deg], [0, 360]. Default: that of the shortest flight.
    cell
        of the predicted density [m], (0, 1e5]. Default: twice the nominal pulse spacing, at most
        250,000 cells.

    crs
        the coordinate system of a scene that has none, such as "EPSG:25832", for geo files.

    Raises ValueError and TypeError for a setting that is not valid or cannot be met, PipelineError
    with the messages of the file and the filters.
    """
    return FlightPlan(scene, assets, name, **settings)
