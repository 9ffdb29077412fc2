# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of vtkhelios tradeoff: its inputs, tables and pictures."""
