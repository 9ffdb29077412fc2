# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""update(): pipeline errors are exceptions, its warnings are Python's."""

import warnings

import pytest
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

import vtkhelios
from vtkhelios.core.pipeline import clean_message, upstream


class Source(VTKPythonAlgorithmBase):
    """Reports given messages, and fails on request."""

    def __init__(self, event=None, message="", succeeds=1):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.event, self.message, self.succeeds = event, message, succeeds

    def RequestData(self, request, inputs, outputs):
        if self.event:
            self.InvokeEvent(self.event, self.message)
        return self.succeeds


def test_returns_the_output():
    source = Source()
    assert isinstance(vtkhelios.update(source), vtkPolyData)


def test_error_raises_with_the_message():
    source = Source(
        "ErrorEvent", "ERROR: In a.cxx, line 3\nvtkA (0x1f): BinSize 9 is too wide\n\n", 0
    )
    with pytest.raises(vtkhelios.PipelineError) as caught:
        vtkhelios.update(source)
    assert str(caught.value) == "BinSize 9 is too wide"
    assert caught.value.messages == ["BinSize 9 is too wide"]


def test_error_of_an_upstream_filter_raises():
    source = Source("ErrorEvent", "the scene is empty", 0)
    last = vtkTriangleFilter()
    last.SetInputConnection(source.GetOutputPort())
    with pytest.raises(vtkhelios.PipelineError, match="^the scene is empty$"):
        vtkhelios.update(last)


def test_failure_without_a_message_raises():
    with pytest.raises(vtkhelios.PipelineError, match="returned failure"):
        vtkhelios.update(Source(succeeds=0))


def test_error_of_a_vtkhelios_filter_raises(capfd):
    reader = vtkhelios.vtkHeliosObjSceneReader()
    reader.SetFileName("no/such/scene.obj")
    with pytest.raises(vtkhelios.PipelineError, match="no/such/scene.obj"):
        vtkhelios.update(reader)
    assert capfd.readouterr().err == ""


def test_warning_warns():
    with pytest.warns(RuntimeWarning, match="^3 triangles without area$"):
        vtkhelios.update(
            Source(
                "WarningEvent", "Warning: In b.cxx, line 1\nvtkB (0x2): 3 triangles without area\n"
            )
        )


def test_observers_are_removed():
    source = Source("WarningEvent", "once")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        vtkhelios.update(source)
    assert not source.HasObserver("ErrorEvent") and not source.HasObserver("WarningEvent")


def test_upstream_is_visited_once():
    source = Source()
    left, right = vtkTriangleFilter(), vtkTriangleFilter()
    left.SetInputConnection(source.GetOutputPort())
    right.SetInputConnection(left.GetOutputPort())
    assert upstream(right) == [right, left, source]


def test_missing_input_raises():
    with pytest.raises(vtkhelios.PipelineError, match="Input port 0"):
        vtkhelios.update(vtkTriangleFilter())


@pytest.mark.parametrize(
    "raw, clean",
    [
        ("ERROR: In ./a/b.cxx, line 306\nvtkX (0x3b4b1d40): Error: 5\nmore\n\n", "Error: 5\nmore"),
        ("Generic Warning: In c.cxx, line 1\nno class here\n", "no class here"),
        ("plain text", "plain text"),
        (
            "Input port 0 of algorithm vtkX(0x1bf65220) has none",
            "Input port 0 of algorithm vtkX has none",
        ),
    ],
)
def test_clean_message(raw, clean):
    assert clean_message(raw) == clean
