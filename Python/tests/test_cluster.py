# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys on the workers of Dask: the same arrays as in one process, one loaded scene per worker."""

import asyncio
import hashlib
import json
import os
import pickle
import signal
import sys
import threading
import time
import warnings

import _small_run
import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray

import vtkhelios
from vtkhelios import cluster
from vtkhelios.cluster import _tasks

dask = pytest.importorskip("dask")
distributed = pytest.importorskip("distributed")

LONG = dict(speed=0.001, stop=30)  # 3e9 pulses: hours


@pytest.fixture(scope="module")
def workers():
    """The client of two worker processes."""
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as local, distributed.Client(local) as client:
        yield client


@pytest.fixture
def fence(tmp_path):
    """Two scan positions, 100,000 pulses each, and a CRS; in the folder fence."""
    (tmp_path / "fence").mkdir()
    return vtkhelios.read_survey(_small_run.write_survey(tmp_path / "fence"))


def read_all(data):
    """All arrays of a data object with their VTK types, as bytes or texts."""
    found = []
    if data is None:
        return found
    table = data.IsA("vtkTable")
    for attributes in [data.GetRowData()] if table else [data.GetPointData(), data.GetCellData()]:
        found += read_attributes(attributes)
    found += read_attributes(data.GetFieldData())
    return found if table else [vtkhelios.Cloud(data).points.tobytes(), *found]


def read_attributes(attributes):
    arrays = map(attributes.GetAbstractArray, range(attributes.GetNumberOfArrays()))
    return [(array.GetName(), array.GetDataType(), read_values(array)) for array in arrays]


def read_values(array):
    if array.IsA("vtkStringArray"):
        return [array.GetValue(index) for index in range(array.GetNumberOfValues())]
    return bytes(memoryview(array)) if array.GetNumberOfValues() else b""


def assert_same(first, second):
    """The bytes of all arrays, in all outputs."""
    assert len(first) == len(second)
    for one, other in zip(first, second):
        assert read_all(one.data) == read_all(other.data) and len(one.names) > 5
        assert read_all(one.waveforms) == read_all(other.waveforms)
        for name in ("pulses", "sub_rays"):
            clouds = [getattr(cloud, name) for cloud in (one, other)]
            assert len({cloud is None for cloud in clouds}) == 1
            assert clouds[0] is None or read_all(clouds[0].data) == read_all(clouds[1].data)


ALL = dict(waveforms=True, hits=True, truth=True, seed=7, sub_rays=7)


def test_blocks_equal_those_of_one_process(workers, fence):
    shares = []
    expected = list(fence.blocks(30_000, **ALL))
    found = list(fence.blocks(30_000, client=workers, progress=shares.append, **ALL))
    assert len(found) == 7 and found[0].waveforms.GetNumberOfRows()
    assert found[0].data.GetFieldData().GetAbstractArray("CRS").GetValue(0) == "EPSG:25832"
    assert_same(found, expected)
    assert shares == sorted(shares) and len(shares) == 7 and shares[-1] == 1
    some = list(fence.blocks(30_000, legs=1, client=workers, **ALL))
    assert_same(some, list(fence.blocks(30_000, legs=1, **ALL)))
    assert some[0]["PulseIds"][0] >= 100_000


def test_delayed_blocks_equal_those_of_one_process(workers, fence):
    expected = list(fence.blocks(30_000, seed=np.int64(3)))
    parts = fence.to_delayed(30_000, seed=np.int64(3))
    assert_same(dask.compute(*parts), expected)
    heights = [dask.delayed(lambda cloud: cloud.points[:, 2].max())(part) for part in parts]
    highest = dask.delayed(max)(heights).compute()  # clouds stay where they are computed
    assert highest == max(cloud.points[:, 2].max() for cloud in expected)


def test_delayed_blocks_without_a_cluster_share_the_survey(fence):
    expected = list(fence.blocks(60_000))
    parts = fence.to_delayed(60_000, legs=[0, 1])
    loaded = fence.source_of({}).GetScene()
    assert_same(dask.compute(*parts, scheduler="threads"), expected)
    assert fence.source_of({}).GetScene() is loaded and not _tasks._loaded


def compute(client, task, **options):
    return client.submit(
        _tasks.compute_block, vtkhelios.read_survey, task, 0, 1000, pure=False, **options
    ).result(120)


def count_scenes(client):
    """Lets workers record the scenes of their tasks; returns a function that counts them."""

    def start():
        import vtkhelios.survey

        run, vtkhelios.survey.scenes_of_test = vtkhelios.Survey.run_window, set()

        def run_window(self, options, window, progress=None):
            cloud = run(self, options, window, progress)
            scene = self.source_of(options).GetScene()
            vtkhelios.survey.scenes_of_test.add((scene.__this__, scene.GetMTime()))
            return cloud

        vtkhelios.Survey.run_window = run_window
        return run

    def count():
        import vtkhelios.survey

        return len(vtkhelios.survey.scenes_of_test)

    client.run(start)
    return lambda: sorted(client.run(count).values())


