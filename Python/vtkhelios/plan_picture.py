# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of plans: the public names of vtkhelios.reports.plan_picture."""

from .reports.plan_picture import *  # noqa: F403
