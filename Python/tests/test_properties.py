# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties as attributes and keywords; errors for wrong names or values."""

import pathlib

import numpy as np
import pytest

import vtkhelios
from vtkhelios.core.properties import make_properties, properties, snake_case


@pytest.mark.parametrize(
    "camel, snake",
    [
        ("RangeMin", "range_min"),
        ("MTime", "m_time"),
        ("NumberOfSubRays", "number_of_sub_rays"),
        ("CRS", "crs"),
        ("M2", "m2"),
    ],
)
def test_names_equal_those_of_newer_vtk(camel, snake):
    assert snake_case(camel) == snake


def test_numbers_vectors_booleans_strings_and_objects():
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.range_accuracy = 0.01
    scanner.mount_position = np.array([1.0, 2.0, 3.0])
    scanner.generate_truth = True
    scanner.seed = np.int64(2**40)
    scanner.pulse_file_name = pathlib.Path("pulse.txt")
    scanner.beam_deflector = vtkhelios.vtkHeliosConicMirror(scan_angle=15)
    assert scanner.GetRangeAccuracy() == scanner.range_accuracy == 0.01
    assert scanner.GetMountPosition() == scanner.mount_position == (1, 2, 3)
    assert scanner.GetGenerateTruth() is scanner.generate_truth is True
    assert scanner.GetSeed() == 2**40
    assert scanner.GetPulseFileName() == "pulse.txt"
    assert scanner.beam_deflector is scanner.GetBeamDeflector()
    assert scanner.beam_deflector.scan_angle == 15


def test_keywords():
    scanner = vtkhelios.vtkHeliosScanner(range_min=2, sampling="fixed", mount_position=(0, 0, 1))
    assert (scanner.GetRangeMin(), scanner.GetSampling()) == (2, scanner.FIXED)
    assert scanner.GetMountPosition() == (0, 0, 1)


def test_enumerations_by_name_and_number():
    scene = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")
    assert scene.kind == "blocks" and scene.kind == scene.GetKind() and scene.kind != "plane"
    assert repr(scene.kind) == "'blocks'" and f"{scene.kind}" == "blocks"
    scene.kind = int(vtkhelios.vtkHeliosSyntheticScene(kind="terrain").kind)
    assert scene.kind == "terrain"


def test_objects_created_by_cpp_have_properties():
    assert vtkhelios.vtkHeliosScanner().beam_sampler.beam_divergence == pytest.approx(3e-4)


SCANNER = vtkhelios.vtkHeliosScanner
MIRROR = vtkhelios.vtkHeliosConicMirror


@pytest.mark.parametrize(
    "cls, name, value, error, message",
    [
        (
            SCANNER,
            "range_mni",
            1,
            AttributeError,
            "has no property range_mni; did you mean range_min?",
        ),
        (
            SCANNER,
            "RangeMin",
            1,
            AttributeError,
            "has no property RangeMin; did you mean range_min?",
        ),
        (
            MIRROR,
            "colour",
            1,
            AttributeError,
            "has no property colour; it has: pulse_frequency, scan",
        ),
        (SCANNER, "number_of_pulses", 1, AttributeError, "number_of_pulses is read only"),
        (SCANNER, "range_min", "far", TypeError, "range_min is 'far'; give a number"),
        (SCANNER, "seed", 1.5, TypeError, "seed is 1.5; give a whole number"),
        (SCANNER, "generate_truth", "no", TypeError, "generate_truth is 'no'; give True or False"),
        (SCANNER, "mount_position", (1, 2), TypeError, r"is \(1, 2\); give 3 numbers"),
        (SCANNER, "pulse_file_name", 5, TypeError, "pulse_file_name is 5; give text"),
        (SCANNER, "beam_deflector", 5, TypeError, "is 5; give a vtkHeliosBeamDeflector or None"),
        (SCANNER, "beam_deflector", SCANNER(), TypeError, "give a vtkHeliosBeamDeflector or None"),
        (SCANNER, "sampling", "some", ValueError, "is 'some'; give one of: fixed, tolerance"),
        (
            SCANNER,
            "sampling",
            9,
            ValueError,
            "is 9; give one of: fixed, tolerance; 'tolerance' is kept",
        ),
        (
            MIRROR,
            "scan_angle",
            200,
            ValueError,
            r"is 200; its valid range is \[0, 180\]; 20.0 is kept",
        ),
        (SCANNER, "seed", -1, ValueError, r"seed is -1; its valid range is \[0, 4.6"),
    ],
)
def test_errors(cls, name, value, error, message):
    made = cls()
    before = getattr(made, name, None)
    with pytest.raises(error, match=message) as caught:
        setattr(made, name, value)
    assert made.GetClassName() in str(caught.value)
    assert getattr(made, name, None) == before
    with pytest.raises(error, match=message):
        cls(**{name: value})


