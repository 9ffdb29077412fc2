# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flight plans of airborne surveys.

>>> plan = vtkhelios.plan_flight(scene, density=8, flying_height=800)
>>> plan.survey().run_to("output", format="las")
"""

__all__ = ["FlightPlan"]


def __getattr__(name):
    if name == "FlightPlan":  # late: the options of the command line need the settings only
        from ._plan import FlightPlan

        return FlightPlan
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
