# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pulse shapes from measured waveforms: the public names of vtkhelios.surveys.measured_pulse."""

from .surveys.measured_pulse import *  # noqa: F403
