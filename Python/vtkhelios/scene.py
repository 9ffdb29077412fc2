# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: the public names of vtkhelios.scenes.scene."""

from .scenes.scene import *  # noqa: F403
