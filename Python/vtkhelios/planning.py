# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of scan positions and flights: the public names of vtkhelios.plans and vtkhelios.flight."""

from .flight import plan_flight  # noqa: F401
from .plans.plan import *  # noqa: F403
