# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
""">> connects; functions are filters anywhere in a pipeline."""

import numpy as np
import pytest
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkCommonTransforms import vtkTransform

import vtkhelios
from vtkhelios import select_ports


def blocks():
    return vtkhelios.vtkHeliosSyntheticScene(kind="blocks")


def transform(z):
    return vtkhelios.vtkHeliosSceneTransform(translation=(0, 0, z))


def lowest(data):
    return vtkhelios.arrays(data)["points"][:, 2].min()


@pytest.fixture
def scanner():
    """A scanner without inputs."""
    mirror = vtkhelios.vtkHeliosRotatingMirror(
        pulse_frequency=50_000, scan_frequency=100, mirror_angle=120, vertical_angle_min=-40,
        vertical_angle_max=60,
    )  # fmt: skip
    return vtkhelios.vtkHeliosScanner(
        beam_deflector=mirror, head_rotate_stop=90, head_rotate_speed=90, mount_position=(0, 0, 2)
    )


def tripod(z=2.0):
    where = vtkhelios.Cloud.from_arrays([[0.0, 0.0, z]])
    platform = vtkhelios.vtkHeliosStaticPlatform()
    return where >> platform


def test_three_in_a_row():
    pipeline = blocks() >> transform(1) >> transform(10)
    assert lowest(pipeline()) == pytest.approx(lowest(blocks()()) + 11)
    assert pipeline.output is pipeline.update().output
    assert repr(pipeline) == (
        "Pipeline(vtkHeliosSyntheticScene >> vtkHeliosSceneTransform >> vtkHeliosSceneTransform)"
    )
    shown = (pipeline >> vtkTriangleFilter())._repr_html_()
    assert shown.startswith("<b>Pipeline</b><ol><li>vtkHeliosSyntheticScene(")
    assert shown.count("<li>") == 4 and shown.endswith("<li>vtkTriangleFilter</li></ol>")


def test_pipelines_join():
    tail = transform(1) >> transform(2)
    assert lowest((blocks() >> tail)()) == pytest.approx(lowest(blocks()()) + 3)
    assert (blocks() >> tail).first is not tail.first


def test_an_algorithm_alone():
    scene = blocks()
    assert scene.update() is scene
    assert scene.output is scene.GetOutput()
    kept = scene()
    assert kept is not scene.output and kept.GetPoints() is scene.output.GetPoints()
    assert lowest(transform(5)(scene.output)) == pytest.approx(lowest(scene.output) + 5)


def test_data_is_a_source():
    data = blocks()()
    assert lowest((data >> transform(1))()) == pytest.approx(lowest(data) + 1)
    pipeline = transform(1) >> transform(1)
    assert lowest(pipeline(data)) == pytest.approx(lowest(data) + 2)
    scene = vtkhelios.Scene(data)
    assert lowest((scene >> transform(1))()) == pytest.approx(lowest(data) + 1)


def test_stock_filters_on_either_side():
    up = vtkTransform()
    up.Translate(0, 0, 7)
    stock = vtkTransformPolyDataFilter()
    stock.SetTransform(up)
    stock.SetOutputPointsPrecision(1)
    last = vtkTriangleFilter()
    data = (blocks() >> stock >> transform(1) >> last)()
    assert data.GetPoints() is last.GetOutput().GetPoints()
    assert lowest(data) == pytest.approx(lowest(blocks()()) + 8)


def test_two_inputs(scanner):
    pipeline = (blocks(), tripod()) >> scanner
    cloud = vtkhelios.Cloud(pipeline())
    assert len(cloud) > 1000 and pipeline.last is scanner
    again = vtkhelios.vtkHeliosStaticPlatform()
    (vtkhelios.Cloud.from_arrays([[0.0, 0.0, 9.0]]) >> again) >> select_ports(1, scanner)
    assert vtkhelios.Cloud(pipeline())["Range"].min() > cloud["Range"].min() + 3


def test_many_inputs_on_one_port():
    composer = vtkhelios.vtkHeliosSceneComposer()
    joined = ((blocks(), transform(50)(blocks()())) >> composer)()
    assert joined.GetNumberOfCells() == 2 * blocks()().GetNumberOfCells()
    ((blocks(), blocks(), blocks()) >> composer)()
    assert composer.GetNumberOfInputConnections(0) == 3


def test_an_output_is_selected(scanner):
    (blocks(), tripod()) >> scanner
    scanner.generate_waveforms = True
    detection = vtkhelios.vtkHeliosEchoDetection()
    echoes = (select_ports(scanner, 1) >> detection)()
    other = (scanner.GetOutputPort(1) >> vtkhelios.vtkHeliosEchoDetection())()
    both = scanner()
    assert echoes.GetNumberOfPoints() == other.GetNumberOfPoints() == both[0].GetNumberOfPoints()
    assert len(both) == 2 and both[1].IsA("vtkTable")


