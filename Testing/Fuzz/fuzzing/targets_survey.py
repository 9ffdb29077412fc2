# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""XML of surveys, scenes, assets and planners, and the texts in their attributes."""

import contextlib
import re
import time
import xml.sax.saxutils

from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from . import small_files
from .outcomes import check, check_finite, check_polydata
from .target import Refused, Seed, Target, command_line, pick
from .targets_points import parse_strict

LONGEST_RUN = 1.0  # [s]: a survey may take hours, so it is interrupted like by a user
LOADING = -1


class Stop(BaseException):
    """Interrupts a run that has made progress."""


def stop_after(seconds=LONGEST_RUN):
    end = time.monotonic() + seconds

    def progress(_share):
        if time.monotonic() > end:
            raise Stop

    return progress


def run_in_memory(path):
    """Reads and runs a survey, for 1 s at most; checks the result."""
    from .target import collect_warnings

    with collect_warnings():
        survey = vtkhelios.read_survey(path)
        with contextlib.suppress(Stop):
            for cloud in survey.blocks(pulses=2000, progress=stop_after(), waveforms=True):
                check_echoes(cloud.polydata)


def check_echoes(cloud):
    """Checks the guarantees on echoes."""
    check_polydata(cloud)
    data = cloud.GetPointData()
    if cloud.GetNumberOfPoints():
        number, count = (
            vtk_to_numpy(data.GetArray(n)) for n in ("ReturnNumber", "NumberOfReturns")
        )
        check((number >= 1).all() and (number <= count).all(), "return numbers above their number")


def xml_seeds(which):
    """Surveys and the files they refer to; one of them is damaged."""
    everything = small_files.encoded({**small_files.BESIDE, **small_files.SURVEYS,
                                      "plan.xml": small_files.PLANNER})  # fmt: skip
    seeds = []
    for name in which:
        beside = dict(everything)
        seeds.append(Seed(name, beside.pop(name), beside))
    return seeds


class Validate(Target):
    """vtkhelios validate on surveys, scenes, assets and planners."""

    name = "validate"
    kind = "xml"

    def make_seeds(self, folder):
        return xml_seeds([*small_files.SURVEYS, "scene.xml", "assets.xml", "plan.xml"])

    def run(self, path, data):
        import json

        out, _ = command_line("validate", path, "--json", allowed=(0, 1))
        try:
            findings = json.loads(out)
        except ValueError as error:
            raise AssertionError(f"validate --json is not valid JSON: {error}") from error
        check(all(found["message"].strip() for found in findings), "an error without a message")


class Survey(Target):
    """Surveys, scenes and assets; accepted ones are run."""

    name = "survey-xml"
    kind = "xml"

    def make_seeds(self, folder):
        return xml_seeds([*small_files.SURVEYS, "scene.xml", "assets.xml"])

    def survey_of(self, path, data):
        if path.name in small_files.SURVEYS:
            return path
        return path.with_name(pick(data, ["stand.xml", "flight.xml", "drive.xml"]))

    def run(self, path, data):
        run_in_memory(self.survey_of(path, data))


class Yaml(Survey):
    """Surveys and scenes in YAML; accepted ones are written as YAML, read again, and run."""

    name = "survey-yaml"
    kind = "json"

    def make_seeds(self, folder):
        seeds = []
        for seed in xml_seeds([*small_files.SURVEYS, "scene.xml", "assets.xml"]):
            (folder / seed.name).write_bytes(seed.data)
            path = (folder / seed.name).with_suffix(".yaml")
            vtkhelios.core.reading.convert(folder / seed.name, path)
            data = path.read_bytes().replace(b"scene.xml#", b"scene.yaml#")
            data = data.replace(b"assets.xml#", b"assets.yaml#")
            seeds.append(Seed(path.name, data, seed.beside))
        for seed in seeds:
            seed.beside.update({other.name: other.data for other in seeds if other is not seed})
        return seeds

    def survey_of(self, path, data):
        surveys = [name.replace(".xml", ".yaml") for name in small_files.SURVEYS]
        return path if path.name in surveys else path.with_name(pick(data, surveys))

    def run(self, path, data):
        try:
            text = vtkhelios.core.reading.read_xml(path)
        except ValueError as error:
            raise Refused(str(error)) from error
        again = path.with_name("again.yaml")
        check(vtkhelios.vtkHeliosDialect().WriteXml(str(again), text), "no document")
        check(
            _without_form(vtkhelios.core.reading.read_xml(again)) == _without_form(text),
            "another survey",
        )
        run_in_memory(self.survey_of(path, data))


def _without_form(xml):
    """XML without comments, line ends, and the types of parameters, which follow from their keys."""
    return re.sub(rb'(?s)<!--.*?-->|\n *|(?<=<param) type="[a-z0-9]*"', b"", xml)


