# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation site, as Markdown for Sphinx.

    PYTHONPATH=Docs/site build/venv/bin/python -m pages FOLDER

A module here makes one kind of page: ``documents`` copies those of the checkout, ``classes``,
``functions``, ``commands`` and ``examples`` write those that follow from the code, ``gallery``
collects the pictures. Each has ``make(folder)``, which returns the names of its pages for the table
of contents.
"""