@pytest.mark.parametrize(
    "compose, error, message",
    [
        (lambda: blocks() >> 3, TypeError, "unsupported operand"),
        (lambda: "x" >> transform(1), TypeError, "unsupported operand"),
        (lambda: blocks() >> blocks(), TypeError, "vtkHeliosSyntheticScene takes no input"),
        (
            lambda: (blocks(),) * 4 >> vtkhelios.vtkHeliosScanner(),
            TypeError,
            "vtkHeliosScanner takes 3 inputs, not 4",
        ),
        (lambda: select_ports(transform(1), 1), ValueError, "no output port 1; the last one is 0"),
        (lambda: select_ports(1, blocks()), ValueError, "no input port 1; it has none"),
        (lambda: select_ports(blocks()), TypeError, "select_ports() takes"),
    ],
)
def test_what_does_not_connect(compose, error, message):
    with pytest.raises(error) as caught:
        compose()
    assert message in str(caught.value)


def test_errors_of_a_pipeline_raise():
    with pytest.raises(vtkhelios.PipelineError, match="no.obj"):
        (vtkhelios.vtkHeliosObjSceneReader(file_name="no.obj") >> transform(1))()


# Functions as filters.


@vtkhelios.filter
def within(cloud, distance=10.0):
    """Keeps near points."""
    return cloud["Range"] < distance


@vtkhelios.filter
def heights(cloud):
    cloud["Height"] = cloud.points[:, 2] + 1.0


@vtkhelios.filter
def slab(size=2.0):
    corners = [[0, 0, 0], [size, 0, 0], [0, size, 0]]
    return vtkhelios.Scene(corners, [[0, 1, 2]])


@vtkhelios.filter
def broken(cloud):
    return cloud["Rnge"] < 1


@vtkhelios.filter(output="vtkTable")
def no_table(cloud):
    return cloud


@vtkhelios.filter
def nothing_to_mask(data=1):
    return np.array([True])


def test_a_function_keeps_points(scanner):
    near = (blocks(), tripod()) >> scanner >> within(distance=15)
    cloud = vtkhelios.Cloud(near())
    assert 0 < len(cloud) < len(vtkhelios.Cloud(scanner.output))
    assert cloud["Range"].max() < 15
    near.last.distance = 12
    assert vtkhelios.Cloud(near())["Range"].max() < 12
    assert near.last.distance == 12 and repr(near.last) == "within(distance=12)"
    assert within.__doc__ == "Keeps near points." and within.function(cloud, 99).all()


def test_a_function_adds_arrays_and_leaves_its_input_alone(scanner):
    pipeline = (blocks(), tripod()) >> scanner >> heights >> within
    cloud = vtkhelios.Cloud(pipeline())
    assert np.array_equal(cloud["Height"], cloud.points[:, 2] + 1)
    assert "Height" not in vtkhelios.Cloud(scanner.output)


def test_a_function_is_a_source():
    data = (slab(size=4) >> transform(1))()
    assert data.GetBounds() == (0, 4, 0, 4, 1, 1)
    assert (slab >> transform(1))().GetBounds() == (0, 2, 0, 2, 1, 1)


def test_python_algorithm_class():
    class Up(VTKPythonAlgorithmBase):
        def __init__(self):
            super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkPolyData")

        def RequestData(self, request, inputs, outputs):
            data = vtkPolyData.GetData(inputs[0])
            vtkPolyData.GetData(outputs).ShallowCopy(transform(3)(data))
            return 1

    assert lowest((blocks() >> Up() >> transform(1))()) == pytest.approx(lowest(blocks()()) + 4)


def test_exception_of_a_function_is_the_cause():
    with pytest.raises(vtkhelios.PipelineError) as caught:
        (blocks() >> broken >> transform(1))()
    assert str(caught.value).startswith("KeyError: the cloud has no array Rnge; it has: none")
    assert isinstance(caught.value.__cause__, KeyError)
    assert caught.value.__cause__.__traceback__ is not None


@pytest.mark.parametrize(
    "make, message",
    [
        (
            lambda: blocks() >> no_table,
            "no_table() returns vtkPolyData; return a Cloud, a vtkTable",
        ),
        (
            lambda: nothing_to_mask >> transform(1),
            "returns an array, but its first input is not a cloud",
        ),
    ],
)
def test_a_wrong_result(make, message):
    with pytest.raises(vtkhelios.PipelineError) as caught:
        make()()
    assert message in str(caught.value)


def test_a_wrong_property():
    with pytest.raises(AttributeError, match=r"within\(\) has no property size; it has: distance"):
        within(size=3)
    with pytest.raises(AttributeError, match="has no attribute size"):
        within().size
