# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Instruments from the metadata of sensors: the public names of vtkhelios.surveys.instruments."""

from .surveys.instruments import *  # noqa: F403
