# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The harness itself: it detects failures, on targets that fail on purpose."""

import ctypes
import os
import random
import struct
import time

import numpy as np
import pytest

from fuzzing import harness, mutators, outcomes, target, targets_points
from fuzzing.outcomes import Refused, Silent, check, check_chunk, check_count

CASES = [str(number) for number in range(5)]


class Fake(target.Target):
    """Reads a one-word file by a function of the path and the bytes."""

    name = "fake"
    kind = "text"

    def __init__(self, action, kept=()):
        self.action = action
        self._kept = list(kept)

    def run(self, path, data):
        assert path.read_bytes() == data
        self.action(path, data)

    def kept(self):
        return self._kept


SEEDS = [target.Seed("word.txt", b"1 2 3\n", {"beside/other.txt": b"there"})]


def run(tmp_path, action, cases=CASES, hang=20.0, memory=None, monkeypatch=None):
    if memory:
        monkeypatch.setattr(harness, "MEMORY", memory)
        monkeypatch.setattr(harness, "MEMORY_FACTOR", 0)
    results = []
    batch = harness.Batch(Fake(action), SEEDS, list(cases))
    settings = harness.Settings(str(tmp_path), hang=hang)
    harness.run_batches([batch], settings, 2, results.append)
    assert sorted(result.case for result in results) == sorted(cases)
    return {result.case: result for result in results}


def at(case, action):
    """An action that fails in one case only: the harness attributes it, and continues."""
    source = Fake(None).make_input(SEEDS, case, 1)[1]
    return lambda path, data: action() if data == source else None


def outcomes_of(results):
    return [results[case].outcome for case in CASES]


def expect_one(results, outcome, *words):
    assert outcomes_of(results) == ["accepted", "accepted", outcome, "accepted", "accepted"]
    for word in words:
        assert word in results["2"].text


def test_good_cases_are_accepted(tmp_path):
    results = run(tmp_path, lambda path, data: None)
    assert outcomes_of(results) == ["accepted"] * 5
    assert not any(result.failed for result in results.values())


def test_additional_files_exist(tmp_path):
    def read(path, data):
        assert path.with_name("beside").joinpath("other.txt").read_bytes() == b"there"

    assert outcomes_of(run(tmp_path, read)) == ["accepted"] * 5


def test_cases_are_isolated(tmp_path):
    def leave(path, data):
        assert not path.with_name("left.txt").exists()
        path.with_name("left.txt").write_text("left")
        path.with_name("folder").mkdir()

    assert outcomes_of(run(tmp_path, leave)) == ["accepted"] * 5


def test_a_refusal_is_not_a_failure(tmp_path):
    def refuse():
        raise Refused("a.txt:1: is wrong; correct it")

    results = run(tmp_path, at("2", refuse))
    expect_one(results, "refused", "a.txt:1")
    assert not results["2"].failed


def test_pipeline_errors_and_format_errors_are_refusals(tmp_path):
    from vtkhelios import PipelineError
    from vtkhelios.formats import FormatError

    def refuse(error):
        raise error

    expect_one(run(tmp_path, at("2", lambda: refuse(PipelineError(["wrong"])))), "refused")
    expect_one(run(tmp_path, at("2", lambda: refuse(FormatError("wrong")))), "refused")


def test_a_refusal_without_a_reason_is_silent(tmp_path):
    def refuse():
        raise Refused(" \n")

    expect_one(run(tmp_path, at("2", refuse)), "silent", "without a reason")


def test_a_crash_is_detected(tmp_path):
    expect_one(run(tmp_path, at("2", lambda: ctypes.string_at(0))), "crash", "SIGSEGV")


def test_an_abort_is_detected(tmp_path):
    expect_one(run(tmp_path, at("2", os.abort)), "crash", "SIGABRT")


def test_an_exit_is_detected(tmp_path):
    expect_one(run(tmp_path, at("2", lambda: os._exit(3))), "crash", "exit code 3")


def test_an_exit_without_an_error_is_detected(tmp_path):
    expect_one(run(tmp_path, at("2", lambda: os._exit(0))), "crash", "exit code 0")


def test_a_hang_in_native_code_is_detected(tmp_path):
    def hang():
        ctypes.CDLL(None).sleep(1000)

    start = time.monotonic()
    results = run(tmp_path, at("2", hang), hang=1.0)
    expect_one(results, "hang")
    assert time.monotonic() - start < 60


def test_a_hang_that_catches_exceptions_is_detected(tmp_path):
    def hang():
        while True:
            try:  # noqa: SIM105
                time.sleep(1)
            except BaseException:
                pass

    expect_one(run(tmp_path, at("2", hang), hang=1.0), "hang")


def test_a_traceback_is_detected(tmp_path):
    def fail():
        raise KeyError("legs")

    expect_one(run(tmp_path, at("2", fail)), "traceback", "KeyError: 'legs'")


def test_an_exit_of_python_is_a_traceback(tmp_path):
    def leave():
        raise SystemExit(1)

    expect_one(run(tmp_path, at("2", leave)), "traceback", "SystemExit")