class RunFiles(Survey):
    """Surveys run to files, for 1 s at most."""

    name = "survey-run"
    weight = 0.4

    def run(self, path, data):
        from .target import collect_warnings
        from .targets_points import read_points

        form = pick(data, ["xyz", "las", "vtp"])
        with collect_warnings():
            survey = vtkhelios.read_survey(self.survey_of(path, data))
            with contextlib.suppress(Stop):
                report = survey.run_to(path.with_name("out"), format=form, progress=stop_after(),
                                       waveforms=pick(data, [True, False]))  # fmt: skip
                count, _ = read_points(report["folder"], 10_000)
                told = report["totals"]["points"]
                check(count == told, f"{count} points in files, {told} in the summary")


class DryRun(Survey):
    """Surveys, with the estimate of accepted ones."""

    name = "dry-run"
    weight = 0.3

    def run(self, path, data):
        player = vtkhelios.vtkHeliosSurveyPlayer()
        from vtkhelios import PipelineError
        from vtkhelios.core.pipeline import MessageLog

        from .target import collect_warnings

        with collect_warnings():
            survey = vtkhelios.read_survey(self.survey_of(path, data))
        player.SetSurvey(survey.vtk)
        player.SetOutputDirectory(str(path.with_name("out")))
        end = time.monotonic() + LONGEST_RUN

        def watch(*_):
            if time.monotonic() > end:
                player.Abort()

        player.AddObserver("ProgressEvent", watch)
        with MessageLog() as log:
            log.watch(player)
            good = player.Estimate()
        if log.errors:
            raise PipelineError(log.root_errors())
        if good:
            parse_strict(player.GetReport())
        else:
            check(player.GetMessage().strip(), "no estimate, and no reason given")


class Planner(Target):
    """Planner documents and the assets they refer to."""

    name = "planner-xml"
    kind = "xml"

    def make_seeds(self, folder):
        return xml_seeds(["plan.xml", "assets.xml"])

    def run(self, path, data):
        from vtkhelios import PipelineError
        from vtkhelios.core.pipeline import MessageLog

        reader = vtkhelios.vtkHeliosPlannerReader()
        reader.SetFileName(str(path.with_name("plan.xml")))
        with MessageLog() as log:
            log.watch(reader)
            good = reader.Read()
        if log.errors:
            raise PipelineError(log.root_errors())
        check(good, "refused without a reason")
        plan = vtkhelios.vtkHeliosScanPlan(document=reader)
        candidates, viewsheds, planner = plan.candidates, plan.viewsheds, plan.planner
        numbers = [
            planner.minimum_coverage, planner.minimum_overlap, planner.time_limit,
            candidates.x_step, candidates.y_step, candidates.maximum_slope,
            candidates.scanner_height, plan.test_points.z_step, viewsheds.hit_tolerance,
        ]  # fmt: skip
        check_finite("settings", numbers)


class AttributeText(Target):
    """The text of an attribute of a small survey: all the text is damaged, not its quotes."""

    attribute = ""  # its location
    texts = ()

    def make_seeds(self, folder):
        return [Seed(f"{number}.txt", text, small_files.encoded(small_files.BESIDE))
                for number, text in enumerate(self.texts)]  # fmt: skip

    def quoted(self, data):
        """Quotes an attribute: control characters not allowed in XML are dropped."""
        text = data.decode("utf-8", "replace")
        text = "".join(c for c in text if c >= " " and c not in "\ufffe\uffff" or c in "\t\n")
        return xml.sax.saxutils.quoteattr(text)


class Expressions(AttributeText):
    """Error expressions, in a survey that is then run."""

    name = "expression"
    texts = (
        b"0.001 * t", b"sin(THETA) * 0.001 + 2 * pi / (1 + t^2)", b"atan2(t, 1) * -1e-3 + e - exp(1)",
        b"abs(sqrt(t) * 0.0001) + ln(2 + t) * 1e-4", b"cosh(t * 0.001) - tanh(2) - .5",
    )  # fmt: skip

    def run(self, path, data):
        survey = small_files.FLIGHT.replace('"0.001 * t"', self.quoted(data))
        path.with_name("survey.xml").write_text(survey, encoding="utf-8")
        run_in_memory(path.with_name("survey.xml"))


class Patterns(AttributeText):
    """Patterns of file names (efilepath)."""

    name = "efilepath"
    texts = (b"trees/oak_.*[.]obj", b"trees/(a+)+b[0-9]{1,3}\\.obj", b"trees/[a-z_]+_[^x]?\\d*.obj")

    def make_seeds(self, folder):
        seeds = super().make_seeds(folder)
        for seed in seeds:
            for name in ("oak_1", "oak_22", "a" * 30 + "b1", "a" * 40):
                seed.beside[f"trees/{name}.obj"] = small_files.PLANE.encode()
        return seeds

    def run(self, path, data):
        scene = small_files.SIMPLE_SCENE.replace('key="filepath"', 'key="efilepath"')
        scene = scene.replace('"plane.obj"', self.quoted(data))
        path.with_name("scene.xml").write_text(scene, encoding="utf-8")
        path.with_name("survey.xml").write_text(small_files.STAND)
        from .target import collect_warnings

        with collect_warnings():
            vtkhelios.read_survey(path.with_name("survey.xml"))


def make_targets():
    return [
        Validate(), Survey(), Yaml(), RunFiles(), DryRun(), Planner(), Expressions(), Patterns(),
    ]  # fmt: skip
