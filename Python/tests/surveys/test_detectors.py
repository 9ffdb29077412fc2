# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Echo detectors in Python, which surveys name: their echoes, threads and errors."""

import threading

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkSMPTools

import vtkhelios
from vtkhelios.core.detectors import Waveforms

from _small_run import write_survey

NAME = "ownDetector"


@pytest.fixture
def add():
    """Adds a detector for a test."""
    yield lambda function: vtkhelios.add_detector(NAME, function)
    vtkhelios.vtkHeliosEchoDetection.RemoveDetector(NAME)


@pytest.fixture
def survey(tmp_path):
    return vtkhelios.read_survey(write_survey(tmp_path))


def find_rises(waveforms):
    """Every sample above the threshold whose neighbours are lower, in an unsorted order."""
    samples = waveforms.samples
    is_top = (samples[:, 1:-1] > samples[:, :-2]) & (samples[:, 1:-1] >= samples[:, 2:])
    rows, bins = np.nonzero(is_top & (samples[:, 1:-1] > waveforms.threshold))
    order = np.argsort(-bins, kind="stable")
    rows, bins = rows[order], bins[order] + 1
    return rows, bins * waveforms.bin_size, samples[rows, bins], waveforms.pulse_length


def all_bytes(cloud):
    data = [cloud.polydata, cloud.pulses.polydata, cloud.sub_rays.polydata]
    return [
        {name: value.tobytes() for name, value in vtkhelios.arrays(each).items()} for each in data
    ]


def test_echoes_of_a_survey_are_those_of_its_waveforms(add, survey):
    add(find_rises)
    cloud = survey.run(detector=NAME, waveforms=True, sub_rays=7, noise=False)
    waves = vtkhelios.arrays(cloud.waveforms)
    found = {}
    for k, pulse in enumerate(waves["PulseIds"]):
        start = waves["Offset"][k]
        samples = waves["Samples"][start : start + waves["Count"][k]].astype(float)
        tops = 1 + np.flatnonzero((samples[1:-1] > samples[:-2]) & (samples[1:-1] >= samples[2:]))
        tops = tops[samples[tops] > 1e-13]
        times = waves["StartTime"][k] + tops * waves["BinSize"][k]
        found[pulse] = (0.5 * 0.299792458 * times, samples[tops])
    echoes = vtkhelios.arrays(cloud.polydata)
    assert len(found) > 1000 and max(len(ranges) for ranges, _ in found.values()) > 1
    expected = np.concatenate([found[pulse][0] for pulse in waves["PulseIds"]])
    assert echoes["Range"] == pytest.approx(expected, abs=1e-9)
    amplitudes = np.concatenate([found[pulse][1] for pulse in waves["PulseIds"]])
    assert echoes["Amplitude"].tolist() == amplitudes.tolist()
    assert set(echoes["EchoWidth"]) == set(waves["PulseLength"])


@pytest.mark.parametrize("options", [{"sub_rays": 7}, {"tolerance": 0.002}])
def test_bytes_do_not_depend_on_threads_or_blocks(options, add, survey):
    rows = []

    def find(waveforms):
        rows.append(len(waveforms.counts))
        return find_rises(waveforms)

    add(find)
    options = {"detector": NAME, "truth": True, "pulses": True, "hits": True, **options}
    try:
        clouds = []
        for threads in (1, 2, 3):
            vtkSMPTools.Initialize(threads)
            clouds.append(all_bytes(survey.run(**options)))
    finally:
        vtkSMPTools.Initialize(0)
    assert clouds[0] == clouds[1] == clouds[2]
    assert max(rows) > 64  # a call has many waveforms
    vtkhelios.vtkHeliosEchoDetection.RemoveDetector(NAME)

    def find_one_by_one(waveforms):
        found = []
        for k in range(len(waveforms.counts)):
            one = waveforms._replace(samples=waveforms.samples[k : k + 1, : waveforms.counts[k]])
            _, *echoes = np.broadcast_arrays(*find_rises(one))
            found.append(np.vstack([np.full(len(echoes[0]), k), *echoes]))
        row, *values = np.hstack(found)
        return row.astype(int), *values

    add(find_one_by_one)
    assert all_bytes(survey.run(**options)) == clouds[0]


@pytest.mark.filterwarnings("ignore:no echo was detected")
def test_a_block_describes_its_waveforms(add, survey):
    seen = []
    add(lambda waveforms: seen.append(waveforms) or ([], [], [], []))
    cloud = survey.run(detector=NAME, waveforms=True, sub_rays=7, seed=5)
    assert len(cloud) == 0
    waves = vtkhelios.arrays(cloud.waveforms)
    lengths = dict(zip(waves["PulseIds"], waves["Count"]))
    assert sum(len(each.counts) for each in seen) == len(lengths)
    for each in seen:
        assert isinstance(each, Waveforms) and each.samples.dtype == np.float32
        assert each.samples.shape == (len(each.counts), each.counts.max())
        assert [lengths[pulse] for pulse in each.pulse_ids] == each.counts.tolist()
        assert not each.samples.flags.writeable
        assert (each.seed, each.bin_size, each.threshold) == (5, 0.25, 1e-13)
        beyond = np.arange(each.samples.shape[1]) >= each.counts[:, None]
        assert not each.samples[beyond].any()


