# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A field of maize, scanned from a tripod beside it: files, echoes, pictures.

    xvfb-run -a build/venv/bin/python Python/examples/crop_field.py field

creates the folder field: the plants (crop_field.obj, .mtl), the scene and the survey of a tripod
(crop_field_scene.xml, crop_field.xml), which can also be run by `vtkhelios run
field/crop_field.xml`; and draws the scene (scene.png) and the cloud by height (cloud.png, and from
above: shadows.png), if there is a display. As every echo has its triangle, missed triangles are
known, too.
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import vtkhelios

SCENE = """\
<?xml version="1.0" encoding="UTF-8"?>
<document>
  <scene id="crop_field" name="Field of maize">
    <part id="field">
      <filter type="objloader">
        <param type="string" key="filepath" value="crop_field.obj"/>
      </filter>
    </part>
  </scene>
</document>
"""

SURVEY = """\
<?xml version="1.0" encoding="UTF-8"?>
<document>
  <survey name="crop_field" platform="Assets/platforms.xml#tripod"
          scanner="Assets/scanners.xml#vz400_class_tls" scene="crop_field_scene.xml#crop_field">
    <leg>
      <platformSettings x="{x:g}" y="{y:g}" onGround="true"/>
      <scannerSettings active="true" pulseFreq_hz="300000" scanFreq_hz="{lines:g}"
                       verticalAngleMin_deg="-40" verticalAngleMax_deg="60"
                       headRotateStart_deg="{start:g}" headRotateStop_deg="{stop:g}"
                       headRotatePerSec_deg="{speed:g}" trajectoryTimeInterval_s="1"/>
    </leg>
  </survey>
</document>
"""

COLOURS = {  # colours of the picture of the scene, by material
    "soil": (0.52, 0.41, 0.30),
    "crop_stem": (0.58, 0.66, 0.36),
    "crop_leaf": (0.35, 0.60, 0.25),
    "crop_ear": (0.85, 0.75, 0.42),
}


def make_field(rows=20, row_length=15.0):
    """Maize in June, hip-high: every leaf of every plant."""
    return vtkhelios.vtkHeliosCropFieldSource(
        species="maize",
        number_of_rows=rows,
        row_length=row_length,  # m
        plant_height=1.0,  # m
        plant_height_deviation=0.08,
        stem_radius=0.01,
        leaves_per_plant=9,
        leaf_length=0.6,
        leaf_width=0.07,
        emergence=0.93,
        ground_margin=3,
        seed=1,
    )


def write_files(field, folder, x, y, lines, speed):
    """The OBJ file, the scene that uses it, and a survey from that position [m]."""
    folder.mkdir(parents=True, exist_ok=True)
    writer = vtkhelios.vtkHeliosObjSceneWriter(file_name=str(folder / "crop_field.obj"))
    (field >> writer).last.Write()
    (folder / "crop_field_scene.xml").write_text(SCENE)
    # The head rotates from the right over the front to the left: the field lies along y.
    text = SURVEY.format(x=x, y=y, lines=lines, speed=speed, start=-90, stop=90)
    (folder / "crop_field.xml").write_text(text)
    return folder / "crop_field.xml"


def find_seen(scene, cloud):
    """The fractions of plants, and of their leaf area, with an echo."""
    parts = vtk_to_numpy(scene.GetCellData().GetArray("PartIds"))
    seen = np.zeros(len(parts), dtype=bool)
    seen[cloud["CellIds"]] = True  # triangles in the file are in field order
    corners = vtk_to_numpy(scene.GetPoints().GetData())[
        vtk_to_numpy(scene.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    ]
    sides = corners[:, 1:] - corners[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
    leaves = materials_of(scene) == "crop_leaf"
    plants = len(np.unique(parts[seen & (parts > 0)])) / parts.max()
    return plants, area[leaves & seen].sum() / area[leaves].sum()


def materials_of(scene):
    """The name of the material of every triangle."""
    table = scene.GetFieldData().GetAbstractArray("Material.Name")
    names = np.array([table.GetValue(i) for i in range(table.GetNumberOfValues())])
    return names[vtk_to_numpy(scene.GetCellData().GetArray("MaterialIds"))]


def draw_scene(scene, output, title, **look):
    """A picture of triangles, lit as in vtkhelios.picture."""
    from vtkhelios import picture

    names, index = np.unique(materials_of(scene), return_inverse=True)
    rgb = (np.array([COLOURS[name] for name in names]) * 255).astype(np.uint8)[index]
    coloured = vtkPolyData()
    coloured.CopyStructure(scene)
    coloured.GetCellData().SetScalars(numpy_to_vtk(rgb, deep=True))
    picture.save_mesh_picture(coloured, output, title=title, **look)


def main(folder="crop_field", rows=20, row_length=15.0, lines=100, speed=7.2, draw=True):
    folder = pathlib.Path(folder)
    field = make_field(rows, row_length)
    scene = vtkhelios.update(field)
    truth = scene.GetFieldData()
    plants = truth.GetArray("Plant.Height").GetNumberOfValues()
    index = truth.GetArray("Field.LeafAreaIndex").GetValue(0)
    print(f"{plants:,} plants, {scene.GetNumberOfCells():,} triangles, leaf area index {index:.2f}")

    file = write_files(field, folder, 0.0, -row_length / 2 - 2.0, lines, speed)
    survey = vtkhelios.read_survey(file)
    cloud = survey.run(seed=1)
    seen = find_seen(scene, cloud)
    print(f"{survey.number_of_pulses:,} pulses, {len(cloud):,} echoes")
    print(
        f"echoes from {seen[0]:.1%} of the plants; of {seen[1]:.1%} of the leaf area (triangles hit)"
    )
    if draw:
        scanner = survey.trajectory(0).points[0] + [0, 0, 1.7]  # m, above the tripod's foot point
        draw_pictures(folder, scene, cloud, scanner)
    return dict(survey=survey, cloud=cloud, plants=plants, seen=seen)


def draw_pictures(folder, scene, cloud, scanner):
    from vtkhelios import picture

    if not picture.can_render():
        print(f"no pictures: {picture.NO_DISPLAY}", file=sys.stderr)
        return
    title = "Maize beside one scan position"
    draw_scene(scene, folder / "scene.png", f"{title}: the scene", azimuth=205.0, elevation=14.0)
    one_class = np.zeros(len(cloud), dtype=int)  # so it is coloured by height
    echoes = (cloud.points, cloud["Amplitude"], one_class)
    for name, elevation in (("cloud", 14.0), ("shadows", 70.0)):
        picture.save_picture(
            [echoes],
            folder / f"{name}.png",
            marks=[scanner],
            title=f"{title}: echoes by height",
            azimuth=205.0,
            elevation=elevation,
            point_size=1.0,
        )


if __name__ == "__main__":
    main(*sys.argv[1:2])
