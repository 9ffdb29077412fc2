# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damaged files for everything that reads files: what ../fuzz.py and the tests share.

mutators    damage bytes, the same way for the same random numbers
outcomes    what may come of a case, and the checks of what was accepted
harness     runs cases in forked workers, and tells crashes, hangs and memory
targets     what is fed: a class a reader, in modules by kind of file
"""
