# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Output of runs: the journal and parts of an interrupted one, the summary of a finished one."""

import os

import vtkhelios

from . import small_files
from .outcomes import check, check_count
from .target import Seed, Target, collect_warnings, command_line, need
from .targets_points import parse_strict, read_points

CHARTS = ("matplotlib.pyplot", "matplotlib.backends.backend_agg", "vtkhelios.reports.charts")
BLOCK = 40  # pulses
POINTS = ("_points", "_trajectory", "_pulse", "_fullwave")


def is_data(name):
    """Returns whether a file of a run must be identical in any case."""
    return any(part in name for part in POINTS)


class Journal(Target):
    """Resumes an interrupted run with a damaged journal or part: byte-identical, or an error."""

    kind = "json"

    def __init__(self, form):
        self.name = f"journal-{form}"
        self.form = form
        self.weight = 0.7

    def make_seeds(self, folder):
        small_files.write_survey(folder, small_files.STAND, small_files.SIMPLE_SCENE)
        resume(folder, self.form, resume=False)
        resume(folder, self.form, resume=False, blocks=5, output="broken")
        beside = small_files.files_below(folder)
        beside = {
            name.replace("out/", "whole/", 1) if name.startswith("out/") else name: data
            for name, data in beside.items()
        }
        seeds = []
        for name in beside:
            if name.endswith("run.journal") or (name.endswith(".part") and is_data(name)):
                others = dict(beside)
                seeds.append(Seed(name, others.pop(name), others))
        journal = [seed for seed in seeds if seed.name.endswith("run.journal")]
        return journal * 3 + seeds

    def run(self, path, data):
        folder = path
        while not (folder / "survey.xml").is_file():
            folder = folder.parent
        with collect_warnings():
            resume(folder, self.form, resume=True, output="broken")
        whole = small_files.files_below(folder / "whole")
        found = small_files.files_below(folder / "broken")
        for name, right in whole.items():
            if is_data(name):
                check(name in found, f"{name} is missing after a resume that succeeded")
                check(found[name] == right, f"{name} has other bytes after a resume that succeeded")
        told, right = (files["stand/run_summary.json"] for files in (found, whole))
        check(counts_of(told) == counts_of(right), "the summary has other counts")


def counts_of(summary):
    """The values equal in two summaries of the same run."""
    summary = parse_strict(summary.decode())

    def strip(value):
        if isinstance(value, dict):
            return {
                key: strip(each) for key, each in value.items()
                if "time" not in key.lower() and "second" not in key.lower() and key != "options"
            }  # fmt: skip
        return [strip(each) for each in value] if isinstance(value, list) else value

    return strip({key: summary[key] for key in ("legs", "totals") if key in summary})


def resume(folder, form, resume, blocks=None, output="out"):
    """Runs the survey of a folder; optionally only some blocks, then stops like Ctrl-C."""
    from vtkhelios import PipelineError
    from vtkhelios.core.pipeline import MessageLog

    os.chdir(folder)  # names do not depend on the folder
    survey = vtkhelios.read_survey("survey.xml")
    player = vtkhelios.vtkHeliosSurveyPlayer()
    player.SetSurvey(survey.vtk)
    player.SetOutputDirectory(output)
    player.SetFormat(form)
    player.SetResume(resume)
    player.SetPulsesPerBlock(BLOCK)
    if blocks:
        seen = []

        def stop(*_):
            seen.append(player.GetCount("pulses"))
            if player.GetCount("pulses") >= blocks * BLOCK:
                player.Abort()

        player.AddObserver("ProgressEvent", stop)
    with MessageLog() as log:
        log.watch(player)
        good = player.Run()
    if log.errors:
        raise PipelineError(log.root_errors())
    if not good and not blocks:
        check(player.GetMessage().strip(), "no run, and no reason given")
        raise PipelineError([player.GetMessage()])
    check(not (good and blocks), "the run of seeds was not interrupted")


class Summary(Target):
    """A command on the folder of a run with a damaged summary."""

    kind = "json"

    def __init__(self, command, weight):
        self.command = command
        self.name = f"summary-{command}"
        self.modules = CHARTS if command == "report" else ()
        self.weight = weight

    def missing(self):
        return need("matplotlib") if self.command == "report" else ""

    def make_seeds(self, folder):
        seeds = []
        for form in ("xyz", "las"):
            work = folder / form
            work.mkdir()
            run = small_files.run_survey(
                work, small_files.STAND, "--format", form, scene=small_files.SIMPLE_SCENE
            )
            beside = {f"{form}/{name}": data for name, data in small_files.files_below(run).items()}
            name = f"{form}/run_summary.json"
            seeds.append(Seed(name, beside.pop(name), beside))
        return seeds

    def run(self, path, data):
        run = path.parent
        files = sorted(path.name for path in run.glob("*_points*") if path.suffix != ".json")
        total = sum(read_points(run / name, 100_000)[0] for name in files)
        if self.command == "info":
            out, told = command_line("info", run, "--json")
            facts = parse_strict(out)
            check_count(facts["points"], total, facts["warnings"] or "warning" in told)
            command_line("info", run)
        elif self.command == "report":
            page = run / "page.html"
            command_line("report", run, "--output", page)
            check_page(page.read_text(encoding="utf-8", errors="strict"))
        else:
            output = run / "all.ply"
            _, told = command_line("convert", run, output)
            check_count(read_points(output, 100_000)[0], total, "warning" in told)


def check_page(text):
    """A page without script from the summary."""
    check("</html>" in text, "the page is incomplete")
    check(
        "<script>alert" not in text and "onerror=alert" not in text,
        "a script in the page is not escaped",
    )


class ReportPoints(Target):
    """The report on a run with damaged point files."""

    name = "report-points"
    modules = CHARTS
    kind = "text"
    weight = 0.1

    def missing(self):
        return need("matplotlib")

    def make_seeds(self, folder):
        run = small_files.run_survey(folder, small_files.STAND, scene=small_files.SIMPLE_SCENE)
        beside = small_files.files_below(run)
        seeds = []
        for name in ("leg000_points.xyz", "leg000_trajectory.txt"):
            others = dict(beside)
            seeds.append(Seed(name, others.pop(name), others))
        return seeds

    def run(self, path, data):
        command_line("report", path.parent, "--output", path.with_name("page.html"))
        check_page(path.with_name("page.html").read_text(encoding="utf-8"))


def make_targets():
    return [
        Journal("xyz"), Journal("las"), Journal("vtp"),
        Summary("info", 1.0), Summary("convert", 0.5), Summary("report", 0.1), ReportPoints(),
    ]  # fmt: skip
