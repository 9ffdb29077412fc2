# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages of the commands about files for maps and receivers."""


def write_geo_files(arguments, written, messages):
    """Returns the files of what geo_files() returned; says why some are missing, as a warning if they
    were asked for."""
    files, problem = written
    if problem and arguments.geo:
        messages.warning(problem)
    elif problem:
        messages.info(f"note     {problem}")
    return files
