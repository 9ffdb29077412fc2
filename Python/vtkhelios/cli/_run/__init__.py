# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of vtkhelios run: its help, and the ranks of MPI."""
