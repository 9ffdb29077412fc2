# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""output_hashes.py finds what differs between two states of the tree, and leaves out what may."""

import json
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from output_hashes import compare, hash_file, main  # noqa: E402

SUMMARY = {
    "timings": {"run_s": 1.0}, "checksum": "1", "versions": {"vtkHelios": "0.2.0"},
    "totals": {"points": 3}, "inputs": [{"file": "/here/a.xml", "sha256": "7"}], "part": {"number": 1, "command": "run a.xml"},
}  # fmt: skip


def test_a_difference_is_told_by_file():
    old = {"a": "1", "b": "2", "c": "3"}
    assert compare(old, dict(old)) == []
    assert compare(old, {"a": "1", "b": "9", "d": "4"}) == [
        "gone     c",
        "new      d",
        "differs  b",
    ]


@pytest.mark.parametrize(
    ("change", "differs"),
    [
        ({"timings": {}}, set()),
        ({"checksum": "2"}, set()),
        ({"versions": {}}, set()),
        ({"part": {"number": 1, "command": "run b.xml"}}, set()),
        ({"part": {"number": 2}}, {"#part"}),
        ({"inputs": [{"file": "/there/a.xml", "sha256": "7"}]}, set()),
        ({"inputs": [{"file": "/here/a.xml", "sha256": "8"}]}, {"#inputs"}),
        ({"totals": {"points": 4}}, {"#totals"}),
    ],
)
def test_members_of_a_summary(tmp_path, change, differs):
    path = tmp_path / "run_summary.json"
    path.write_text(json.dumps(SUMMARY))
    before = dict(hash_file(path))
    path.write_text(json.dumps(SUMMARY | change))
    after = dict(hash_file(path))
    assert before.keys() == after.keys() == {"#inputs", "#part", "#totals"}
    assert {member for member in before if before[member] != after[member]} == differs


def test_versions_are_left_out_of_files(tmp_path):
    digests = []
    for name, content in (
        ("a", b"x vtkHelios 0.2.0\0y"),
        ("b", b"x vtkHelios 1.10.3\0y"),
        ("c", b"z"),
    ):
        (tmp_path / name).write_bytes(content)
        digests += [digest for _, digest in hash_file(tmp_path / name)]
    assert digests[0] == digests[1] != digests[2]


def test_times_are_left_out_of_a_journal(tmp_path):
    digests = []
    for points, seconds in ((3, "1.5"), (3, "2.25"), (4, "1.5")):
        line = f'{{"points":{points},"leg":1,"seconds":{seconds},"check":"{points}{seconds[0]}"}}\n'
        head = {"part": {"number": 1, "command": f"run {seconds}"}, "check": seconds}
        (tmp_path / "run.journal").write_text(f"{json.dumps(head)}\n{line}{line}")
        digests += [digest for _, digest in hash_file(tmp_path / "run.journal")]
    assert digests[0] == digests[1] != digests[2]


def test_a_run_that_fails_is_told(tmp_path, monkeypatch):
    failing = tmp_path / "vtkhelios"
    failing.write_text("#!/bin/sh\n[ $1 = run ] || exit 0\necho no such thing >&2\nexit 1\n")
    failing.chmod(0o755)
    monkeypatch.setattr("sys.argv", ["x", "--vtkhelios", str(failing), "--surveys", "street"])
    with pytest.raises(SystemExit, match="(?s)street.xml with .*exit code 1.*no such thing"):
        main()