def test_a_worker_loads_the_scene_once(workers, fence, tmp_path):
    count = count_scenes(workers)
    expected = list(fence.blocks(5_000))
    parts = fence.to_delayed(5_000)
    assert len(parts) == 40
    addresses = list(workers.scheduler_info()["workers"])
    for address in addresses:
        compute(workers, _tasks.make_task(fence, {}), workers=[address])
    assert_same(dask.compute(*parts), expected)
    assert_same(list(fence.blocks(5_000, client=workers)), expected)
    assert count() == [1, 1]
    mesh = tmp_path / "fence/fence.obj"
    state, text = mesh.stat(), mesh.read_text()
    mesh.write_text(text.replace(" 8\n", " 4\n"))  # the wall, with the same size and time
    os.utime(mesh, ns=(state.st_atime_ns, state.st_mtime_ns))
    other = r"not the survey of another worker, since \S+/fence\.obj has changed; .*\(on the worker"
    with pytest.raises(vtkhelios.PipelineError, match=other):
        dask.compute(*parts)


def test_tasks_hold_texts_and_numbers_only(fence, tmp_path):
    mesh = (tmp_path / "fence/fence.obj").stat().st_size
    task = _tasks.make_task(fence, {"seed": 3, "tolerance": np.float64(0.01)})
    assert len(pickle.dumps(task)) < 2000 < mesh
    told = json.loads(task)
    assert told["path"] == str(tmp_path / "fence/survey.xml") and told["assets"] == []
    assert told["options"] == {"seed": 3, "tolerance": 0.01}
    assert "fence.obj" in told["fingerprint"]
    graph = dict(fence.to_delayed(100_000)[1].__dask_graph__())
    assert len(pickle.dumps(graph)) < 4000


def test_a_survey_read_again_is_loaded_again(workers, fence, tmp_path):
    first = list(fence.blocks(100_000, client=workers))
    text = (tmp_path / "fence/fence.obj").read_text()
    (tmp_path / "fence/fence.obj").write_text(text.replace(" 8\n", " 4\n"))  # the wall
    again = vtkhelios.read_survey(tmp_path / "fence/survey.xml")
    second = list(again.blocks(100_000, client=workers))
    assert_same(second, list(again.blocks(100_000)))
    assert max(cloud.points[:, 2].max() for cloud in second) < 5 < first[0].points[:, 2].max()


def test_a_worker_keeps_two_surveys(workers, tmp_path):
    surveys = []
    for number in range(4):
        folder = tmp_path / str(number)
        folder.mkdir()
        surveys.append(vtkhelios.read_survey(_small_run.write_survey(folder)))
        list(surveys[-1].blocks(50_000, client=workers))

    def count():
        from vtkhelios.cluster import _tasks

        return len(_tasks._loaded)

    assert max(workers.run(count).values()) == 2


def test_relative_files_are_those_of_the_client(workers, tmp_path, monkeypatch):
    path = _small_run.write_survey(tmp_path)
    (tmp_path / "mine").mkdir()
    (tmp_path / "fence.obj").rename(tmp_path / "mine/fence.obj")
    monkeypatch.chdir(tmp_path)
    workers.run(os.chdir, "/")
    block = next(vtkhelios.read_survey(path.name, assets="mine").blocks(50_000, client=workers))
    (tmp_path / "mine/fence.obj").rename(tmp_path / "fence.obj")
    (tmp_path / "scene.xml").rename(tmp_path / "mine/scene.xml")
    path.rename(tmp_path / "mine/survey.xml")
    survey = vtkhelios.read_survey("mine/survey.xml")  # its mesh is in the working directory
    assert_same([next(survey.blocks(50_000, client=workers))], [block])


def test_workers_use_their_threads(workers, fence):
    next(fence.blocks(10_000, client=workers))

    def count():
        from vtkmodules.vtkCommonCore import vtkSMPTools

        return vtkSMPTools.GetEstimatedNumberOfThreads()

    list(fence.blocks(5_000, client=workers))
    assert set(workers.run(count).values()) == {1}


def test_a_killed_worker_costs_no_block(workers, fence):
    expected = list(fence.blocks(10_000))
    found = []
    for block in fence.blocks(10_000, client=workers):
        found.append(block)
        if len(found) == 3:
            victim = next(iter(workers.run(os.getpid).values()))
            os.kill(victim, signal.SIGKILL)
    assert_same(found, expected)
    workers.wait_for_workers(2)


# Errors.


