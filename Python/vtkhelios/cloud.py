# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds: the public names of vtkhelios.clouds.cloud."""

from .clouds.cloud import *  # noqa: F403
