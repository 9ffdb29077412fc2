# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trade-offs of accuracy and time: the public names of vtkhelios.surveys.tradeoff."""

from .surveys.tradeoff import *  # noqa: F403