def test_dead_time_of_the_receiver(add, survey):
    add(lambda waveforms: ([0, 0, 0], [9.0, 1.0, 5.0], 1.0, 4.0))
    detector = vtkhelios.vtkHeliosEchoDetection.MakeDetector(NAME)
    detector.SetDeadTime(6.0)
    table = survey.run(sub_rays=7, waveforms=True, noise=False).waveforms
    detection = vtkhelios.vtkHeliosEchoDetection(echo_detector=detector)
    detection.SetInputData(table)
    echoes = vtkhelios.arrays(vtkhelios.update(detection))
    rows = -(-table.GetNumberOfRows() // 256)  # an echo of the first waveform of each block
    assert len(echoes["Range"]) == 2 * rows  # not that at 5 ns


def test_stored_waveforms_have_the_same_echoes(add, survey):
    add(find_rises)
    cloud = survey.run(detector=NAME, waveforms=True, sub_rays=7, noise=False)
    detection = vtkhelios.vtkHeliosEchoDetection()
    detection.SetEchoDetector(vtkhelios.vtkHeliosEchoDetection.MakeDetector(NAME))
    detection.SetInputData(cloud.waveforms)
    detection.Update()  # holds the interpreter lock
    again = vtkhelios.arrays(detection.GetOutput())
    assert again["Range"].tobytes() == vtkhelios.arrays(cloud.polydata)["Range"].tobytes()


def test_an_update_that_holds_the_interpreter_lock(add, survey):
    add(find_rises)
    source = survey.source(detector=NAME, sub_rays=7)
    vtkSMPTools.Initialize(3)
    try:
        thread = threading.Thread(target=source.Update, daemon=True)
        thread.start()
        thread.join(120)
    finally:
        vtkSMPTools.Initialize(0)
    assert not thread.is_alive()
    assert source.GetOutput().GetNumberOfPoints() > 1000


def fail(waveforms):
    raise KeyError("gain")


@pytest.mark.parametrize(
    "function, message",
    [
        (fail, rf'echo detector "{NAME}": {__file__}:\d+: KeyError: \'gain\''),
        (
            lambda w: None,
            f'echo detector "{NAME}": returned NoneType; give four arrays of one length',
        ),
        (lambda w: ([0], [1.0]), r"returned shapes \(1,\), \(1,\); give four arrays"),
        (lambda w: (), "returned nothing; give four arrays"),
        (lambda w: ([0], [1, 2], [1, 2, 3], 1), "give four arrays of one length"),
        (lambda w: ([0.5], 1.0, 1.0, 1.0), "give four arrays of one length"),
        (lambda w: ([0], ["far"], 1.0, 1.0), "give four arrays of one length"),
        (lambda w: ([len(w.counts)], 1.0, 1.0, 1.0), r"returned row \d+; give rows from 0 to \d+"),
        (lambda w: ([-1], 1.0, 1.0, 1.0), "returned row -1; give rows from 0"),
        (lambda w: ([0], np.nan, 1.0, 1.0), r"returned \[0.0, nan, 1.0, 1.0\] .*; give finite"),
    ],
)
def test_a_failure_ends_the_run_with_one_error(function, message, add, survey):
    calls = []
    add(lambda waveforms: calls.append(1) or function(waveforms))
    if function is fail:
        vtkhelios.vtkHeliosEchoDetection.RemoveDetector(NAME)
        add(fail)
    with pytest.raises(vtkhelios.PipelineError, match=message) as caught:
        survey.run(detector=NAME, sub_rays=7)
    assert len(caught.value.messages) == 1
    assert len(calls) < 200  # there are 40,000 pulses
    detection = vtkhelios.vtkHeliosEchoDetection()
    detection.SetEchoDetector(vtkhelios.vtkHeliosEchoDetection.MakeDetector(NAME))
    detection.SetInputData(survey.run(sub_rays=7, waveforms=True).waveforms)
    with pytest.raises(vtkhelios.PipelineError, match=message):
        vtkhelios.update(detection)


def test_a_failure_while_a_pulse_is_calibrated(add, survey):
    def fail_if_few(waveforms):
        if len(waveforms.counts) == 8:  # the calibration
            raise RuntimeError("few")
        return [], [], [], []

    add(fail_if_few)
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetEchoDetector(vtkhelios.vtkHeliosEchoDetection.MakeDetector(NAME))
    scanner.SetPulseShapeToHelios()
    scanner.SetBeamDeflector(vtkhelios.vtkHeliosRotatingMirror(pulse_frequency=1000))
    scanner.SetDuration(0.1)
    scanner.SetInputData(0, survey.scene)
    platform = vtkhelios.vtkHeliosStaticPlatform()
    platform.SetInputData(survey.trajectory(0).polydata)
    scanner.SetInputConnection(1, platform.GetOutputPort())
    with pytest.raises(vtkhelios.PipelineError, match=r'"ownDetector": .*RuntimeError: few'):
        vtkhelios.update(scanner)


def test_names_are_checked(add):
    add(find_rises)
    for name, fault in ((NAME, "is taken"), ("peak", "is taken"), ("", "is empty or has blanks")):
        with pytest.raises(ValueError, match=f"the name '{name}' of an echo detector {fault}"):
            vtkhelios.add_detector(name, find_rises)
    with pytest.raises(TypeError, match="the detector 'x' is 3; give a function"):
        vtkhelios.add_detector("x", 3)
    file = vtkhelios.vtkHeliosEchoDetection.GetDetectorFile
    assert file(NAME) == __file__ and file("peak") == file("none") == ""
