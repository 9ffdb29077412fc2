# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the tables and figures of Docs/validation again, or checks them.

    HELIOS_DATA=... build/venv/bin/python Python/studies/validation.py [STUDY ...] [--check]

Data of real instruments are in the folder real of HELIOS_DATA (without it: of shared/data beside the
checkout). What cannot be made, because a file or a program is absent, stays as it is and is named.
With --check nothing is written, and the status is 1 if a table differs from its page. --quick leaves
slow studies out, unless they are named.

A study is a module of this folder with make_tables(data, tools), which returns tables (_pages.Table)
of the folder data and raises FileNotFoundError without a file; tools has ouster_python. It may have
draw_figures(data, folder), and SLOW = True if it takes a minute or more. To add one, add its name to
STUDIES.
"""

import argparse
import importlib
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import _pages  # noqa: E402
import _study  # noqa: E402

STUDIES = ("patterns", "validate_waveforms", "trajectories", "range_noise", "swath", "real_clouds")
PAGES = pathlib.Path(__file__).resolve().parents[2] / "Docs" / "validation"


def refresh(study, data, tools, pages, check):
    """Writes the tables of a study, or compares them; the names of those that differ."""
    different = []
    for table in study.make_tables(data, tools):
        path = pages / table.page
        old = path.read_text(encoding="utf-8")
        new, kept = _pages.replace_table(old, table)
        for row in kept:
            print(f"{table.page}, table {table.name}: without data for {row}; left as it is")
        if new == old:
            continue
        different.append(f"{table.page}, table {table.name}")
        print(f"{different[-1]}: {'is out of date' if check else 'written'}")
        if not check:
            path.write_text(new, encoding="utf-8")
    if hasattr(study, "draw_figures") and not check:
        study.draw_figures(data, pages)
    return different


def main(words=None):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("studies", metavar="STUDY", nargs="*", help="of " + ", ".join(STUDIES))
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--quick", action="store_true", help="leave out the slow studies")
    parser.add_argument("--pages", type=pathlib.Path, default=PAGES, help="folder of the pages")
    parser.add_argument("--ouster-python", metavar="PYTHON", help="an interpreter with ouster-sdk")
    given = parser.parse_args(words)
    for name in given.studies:
        if name not in STUDIES:
            parser.error(f"no study {name}; there are {', '.join(STUDIES)}")
    different = []
    for name in given.studies or STUDIES:
        study = importlib.import_module(name)
        if given.quick and not given.studies and getattr(study, "SLOW", False):
            print(f"{name}: slow, left out")
            continue
        try:
            different += refresh(study, _study.real_data(), given, given.pages, given.check)
        except FileNotFoundError as absent:
            print(f"{name}: without {absent.filename}; its tables are left as they are")
    if not different:
        print("no table differs")
    return 1 if different and given.check else 0


if __name__ == "__main__":
    sys.exit(main())