def test_errors_of_a_worker_name_file_line_and_worker(workers, fence, tmp_path):
    text = (tmp_path / "fence/fence.obj").read_text()
    _tasks.make_task(fence, {})  # the digests are computed
    (tmp_path / "fence/fence.obj").write_text(text.replace("f 1 2 3\n", "f 1 2 none\n"))
    with pytest.raises(vtkhelios.PipelineError) as caught:
        fence.to_delayed()
    message = str(caught.value)
    assert "survey.xml: not the survey of the client, since" in message
    assert "fence.obj has changed; give all workers the same files" in message
    assert "(on the worker tcp://127.0.0.1:" in message
    again = vtkhelios.read_survey(tmp_path / "fence/survey.xml")
    with pytest.raises(vtkhelios.PipelineError, match=r"fence\.obj:\d+: .*none.*\(on the worker"):
        next(again.blocks(client=workers))
    assert caught.value.messages == [message]


def test_files_that_a_worker_does_not_have(workers, tmp_path):
    (tmp_path / "mine").mkdir()
    survey = vtkhelios.read_survey(_small_run.write_survey(tmp_path), assets=[tmp_path / "mine"])
    task = _tasks.make_task(survey, {})
    (tmp_path / "mine").rmdir()
    with pytest.raises(FileNotFoundError, match=r"mine: no such folder \(on the worker tcp"):
        compute(workers, task)
    (tmp_path / "mine").mkdir()
    (tmp_path / "fence.obj").unlink()
    message = (
        r'scene\.xml:4: filepath="fence\.obj": no such file; .* Correct the name.*on the worker'
    )
    with pytest.raises(vtkhelios.PipelineError, match=message):
        compute(workers, task)
    (tmp_path / "survey.xml").unlink()
    with pytest.raises(vtkhelios.PipelineError, match=r"survey\.xml.*\(on the worker tcp"):
        compute(workers, task)


def test_errors_survive_pickling():
    error = vtkhelios.PipelineError(["first", "second"])
    error.add_note("a note")
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == "first\nsecond" and again.messages == ["first", "second"]
    assert again.__notes__ == ["a note"]


@pytest.mark.parametrize(
    "options, error, message",
    [
        (dict(sede=1), TypeError, "sede is no option; options are: tolerance, energy_tolerance"),
        (dict(seed=-7), ValueError, "seed is -7; its valid range is"),
        (dict(detector="best"), vtkhelios.PipelineError, 'EchoDetector is "best"; give peak'),
        (dict(legs=7), ValueError, "there is no leg 7; legs are 0 to 1"),
        (dict(pulses=0), ValueError, "pulses is 0; give a whole number of 1 or more"),
        (
            dict(mesh=vtkhelios.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).polydata),
            TypeError,
            "an option is of vtkPolyData, which tasks of a cluster cannot hold; give a number",
        ),
    ],
)
def test_wrong_options(workers, fence, options, error, message):
    with pytest.raises(error, match=message):
        fence.to_delayed(**options)
    with pytest.raises(error, match=message):
        next(fence.blocks(client=workers, **options))


def test_wrong_clients(fence):
    with pytest.raises(TypeError, match="client is of str; give a distributed.Client"):
        next(fence.blocks(client="tcp://127.0.0.1:8786"))

    async def use():
        options = dict(processes=False, dashboard_address=":0", asynchronous=True)
        async with distributed.Client(n_workers=1, set_as_default=False, **options) as client:
            next(fence.blocks(client=client))

    with pytest.raises(ValueError, match="client is asynchronous; give one that is not, or use"):
        asyncio.run(use())


def test_surveys_that_no_file_has(fence, tmp_path):
    scene = vtkhelios.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    message = "workers read a survey from files, and this one has a scene or a trajectory in memory"
    with pytest.raises(ValueError, match=message):
        vtkhelios.make_survey(
            scene, [(0, 0, 2)], scan_frequency=100, head=(0, 9), head_speed=9
        ).to_delayed()
    with pytest.raises(ValueError, match=message):
        vtkhelios.read_survey(tmp_path / "fence/survey.xml", scene=scene).to_delayed()
    fence.run(legs=0)
    _tasks.make_task(fence, {})  # a run changes nothing
    os.utime(tmp_path / "fence/survey.xml", ns=(1, 1))
    with pytest.raises(ValueError, match="survey.xml has changed since it was read; read it again"):
        fence.to_delayed()
    fence.vtk.SetLegAttribute(0, "scanFreq_hz", "50")
    with pytest.raises(ValueError, match="survey.xml: the survey was changed after it was read"):
        fence.to_delayed()