def test_used_memory_is_detected(tmp_path, monkeypatch):
    results = run(
        tmp_path, at("2", lambda: np.ones(32 << 20)), memory=16 << 20, monkeypatch=monkeypatch
    )
    expect_one(results, "memory", "MB for a file of")
    assert results["2"].peak > 60 << 20 > results["3"].peak


def test_requested_memory_is_refused(tmp_path):
    expect_one(
        run(tmp_path, at("2", lambda: np.empty(5 << 30, np.int8))),
        "traceback",
        "Unable to allocate",
    )


def test_a_lost_record_is_detected(tmp_path):
    def lose():
        check_count(2, 3, False)

    expect_one(run(tmp_path, at("2", lose)), "silent", "2 of 3 records, and no warning")


def test_a_lost_record_with_a_warning_is_accepted(tmp_path):
    expect_one(run(tmp_path, at("2", lambda: check_count(2, 3, ["1 left out"]))), "accepted")


def test_a_number_that_is_not_finite_is_detected(tmp_path):
    def infinite():
        check_chunk({"points": np.zeros((3, 3)), "Range": np.array([1.0, np.inf, 2.0])})

    expect_one(run(tmp_path, at("2", infinite)), "silent", "Range of record 1 is inf, not finite")


@pytest.mark.parametrize(
    "chunk, message",
    [
        ({"points": np.full((2, 3), np.nan)}, "points of record 0"),
        ({"points": np.zeros((2, 3)), "Range": np.zeros(3)}, "Range has 3 rows for 2 points"),
        ({"points": np.zeros((1, 3)), "Hit": np.array([2])}, "Hit is out of range"),
    ],
)
def test_chunks_are_checked(chunk, message):
    with pytest.raises(Silent, match=message):
        check_chunk(chunk)


def test_refusing_a_valid_file_is_a_failure(tmp_path):
    def refuse(path, data):
        raise Refused("no")

    results = run(tmp_path, refuse, ["seed:word.txt"])
    assert results["seed:word.txt"].outcome == "silent"
    assert "the good file is refused" in results["seed:word.txt"].text


def test_an_input_replaces_a_case(tmp_path):
    results = []
    batch = harness.Batch(Fake(lambda path, data: check(data == b"mine", "other bytes")), SEEDS,
                          ["seed:word.txt"])  # fmt: skip
    settings = harness.Settings(str(tmp_path), input=b"mine")
    harness.run_batches([batch], settings, 1, results.append)
    assert [result.outcome for result in results] == ["accepted"]


def test_cases_are_the_same_in_every_run():
    fake = Fake(None)
    inputs = [fake.make_input(SEEDS, case, 7)[1] for case in CASES]
    assert inputs == [fake.make_input(SEEDS, case, 7)[1] for case in CASES]
    assert inputs != [fake.make_input(SEEDS, case, 8)[1] for case in CASES]
    assert len(set(inputs)) > 1


def test_kept_files_are_read_and_damaged(tmp_path, monkeypatch):
    monkeypatch.setattr(target, "KEPT", tmp_path)
    monkeypatch.setattr(target, "KEPT_SHARE", 1.0)
    (tmp_path / "fake").mkdir()
    (tmp_path / "fake" / "word.txt~once").write_bytes(b"it failed once")
    fake = Fake(None, ["word.txt~once"])
    seed, data = fake.make_input(SEEDS, "kept:word.txt~once", 1)
    assert (seed.name, data) == ("word.txt", b"it failed once")
    assert any(b"failed once" in fake.make_input(SEEDS, str(n), 1)[1] for n in range(20))


def test_a_kept_file_names_its_seed():
    with pytest.raises(ValueError, match="seeds are word.txt"):
        target.seed_of(SEEDS, "letter.txt~1")


@pytest.mark.parametrize("kind", mutators.KINDS)
@pytest.mark.parametrize("data", [b"", b"\0", b"<a b='1'><c/></a>", b"x 1 2.5\n\xff nan\n" * 30])
def test_mutators_accept_any_bytes(kind, data):
    for number in range(300):
        source = random.Random(number)
        assert len(mutators.mutate(data, kind, source)) < 3_000_000


@pytest.mark.parametrize("kind", mutators.KINDS)
def test_most_mutants_differ_from_the_valid_file(kind):
    data = b'<a b="1 2 3">4 5 6</a>\n' * 20
    changed = sum(mutators.mutate(data, kind, random.Random(i)) != data for i in range(200))
    assert changed > 180


def test_damaged_integers_stay_in_the_header():
    data = bytes(1000)
    for number in range(200):
        changed = mutators.change_integer(data, random.Random(number))
        assert len(changed) == 1000 and not any(changed[400:])


def test_lines_are_counted_only_in_simple_files():
    assert len(outcomes.plain_lines(b"1 2 3\n# no\n\n4 5 6 // end\r\n")) == 2
    assert outcomes.plain_lines(b"1 2 3\r4 5 6\n") is None
    assert outcomes.plain_lines(b"1 2\0\n") is None
    assert outcomes.plain_lines(b"1 2\xff\n") is None


def test_page_checksums_are_repaired():
    assert targets_points.crc32c(b"123456789") == 0xE3069283  # from its standard
    mended = targets_points.mend_pages(b"a" * 1020 + b"junk")
    assert mended == b"a" * 1020 + struct.pack(">I", targets_points.crc32c(b"a" * 1020))
