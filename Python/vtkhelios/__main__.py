# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""python -m vtkhelios: the command line."""

import sys

from .cli import main
from .core.streams import fill_standard_descriptors

fill_standard_descriptors()
sys.exit(main())
