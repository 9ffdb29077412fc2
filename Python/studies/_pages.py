# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of studies in the pages of Docs/validation, between lines of comment.

A page has <!-- table NAME: begin --> and <!-- table NAME: end --> around each.
"""

import re
import typing


class Table(typing.NamedTuple):
    """A table of a page. A row that has its first cells (keys) only is one whose data or program are
    absent: the page's own row with these cells is kept."""

    page: str  # file name in Docs/validation
    name: str
    titles: list
    rows: list  # lists of texts
    keys: int = 1


def transpose(titles, rows):
    """Titles and rows of a table whose columns were rows."""
    columns = [list(column) for column in zip(titles, *rows)]
    return columns[0], columns[1:]


def find_block(text, name, page=""):
    """Begin and end of the text between the two comments of a table."""
    found = [
        re.search(rf"^<!-- table {re.escape(name)}: {word} -->\n", text, re.M)
        for word in ("begin", "end")
    ]
    if None in found or found[0].end() > found[1].start():
        raise ValueError(
            f"{page}: no table {name}; add the lines <!-- table {name}: begin --> and "
            f"<!-- table {name}: end -->"
        )
    return found[0].end(), found[1].start()


def read_rows(block):
    """The rows of a table in a page, without its titles."""
    lines = [line for line in block.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[2:]]


def replace_table(text, table):
    """The text of a page with the table, and the keys of rows that were kept."""
    begin, end = find_block(text, table.name, table.page)
    old = {tuple(row[: table.keys]): row for row in read_rows(text[begin:end])}
    rows, kept = [], []
    for row in table.rows:
        is_absent = len(row) == table.keys < len(table.titles)
        if is_absent:
            kept.append(", ".join(row))
            row = old.get(tuple(row))
        if row:
            rows.append(row)
    lines = [table.titles, ["---"] * len(table.titles), *rows]
    made = "".join("|" + "|".join(lines_of(line)) + "|\n" for line in lines)
    return text[:begin] + made + text[end:], kept


def lines_of(cells):
    """Returns the cells with a space at either side, without the rule below the titles."""
    return [cell if cell == "---" else f" {cell} " if cell else " " for cell in cells]
