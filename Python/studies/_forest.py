# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A forest of synthetic trees on level ground."""

import numpy as np

import vtkhelios

MODELS = (("Conifer", 1), ("Conifer", 2), ("Conifer", 3), ("Broadleaf", 4))
MODEL_HEIGHT, LEAVES = 14.0, 4000  # height and leaves of a model
DENSITY = 0.08  # trees/m²
HEIGHTS = 10.5, 4.0, 3.0, 22.0  # mean, standard deviation, smallest, largest [m]
SPACING = 1.6  # between stems [m]
BORDER = 60.0  # border of ground around the trees [m]

MATERIALS = """\
newmtl ground
helios_reflectance 0.3
helios_classification 2
helios_isGround true
"""
PART = """\
    <part id="{name}">
      <filter type="objloader"><param type="string" key="filepath" value="{file}"/></filter>{place}
    </part>
"""
PLACE = """
      <filter type="rotate">
        <param type="rotation" key="rotation"><rot axis="z" angle_deg="{turn:.1f}"/></param>
      </filter>
      <filter type="scale"><param type="double" key="scale" value="{scale:.3f}"/></filter>
      <filter type="translate">
        <param type="vec3" key="offset" value="{x:.3f};{y:.3f};{z:.3f}"/>
      </filter>"""


def place_trees(side, seed=1):
    """Rows x, y (from the centre), height [m], turn [deg], model of random trees in a square."""
    random = np.random.default_rng(seed)
    trees = np.empty((0, 2))
    for _ in range(int(40 * DENSITY * side**2)):
        if len(trees) >= DENSITY * side**2:
            break
        place = random.uniform(-side / 2, side / 2, 2)
        if not len(trees) or np.linalg.norm(trees - place, axis=1).min() > SPACING:
            trees = np.vstack([trees, place])
    mean, spread, low, high = HEIGHTS
    heights = np.clip(random.normal(mean, spread, len(trees)), low, high)
    turns = random.uniform(0, 360, len(trees))
    return np.column_stack([trees, heights, turns, random.integers(0, len(MODELS), len(trees))])


def write_forest(folder, centre, ground, side):
    """Writes a scene of trees in a square around a centre, and returns "file#id"."""
    (folder / "forest.mtl").write_text(MATERIALS)
    (x, y), reach = centre, side / 2 + BORDER
    corners = (
        (x - reach, y - reach),
        (x + reach, y - reach),
        (x + reach, y + reach),
        (x - reach, y + reach),
    )
    text = "mtllib forest.mtl\nusemtl ground\n"
    text += "".join(f"v {a:.3f} {b:.3f} {ground:.3f}\n" for a, b in corners)
    (folder / "ground_of_forest.obj").write_text(f"{text}f 1 2 3 4\n")
    for number, (species, seed) in enumerate(MODELS):
        tree = vtkhelios.vtkHeliosSyntheticScene(height=MODEL_HEIGHT, number_of_leaves=LEAVES)
        tree.SetKindToTree()
        getattr(tree, f"SetSpeciesTo{species}")()
        tree.SetSeed(seed)
        vtkhelios.Scene(vtkhelios.update(tree)).write(folder / f"tree{number}.obj")
    parts = [PART.format(name="ground", file="ground_of_forest.obj", place="")]
    for number, row in enumerate(place_trees(side)):
        place = PLACE.format(
            turn=row[3], scale=row[2] / MODEL_HEIGHT, x=x + row[0], y=y + row[1], z=ground
        )
        parts.append(PART.format(name=f"tree{number}", file=f"tree{int(row[4])}.obj", place=place))
    scene = f'<document>\n  <scene id="forest" name="Forest">\n{"".join(parts)}  </scene>\n</document>\n'
    (folder / "forest.xml").write_text(scene)
    return "forest.xml#forest"
