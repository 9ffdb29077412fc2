# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys that run in memory or to files, their instruments, accuracy and trade-offs."""
