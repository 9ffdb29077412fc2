# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys: the public names of vtkhelios.surveys.survey."""

from .surveys.survey import *  # noqa: F403
