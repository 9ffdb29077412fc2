# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Other threads run during a pipeline, and Ctrl-C stops it; many runs do not use more memory."""

import gc
import os
import pathlib
import signal
import threading
import time

import numpy as np
import pytest

import vtkhelios

SURVEY = dict(scan_frequency=100, vertical=(-40, 60), head=(0, 360), head_speed=2)


@pytest.fixture
def blocks():
    return vtkhelios.Scene(vtkhelios.vtkHeliosSyntheticScene(kind="blocks"))


@pytest.fixture
def long_survey(blocks):
    """About ten seconds of work: 18 M pulses."""
    return vtkhelios.make_survey(blocks, [(0, 0)], **SURVEY)


class Ticker:
    """Counts in another thread while entered."""

    def __enter__(self):
        self.count, self.going = 0, True
        self._thread = threading.Thread(target=self._tick)
        self._thread.start()
        return self

    def _tick(self):
        while self.going:
            self.count += 1
            time.sleep(0.001)

    def __exit__(self, *_):
        self.going = False
        self._thread.join()


@pytest.fixture(autouse=True)
def interrupts_are_heard():
    """Python's own handler: shells start background programs with SIGINT ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def interrupt_after(seconds):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def test_other_threads_continue(blocks):
    survey = vtkhelios.make_survey(blocks, [(0, 0)], **{**SURVEY, "head_speed": 20})
    survey.number_of_pulses  # the scene is loaded
    with Ticker() as ticker:
        survey.run()
        while_running = ticker.count
    assert while_running > 20


def test_other_threads_continue_with_a_python_filter(blocks):
    survey = vtkhelios.make_survey(blocks, [(0, 0)], **{**SURVEY, "head_speed": 20})
    counts = []

    @vtkhelios.filter
    def near(cloud):
        counts.append(ticker.count)
        return cloud["Range"] < 20

    pipeline = survey >> near
    with Ticker() as ticker:
        pipeline()
    assert counts[0] > 20  # while the source ran


def test_python_filter_upstream_of_a_cpp_filter(blocks):
    """The upstream filter runs while the caller does not hold the interpreter lock."""
    calls = []

    @vtkhelios.filter
    def passes(data):
        calls.append(threading.get_ident())

    last = vtkhelios.vtkHeliosSceneTransform(translation=(0, 0, 1))
    with Ticker():
        for _ in range(50):
            (blocks >> passes >> last)()
    assert len(calls) == 50


def test_two_threads_run_in_parallel(blocks):
    surveys = [
        vtkhelios.make_survey(blocks, [(x, 0)], **{**SURVEY, "head_speed": 60}) for x in (0, 9)
    ]
    alone = [survey.run().points.copy() for survey in surveys]
    found = {}

    def run(index):
        found[index] = surveys[index].run().points

    threads = [threading.Thread(target=run, args=(index,)) for index in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((found[index] == alone[index]).all() for index in (0, 1))


def test_threads_share_one_survey(blocks):
    survey = vtkhelios.make_survey(
        blocks, [(0, 0)], **{**SURVEY, "head_speed": 60, "head": (0, 60)}
    )
    alone = [survey.run(seed=seed).points for seed in range(4)]
    found = {}

    def run(seed):
        found[seed] = [block.points for block in survey.blocks(40_000, seed=seed)]

    threads = [threading.Thread(target=run, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((np.concatenate(found[seed]) == alone[seed]).all() for seed in range(4))


def test_interrupt_stops_a_run_and_the_next_is_complete(long_survey, blocks):
    long_survey.number_of_pulses
    shares = []
    timer = interrupt_after(0.3)
    with pytest.raises(KeyboardInterrupt):
        long_survey.run(progress=shares.append)
    timer.join()
    assert shares[-1] < 0.9
    cloud = next(long_survey.blocks(50_000))
    again = next(vtkhelios.make_survey(blocks, [(0, 0)], **SURVEY).blocks(50_000))
    assert (cloud.points == again.points).all()


def test_interrupt_stops_slow_pulses(long_survey):
    """The run would last for hours, and a million pulses for many minutes."""
    long_survey.number_of_pulses
    shares = []
    timer = interrupt_after(1.0)
    with pytest.raises(KeyboardInterrupt):
        long_survey.run(progress=shares.append, sub_rays=20_000)
    timer.join()
    assert 0.0 < shares[-1] < 0.1


def test_interrupted_files_are_resumed(long_survey, tmp_path):
    timer = interrupt_after(1.0)
    with pytest.raises(KeyboardInterrupt):
        long_survey.run_to(tmp_path, pulses_per_block=20_000)
    timer.join()
    assert (tmp_path / "survey/run.journal").is_file()


def test_interrupt_stops_a_pipeline(long_survey):
    calls = []

    @vtkhelios.filter
    def passes(cloud):
        calls.append(len(cloud))

    pipeline = long_survey >> passes
    timer = interrupt_after(0.5)
    with pytest.raises(KeyboardInterrupt):
        pipeline()
    timer.join()
    assert sum(calls) == 0  # a stopped source has no output


def test_stopped_pipeline_is_computed_again(blocks):
    """A stopped scanner keeps its output; the next update must not treat it as complete."""
    mirror = vtkhelios.vtkHeliosRotatingMirror(scan_frequency=100, vertical_angle_min=-40)
    where = vtkhelios.Cloud.from_arrays([[0.0, 0.0, 3.0]]) >> vtkhelios.vtkHeliosStaticPlatform()
    scanner = vtkhelios.vtkHeliosScanner(
        beam_deflector=mirror, head_rotate_stop=360, head_rotate_speed=60
    )
    (blocks, where) >> scanner

    def stop(_algorithm, _share):
        raise LookupError("enough")

    with pytest.raises(LookupError):
        vtkhelios.update(scanner, progress=stop)
    stopped = scanner.output.GetNumberOfPoints()
    whole = vtkhelios.update(scanner).GetNumberOfPoints()
    assert stopped < whole
    scanner.Modified()
    assert vtkhelios.update(scanner).GetNumberOfPoints() == whole


def test_an_interrupt_in_a_python_filter_is_passed_on(blocks):
    @vtkhelios.filter
    def presses(data):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.01)

    with pytest.raises(KeyboardInterrupt):
        (blocks >> presses)()


def test_callbacks_of_update(blocks):
    told = []
    last = vtkhelios.vtkHeliosSceneTransform(translation=(0, 0, 1))
    pipeline = vtkhelios.vtkHeliosSyntheticScene(kind="blocks") >> last
    vtkhelios.update(
        pipeline.last, progress=lambda algorithm, share: told.append((algorithm, share))
    )
    assert told and all(0 <= share <= 1 for _, share in told)

    def stop(_algorithm, _share):
        raise LookupError("enough")

    last.Modified()
    with pytest.raises(LookupError, match="enough"):
        vtkhelios.update(last, progress=stop)
    assert vtkhelios.update(last).GetNumberOfPoints() > 0


def test_run_takes_algorithms_and_players_only():
    from vtkhelios import _native

    with pytest.raises(
        TypeError,
        match="target is not an algorithm, a vtkHeliosSurveyPlayer or a vtkHeliosCOPCWriter",
    ):
        _native.run(vtkhelios.vtkHeliosConicMirror(), 0, [], None, 0.1)
    with pytest.raises(TypeError, match="None cannot be watched"):
        _native.run(vtkhelios.vtkHeliosSyntheticScene(), 0, [None], None, 0.1)
    with pytest.raises(TypeError, match="is not a wrapped class of VTK"):
        _native.extend(dict, {}, False)


def resident():
    """Resident memory of this process [bytes]."""
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def test_memory_does_not_grow(blocks):
    """Runs, views, filters, surveys by hand: after 20 rounds, 80 more need almost no memory."""
    survey = vtkhelios.make_survey(
        blocks, [(0, 0)], **{**SURVEY, "head_speed": 60, "head": (0, 45)}
    )

    @vtkhelios.filter
    def near(cloud, distance=20.0):
        cloud["Half"] = cloud["Range"] / 2
        return cloud["Range"] < distance

    def work():
        cloud = survey.run(waveforms=True, truth=True)
        held = cloud.polydata.GetActualMemorySize() * 1024
        cloud.to_structured(["x", "Range"])
        (cloud >> near(distance=9) >> vtkhelios.vtkHeliosSceneTransform())
        kept = vtkhelios.Cloud((cloud.polydata >> near())())
        vtkhelios.scan(blocks, (1, 1), **{**SURVEY, "head": (0, 10), "head_speed": 60})
        assert len(kept)
        return held

    sizes = []
    for _ in range(100):
        held = work()
        gc.collect()
        sizes.append(resident())
    growth = max(sizes[90:]) - max(sizes[10:20])
    print(f"a run holds {held / 1e6:.1f} MB; 80 runs more take {growth / 1e6:.1f} MB")
    assert growth < 4 * held  # the allocator's part; a leak of every array would be 80 times that
