# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of clouds: the public names of vtkhelios.reports.picture; ``python3 -m`` draws one."""

import sys

from .reports.picture import *  # noqa: F403
from .reports.picture import main

if __name__ == "__main__":
    sys.exit(main())