@pytest.mark.parametrize("module", ["dask", "distributed"])
def test_missing_packages(fence, module, monkeypatch):
    monkeypatch.setitem(sys.modules, module, None)
    call = fence.to_delayed if module == "dask" else lambda: next(fence.blocks(client=1))
    with pytest.raises(
        ImportError,
        match=rf"need the package {module}, which is not installed: pip install dask dist",
    ):
        call()
    assert cluster.need("json") is json


# Cancelling: the blocks would take hours.


def wait_until(condition):
    deadline = time.monotonic() + 120
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.05)
    assert condition()


def find_computed(client):
    """The keys of the tasks that workers compute."""
    return [str(key) for keys in client.processing().values() for key in keys]


def check_free(client, survey):
    """All workers compute other tasks."""
    task = _tasks.make_task(survey, {})
    assert all(len(compute(client, task, workers=[name])) for name in client.nthreads())


def test_cancelled_blocks_end(workers, fence, make_survey):
    survey = vtkhelios.read_survey(make_survey(**LONG))
    parts = workers.compute(survey.to_delayed(10**9))
    wait_until(lambda: find_computed(workers))
    time.sleep(0.5)
    workers.cancel(parts)
    wait_until(lambda: not find_computed(workers))
    check_free(workers, fence)


def test_an_interrupt_ends_the_blocks(workers, fence, make_survey):
    survey = vtkhelios.read_survey(make_survey(**LONG))

    def interrupt():
        wait_until(lambda: any("vtkhelios" in key for key in find_computed(workers)))
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        next(survey.blocks(10**9, client=workers))
    thread.join()
    wait_until(lambda: not find_computed(workers))
    assert caught.tb  # which holds all that the blocks hold
    check_free(workers, fence)


def test_closed_blocks_are_cancelled(workers, fence):
    blocks = fence.blocks(100, client=workers)
    next(blocks)
    blocks.close()
    wait_until(lambda: not find_computed(workers))


def test_warnings_reach_the_client(workers, fence, tmp_path):
    with (tmp_path / "fence/fence.obj").open("a") as file:
        file.write("f 1 1 2\n")
    with warnings.catch_warnings(record=True) as local:
        warnings.simplefilter("always")
        len(vtkhelios.read_survey(tmp_path / "fence/survey.xml").run())
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        again = vtkhelios.read_survey(tmp_path / "fence/survey.xml")
        next(again.blocks(client=workers))
        wait_until(lambda: found)
    assert str(local[0].message) == str(found[0].message) and found[0].category is RuntimeWarning


# Clouds as pickles.


@pytest.mark.parametrize("protocol", [2, 5])
def test_clouds_are_pickled(fence, protocol):
    cloud = fence.run(pulses=True, **ALL)
    again = pickle.loads(pickle.dumps(cloud, protocol))
    assert_same([again], [cloud])
    again["Range"][0] = 0  # it has memory of its own
    assert cloud["Range"][0] > 0


def test_pickled_data_of_any_kind():
    empty = pickle.loads(pickle.dumps(vtkhelios.Cloud()))
    assert len(empty) == 0 and empty.names == [] and empty.waveforms is None
    cloud = vtkhelios.Cloud.from_arrays([[0, 0, 0], [1, 2, 3.5]], Normal=[[0, 0, 1], [1, 0, 0]])
    ids, texts = vtkIdTypeArray(), vtkStringArray()
    ids.SetName("Ids")
    texts.SetName("Texts")
    for number, text in enumerate(["\u00e4", ""]):
        ids.InsertNextValue(2**40 + number)
        texts.InsertNextValue(text)
    attributes = cloud.polydata.GetPointData()  # with vertices
    attributes.AddArray(ids)
    attributes.AddArray(texts)
    attributes.SetActiveNormals("Normal")
    buffers = []
    kept = pickle.dumps(cloud, 5, buffer_callback=buffers.append)
    sent = [bytes(buffer) for buffer in buffers]  # read-only memory
    digests = [hashlib.sha256(part).digest() for part in sent]
    again = pickle.loads(kept, buffers=sent)
    assert read_all(again.data) == read_all(cloud.data)
    assert again.data.GetPointData().GetNormals().GetName() == "Normal"
    assert again.data.GetNumberOfVerts() == 2 and again.data.GetCell(1).GetPointId(0) == 1
    again["Normal"][0] = 5
    assert [hashlib.sha256(part).digest() for part in sent] == digests
    assert sys.getsizeof(cloud) >= sum(map(len, sent))


def test_lines_are_pickled():
    path = vtkhelios.Cloud.from_arrays([[0, 0, 40], [1, 0, 40.0]])
    lines = vtkCellArray()
    lines.InsertNextCell(2, [1, 0])
    path.data.SetLines(lines)
    again = pickle.loads(pickle.dumps(path)).data
    assert again.GetNumberOfLines() == 1 and again.GetCell(0).GetPointId(0) == 1
