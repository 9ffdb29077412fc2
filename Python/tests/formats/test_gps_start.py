# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The GPS time at which a survey starts: by option, by attribute, and in files."""

import json
import struct

import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.learning import _mcap
from vtkhelios.learning._content import Content

START = "2017-01-01 00:00:00"
EPOCH = 1930 * 604800 + 18.0  # a week begins on that day, and GPS time is ahead by 18 s


def run(survey, output, *options):
    arguments = ["run", survey, "--output", output, "--format", "las", "--quiet", *options]
    return cli.main([str(argument) for argument in arguments])


def read_las(folder):
    """The global encoding, and the GPS time of the first point."""
    data = next(folder.rglob("*points.las")).read_bytes()
    first = struct.unpack_from("<I", data, 96)[0]
    return struct.unpack_from("<H", data, 6)[0], struct.unpack_from("<d", data, first + 22)[0]


def test_las_has_adjusted_standard_time(make_survey, tmp_path):
    survey = make_survey(stop=6)
    assert run(survey, tmp_path / "plain") == 0
    assert run(survey, tmp_path / "timed", "--gps-start", START) == 0
    encoding, time = read_las(tmp_path / "plain")
    assert encoding & 1 == 0 and 0 <= time < 1
    encoding, other = read_las(tmp_path / "timed")
    assert encoding & 1 == 1 and other == EPOCH - 1e9 + time
    with formats.open_reader(tmp_path / "timed/plane") as reader:
        assert reader.header.epoch == pytest.approx(1e9)  # offset of adjusted standard time
    options = [
        json.loads((tmp_path / name / "plane/run_summary.json").read_text())["options"]
        for name in ("plain", "timed")
    ]
    assert "gpsStart" not in options[0] and options[1]["gpsStart"] == START
    rest = {key: value for key, value in options[1].items() if key != "gpsStart"}
    assert rest == options[0]


def test_the_attribute_and_the_option_over_it(make_survey, tmp_path):
    path = make_survey(stop=6)
    path.write_text(path.read_text().replace("<survey ", f'<survey gpsStartTime="{START}" '))
    assert vtkhelios.read_survey(path).vtk.GetSurveyAttribute("gpsStartTime") == START
    cloud = vtkhelios.read_survey(path).run()
    assert cloud.data.GetFieldData().GetArray("GpsEpoch").GetTuple1(0) == EPOCH
    again = vtkhelios.read_survey(path).run(gps_start="2017-01-01T01:00:00+00:59")
    assert again.data.GetFieldData().GetArray("GpsEpoch").GetTuple1(0) == EPOCH + 60
    assert (again.points == cloud.points).all() and (again["GpsTime"] == cloud["GpsTime"]).all()
    assert run(path, tmp_path / "out", "--gps-start", "gps:1400000000") == 0
    assert 4e8 <= read_las(tmp_path / "out")[1] < 4e8 + 1
    path.write_text(path.read_text().replace(f'gpsStartTime="{START}"', ""))
    assert not vtkhelios.read_survey(path).run().data.GetFieldData().HasArray("GpsEpoch")


def test_other_times_are_errors_with_what_is_expected(make_survey, tmp_path, capsys):
    path = make_survey(stop=6)
    assert run(path, tmp_path / "out", "--gps-start", "noon") == 2
    message = capsys.readouterr().err
    assert '--gps-start "noon" is not a time; give YYYY-MM-DD hh:mm:ss of UTC' in message
    with pytest.raises(vtkhelios.PipelineError, match='GpsStart="noon" is not a time; give YYYY'):
        vtkhelios.read_survey(path).run(gps_start="noon")
    path.write_text(
        path.read_text().replace("<survey ", '<survey gpsStartTime="1979-01-01 00:00" ')
    )
    with pytest.raises(
        vtkhelios.PipelineError,
        match=r'survey.xml:2: gpsStartTime="1979.*is not after the begin of GPS',
    ):
        vtkhelios.read_survey(path)


def test_e57_and_mcap_have_it(make_survey, tmp_path):
    path = make_survey(stop=6)
    cloud = vtkhelios.read_survey(path).run(gps_start=START)
    fields = cloud.data.GetFieldData()
    pytest.importorskip("pye57")
    assert run(path, tmp_path / "out", "--gps-start", START) == 0
    e57 = tmp_path / "a.e57"
    assert cli.main(["convert", str(tmp_path / "out/plane"), str(e57), "--quiet"]) == 0
    with formats.open_reader(e57) as reader:
        chunk = next(reader.chunks())
        assert reader.header.epoch + chunk["GpsTime"][0] == pytest.approx(EPOCH, abs=1)
    pytest.importorskip("mcap")
    writer = _mcap.McapWriter(tmp_path, Content(header=formats.Header(fields)))
    assert writer._stamp(0.25) == 1483228800_250_000_000  # Unix time of the start [ns]
    assert _mcap.McapWriter(tmp_path, Content())._stamp(0.25) == 250_000_000


def test_unix_times():
    convert = vtkhelios.vtkHeliosGpsTime
    assert convert.FromUnixTime(1483228800) == EPOCH
    assert convert.ToUnixTime(EPOCH) == 1483228800
