# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys of scenes in memory: the public names of vtkhelios.surveys.scanning."""

from .surveys.scanning import *  # noqa: F403
