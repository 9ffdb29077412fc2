# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damaged files for all file readers, shared by ../fuzz.py and the tests.

mutators    damage bytes, the same way for the same random numbers
outcomes    outcomes of a case, and the checks of accepted data
harness     runs cases in forked workers, and reports crashes, hangs and memory
targets     one class per reader, in modules by kind of file
"""
