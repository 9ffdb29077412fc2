# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The colours of plans of scan positions, as red, green, blue."""

UNSEEN = (0.34, 0.05, 0.12)
NOT_COVERABLE = (0.42, 0.43, 0.46)
SCANS = [  # by the number of scans: a colour and a name
    (UNSEEN, "none"),
    ((0.95, 0.80, 0.45), "1"),
    ((0.60, 0.78, 0.42), "2"),
    ((0.28, 0.66, 0.62), "3"),
    ((0.30, 0.48, 0.80), "4"),
    ((0.50, 0.34, 0.72), "5 and more"),
]
