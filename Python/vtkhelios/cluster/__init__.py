# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys on the workers of Dask: Survey.to_delayed(), and Survey.blocks() with a client.

A task is a text with the file of the survey, its options and its digests, and two pulse ids. Each
worker process reads the survey and loads the scene once. See Docs/cluster.md.
"""

from ..core import packages

__all__ = ["need"]


def need(module):
    """Imports dask or distributed, or explains how to get them."""
    return packages.load(module, "surveys on a cluster need")