def test_range_given_only_in_the_documentation():
    scanner = vtkhelios.vtkHeliosScanner()
    assert not hasattr(scanner, "GetAveragePowerMinValue")
    with pytest.raises(
        ValueError, match=r"average_power is -1; its valid range is .*; 4.0 is kept"
    ):
        scanner.average_power = -1
    assert scanner.average_power == 4


def test_range_that_depends_on_another_property():
    """The ring patterns fix the number of sub-rays; the spiral takes any number."""
    with pytest.raises(
        ValueError, match=r"is 256; other properties determine it, 16 .*; 16 is kept"
    ):
        vtkhelios.vtkHeliosBeamSampler(number_of_sub_rays=256)
    sampler = vtkhelios.vtkHeliosBeamSampler(pattern="vogel", number_of_sub_rays=256)
    assert sampler.number_of_sub_rays == 256


def test_errors_of_setters_are_raised(capfd):
    sampler = vtkhelios.vtkHeliosBeamSampler()
    with pytest.raises(ValueError, match="beam_quality_factor: BeamQualityFactor is 0.5"):
        sampler.beam_quality_factor = 0.5
    assert sampler.beam_quality_factor == 0 and capfd.readouterr().err == ""


def test_wrong_name_suggests_the_nearest():
    with pytest.raises(AttributeError, match="has no property range_mni; did you mean range_min?"):
        vtkhelios.vtkHeliosScanner().range_mni
    assert not hasattr(vtkhelios.vtkHeliosScanner(), "range_mni")


def test_python_subclasses_may_have_attributes():
    class Mine(vtkhelios.vtkHeliosScanner):
        def __init__(self, label):
            super().__init__(range_min=3)
            self.label = label

    mine = Mine("x")
    assert (mine.label, mine.range_min, mine.GetRangeMin()) == ("x", 3, 3)
    mine.range_max = 10
    assert mine.GetRangeMax() == 10


def test_standard_vtk_classes_are_unchanged():
    from vtkmodules.vtkCommonCore import vtkObject

    made = vtkObject()
    made.anything = 1
    assert "m_time" not in dir(vtkObject) or make_properties(vtkObject) == {}


def test_every_property_is_readable_and_documented():
    for name in vtkhelios.__all__:
        cls = getattr(vtkhelios, name)
        if not name.startswith("vtkHelios") or not hasattr(cls, "IsA"):
            continue
        for key, value in properties(cls).items():
            assert (
                value.setter_name is None or value.__doc__ or key in ("progress", "error_code")
            ), key
        try:
            made = cls()
        except TypeError:
            continue  # abstract
        for key, value in properties(cls).items():
            before = getattr(made, key)
            if value.setter_name and before is not None and key != "progress_text":
                setattr(made, key, before)
                assert repr(getattr(made, key)) == repr(before), (name, key)


def test_units_are_documented():
    assert "[Hz]" in vtkhelios.vtkHeliosConicMirror.scan_frequency.__doc__
    # one text for a group of properties
    assert "[m]" in vtkhelios.vtkHeliosScanner.mount_orientation.__doc__


def test_repr_shows_changed_properties():
    assert repr(vtkhelios.vtkHeliosScanner()) == "vtkHeliosScanner()"
    scanner = vtkhelios.vtkHeliosScanner(range_accuracy=0.01, sampling="fixed")
    scanner.echo_detector = vtkhelios.vtkHeliosGaussianDecomposition()
    assert repr(scanner) == (
        "vtkHeliosScanner(echo_detector=vtkHeliosGaussianDecomposition, range_accuracy=0.01, "
        "sampling='fixed')"
    )
