# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""All targets by name. To add one: a Target in a module of its kind, and in its make_targets()."""

from . import (
    targets_image,
    targets_json,
    targets_mesh,
    targets_points,
    targets_run,
    targets_scene,
    targets_survey,
    targets_tables,
)

MODULES = (
    targets_points,
    targets_scene,
    targets_mesh,
    targets_image,
    targets_survey,
    targets_run,
    targets_tables,
    targets_json,
)
ALL = {target.name: target for module in MODULES for target in module.make_targets()}
