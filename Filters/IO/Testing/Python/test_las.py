# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS files and laspy: laspy reads vtkHelios files, and vtkHelios reads laspy files."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable

import vtkhelios

laspy = pytest.importorskip("laspy")

COUNT = 5000
EPOCH = 1.4e9
EXTRA = {  # name: type, description
    "PulseIds": (np.int64, "pulse of the run"),
    "Range": (np.float64, "distance [m]"),
    "Amplitude": (np.float64, "peak of the echo [W]"),
    "EchoWidth": (np.float64, "full width at half maximum [ns]"),
    "MaterialIds": (np.int32, "material of the scene"),
    "PartIds": (np.int32, "part of the scene"),
    "IncidenceAngle": (np.float64, "from the normal [deg]"),
    "ChannelIds": (np.int32, "channel of the scanner"),
    "Counted": (np.uint16, ""),
}


def columns(count=COUNT, seed=8):
    """Values for all arrays of the scanner."""
    random = np.random.default_rng(seed)
    values = {name: random.integers(0, 1000, count) for name in EXTRA}
    for name in ("Range", "EchoWidth", "IncidenceAngle"):
        values[name] = random.uniform(0.0, 90.0, count)
    values["Amplitude"] = 10.0 ** random.uniform(-13.0, -5.0, count)
    values["PulseIds"] = 5_000_000_000 + np.arange(count)
    values = {name: values[name].astype(kind) for name, (kind, _) in EXTRA.items()}
    values["ReturnNumber"] = random.integers(1, 16, count).astype(np.uint8)
    values["NumberOfReturns"] = np.full(count, 15, np.uint8)
    values["ClassificationIds"] = random.integers(0, 256, count).astype(np.int32)
    values["LegIds"] = random.integers(0, 9, count).astype(np.int32)
    values["ScanAngle"] = random.uniform(-180.0, 180.0, count)
    values["GpsTime"] = np.sort(random.uniform(0.0, 600.0, count))
    values["TruePoint"] = random.uniform(-1e6, 1e6, (count, 3))
    return values


def make_points(count=COUNT):
    middle = [478233.5, 5471966.7, 112.5]
    return np.random.default_rng(1).uniform(-300.0, 300.0, (count, 3)) + middle


def make_cloud(points, values, crs=None, epoch=None):
    cloud = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(points, deep=True))
    cloud.SetPoints(holder)
    for name, column in values.items():
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    if crs:
        text = vtkStringArray()
        text.SetName("CRS")
        text.InsertNextValue(crs)
        cloud.GetFieldData().AddArray(text)
    if epoch is not None:
        number = numpy_to_vtk(np.array([epoch]), deep=True)
        number.SetName("GpsEpoch")
        cloud.GetFieldData().AddArray(number)
    return cloud


def write(path, *blocks, close=True, **properties):
    writer = vtkhelios.vtkHeliosLASWriter()
    writer.SetFileName(str(path))
    for name, value in properties.items():
        getattr(writer, "Set" + name)(value)
    assert writer.Open()
    assert all(writer.Write(block) for block in blocks)
    assert writer.Close() if close else writer.Abandon()
    return path


def read(path):
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(path))
    vtkhelios.update(reader)
    return reader.GetOutput()


def get(cloud, name):
    return vtk_to_numpy(cloud.GetPointData().GetArray(name))


def check_header(las, points):
    header = las.header
    assert str(header.version) == "1.4"
    assert header.point_count == len(las.points) == len(points)
    assert np.all(header.scales == 0.0001)
    assert np.array_equal(header.offsets, np.round(header.offsets))
    xyz = las.xyz
    assert np.abs(xyz - points).max() <= 0.5e-4 + 1e-8  # rounded, not truncated
    assert np.array_equal(header.mins, xyz.min(axis=0))
    assert np.array_equal(header.maxs, xyz.max(axis=0))
    counts = np.bincount(np.asarray(las.return_number), minlength=16)[1:]
    assert np.array_equal(header.number_of_points_by_return, counts)


def test_every_field_as_laspy_reads_it(tmp_path):
    values, points = columns(), make_points()
    half = COUNT // 3
    blocks = [
        make_cloud(points[part], {n: v[part] for n, v in values.items()}, "EPSG:25832", EPOCH)
        for part in (slice(0, half), slice(half, None))
    ]
    las = laspy.read(write(tmp_path / "a.las", *blocks, CreationDay=123, CreationYear=2031))
    assert las.header.point_format.id == 6
    assert las.header.generating_software == f"vtkHelios {vtkhelios.__version__}"
    assert las.header.system_identifier == "SIMULATION"
    assert las.header.creation_date.timetuple()[:1] == (2031,)
    assert las.header.creation_date.timetuple().tm_yday == 123
    check_header(las, points)
    for name, field in {
        "ReturnNumber": "return_number",
        "NumberOfReturns": "number_of_returns",
        "ClassificationIds": "classification",
    }.items():
        assert np.array_equal(las[field], values[name]), name
    assert np.array_equal(las.point_source_id, values["LegIds"] + 1)
    assert np.array_equal(las.scanner_channel, values["ChannelIds"] % 4)
    assert np.array_equal(las.scan_angle, np.rint(values["ScanAngle"] / 0.006))
    decibels = np.rint(1000.0 * np.log10(values["Amplitude"] / 1e-15))
    assert np.array_equal(las.intensity, decibels)
    assert las.header.global_encoding.gps_time_type == laspy.header.GpsTimeType.STANDARD
    assert np.array_equal(las.gps_time, values["GpsTime"] + (EPOCH - 1e9))
    for field in ("synthetic", "key_point", "withheld", "overlap", "scan_direction_flag"):
        assert not np.any(las[field]), field


def test_extra_bytes_as_laspy_reads_them(tmp_path):
    values = columns()
    las = laspy.read(write(tmp_path / "a.las", make_cloud(make_points(), values)))
    dimensions = {d.name: d for d in las.point_format.extra_dimensions}
    for name, (kind, description) in EXTRA.items():
        assert dimensions[name].dtype == kind, name
        assert dimensions[name].description == description, name
        assert np.array_equal(las[name], values[name]), name
    for k, axis in enumerate("XYZ"):
        assert np.array_equal(las["TruePoint" + axis], values["TruePoint"][:, k])
    assert len(dimensions) == len(EXTRA) + 3
    assert las.header.global_encoding.gps_time_type == laspy.header.GpsTimeType.WEEK_TIME
    assert np.array_equal(las.gps_time, values["GpsTime"])


def test_the_system_as_laspy_reads_it(tmp_path):
    las = laspy.read(write(tmp_path / "a.las", make_cloud(make_points(), {}, "EPSG:25832+7837")))
    assert las.header.global_encoding.wkt
    (record,) = las.header.vlrs.get("WktCoordinateSystemVlr")
    assert record.string.startswith('COMPD_CS["')
    assert 'AUTHORITY["EPSG","25832"]' in record.string
    assert record.string.endswith('AUTHORITY["EPSG","7837"]]]')


def test_the_part_is_readable_during_a_run(tmp_path):
    points, values = make_points(), columns()
    writer = vtkhelios.vtkHeliosLASWriter()
    writer.SetFileName(str(tmp_path / "a.las"))
    assert writer.Open()
    for end in range(1000, 4000, 1000):
        part = slice(end - 1000, end)
        assert writer.Write(make_cloud(points[part], {n: v[part] for n, v in values.items()}))
        with open(tmp_path / "a.las.part", "rb") as file:
            las = laspy.read(file)
        check_header(las, points[:end])
    assert writer.Close()


def test_colours_make_format_7(tmp_path):
    rgb = np.random.default_rng(2).uniform(0.0, 1.0, (COUNT, 3))
    las = laspy.read(write(tmp_path / "a.las", make_cloud(make_points(), {"RGB": rgb})))
    assert las.header.point_format.id == 7
    for k, colour in enumerate(("red", "green", "blue")):
        assert np.array_equal(las[colour], np.rint(65535 * rgb[:, k]))


def test_laz_is_that_of_laspy_and_lazrs(tmp_path):
    """Both read what the other one wrote."""
    pytest.importorskip("lazrs")
    cloud = make_cloud(make_points(), columns(), "EPSG:25832", EPOCH)
    path = write(tmp_path / "a.las", cloud)
    ours = write(tmp_path / "ours.laz", cloud, WriteCompressed=True)
    laspy.read(path).write(tmp_path / "theirs.laz")
    assert np.array_equal(laspy.read(ours).points.array, laspy.read(path).points.array)
    plain = read(path)
    for laz in (ours, tmp_path / "theirs.laz"):
        same = read(laz)
        assert np.array_equal(
            vtk_to_numpy(same.GetPoints().GetData()), vtk_to_numpy(plain.GetPoints().GetData())
        )
        for name in columns():
            assert np.array_equal(get(same, name), get(plain, name)), name


FORMATS = [  # per version, as supported by laspy
    (version, form)
    for version in ("1.2", "1.3", "1.4")
    for form in laspy.point.format.dims.VERSION_TO_POINT_FMT[version]
]


@pytest.mark.parametrize("version, form", FORMATS)
def test_files_of_laspy_are_read(tmp_path, form, version):
    header = laspy.LasHeader(version=version, point_format=form)
    header.scales, header.offsets = [0.001] * 3, [478000.0, 5471000.0, 0.0]
    header.add_extra_dim(laspy.ExtraBytesParams("height", "f4"))
    header.add_extra_dim(
        laspy.ExtraBytesParams("scaled", "i2", scales=np.array([0.5]), offsets=np.array([10.0]))
    )
    las = laspy.LasData(header)
    points = np.round(make_points(700), 3)
    las.x, las.y, las.z = points.T
    random = np.random.default_rng(form)
    limit = 7 if form < 6 else 15
    las.return_number = random.integers(1, limit + 1, 700)
    las.number_of_returns = np.full(700, limit)
    las.classification = random.integers(0, 32 if form < 6 else 256, 700)
    las.intensity = random.integers(0, 65536, 700)
    las.user_data = random.integers(0, 256, 700)
    las.point_source_id = random.integers(0, 65536, 700)
    las.withheld = random.integers(0, 2, 700)
    las.height = random.normal(size=700).astype(np.float32)
    las["scaled"] = 10.0 + 0.5 * random.integers(-99, 99, 700)
    las.write(tmp_path / "a.las")

    cloud = read(tmp_path / "a.las")
    assert np.abs(vtk_to_numpy(cloud.GetPoints().GetData()) - points).max() < 1e-8
    assert np.array_equal(get(cloud, "ReturnNumber"), las.return_number)
    assert np.array_equal(get(cloud, "NumberOfReturns"), las.number_of_returns)
    assert np.array_equal(get(cloud, "ClassificationIds"), las.classification)
    assert np.array_equal(get(cloud, "Intensity"), las.intensity)
    assert np.array_equal(get(cloud, "UserData"), las.user_data)
    assert np.array_equal(get(cloud, "LegIds"), np.asarray(las.point_source_id, np.int64) - 1)
    assert np.array_equal(get(cloud, "ClassificationFlags"), 4 * np.asarray(las.withheld))
    assert np.array_equal(get(cloud, "height"), las.height)
    assert np.array_equal(get(cloud, "scaled"), np.asarray(las["scaled"]))
    if "gps_time" in las.point_format.dimension_names:
        assert np.array_equal(get(cloud, "GpsTime"), las.gps_time)


SAMPLES = 100
SPACING = 0.25  # [ns]
LIGHT = 0.299792458  # [m/ns]


def make_waveforms(count):
    """A Gaussian for every pulse, the directions, and the points at its centre."""
    random = np.random.default_rng(5)
    direction = random.normal(size=(count, 3))
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    origin = make_points(count)
    start = random.uniform(500.0, 600.0, count)
    peak = 10.0 ** random.uniform(-13.0, -5.0, count)
    time = np.arange(SAMPLES) * SPACING
    samples = peak[:, None] * np.exp(-0.5 * ((time - 12.3) / 1.7) ** 2)
    table = vtkTable()
    for name, values in {
        "PulseIds": 7 * np.arange(count),
        "Origin": origin,
        "Direction": direction,
        "GpsTime": np.arange(count) / 1e5,
        "StartTime": start,
        "BinSize": np.full(count, SPACING),
        "Offset": SAMPLES * np.arange(count),
        "Count": np.full(count, SAMPLES),
    }.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        table.GetRowData().AddArray(array)
    array = numpy_to_vtk(samples.astype(np.float32).ravel(), deep=True)
    array.SetName("Samples")
    table.GetFieldData().AddArray(array)
    points = origin + (0.5 * LIGHT * (start + 12.3))[:, None] * direction
    return table, samples, direction, points


def test_waveforms_as_laspy_reads_them(tmp_path):
    table, samples, direction, points = make_waveforms(300)
    ids = 7 * np.arange(300)
    ids[::10] = -1
    writer = vtkhelios.vtkHeliosLASWriter()
    writer.SetFileName(str(tmp_path / "a.las"))
    writer.SetWriteWaveforms(True)
    assert writer.Open()
    writer.SetWaveforms(table)
    assert writer.Write(make_cloud(points, {"WaveformIds": ids}))
    assert writer.Close()

    las = laspy.read(tmp_path / "a.las")
    packets = (tmp_path / "a.wdp").read_bytes()
    assert las.header.point_format.id == 9
    assert las.header.global_encoding.waveform_data_packets_external
    assert not las.header.global_encoding.waveform_data_packets_internal
    assert len(packets) - 60 == int.from_bytes(packets[20:28], "little")
    descriptors = {
        vlr.record_id - 99: vlr.parsed_record
        for vlr in las.header.vlrs
        if isinstance(vlr, laspy.vlrs.known.WaveformPacketVlr)
    }
    has = ids >= 0
    assert np.array_equal(np.asarray(las.wavepacket_index) > 0, has)
    speed = -0.5e-3 * LIGHT * direction  # to the scanner
    for k, name in enumerate(("x_t", "y_t", "z_t")):
        assert np.allclose(las[name][has], speed[has, k], rtol=1e-6, atol=1e-12)
    assert np.allclose(las.return_point_wave_location[has], 12300.0, rtol=0.0, atol=0.5)
    # point + location * vector is the origin of the first sample, nearer to the scanner
    vector = np.stack([las["x_t"], las["y_t"], las["z_t"]], axis=1).astype(float)
    anchor = las.xyz + np.asarray(las.return_point_wave_location)[:, None] * vector
    begin = points - (0.5 * LIGHT * 12.3) * direction
    assert np.abs(anchor - begin)[has].max() < 2e-4
    assert np.all(((las.xyz - anchor) * direction).sum(axis=1)[has] > 1.0)
    for row in np.flatnonzero(has):
        descriptor = descriptors[las.wavepacket_index[row]]
        begin, size = int(las.wavepacket_offset[row]), int(las.wavepacket_size[row])
        assert descriptor.bits_per_sample == 32
        assert descriptor.waveform_compression_type == 0
        assert descriptor.temporal_sample_spacing == 250
        assert size == 4 * descriptor.number_of_samples
        numbers = np.frombuffer(packets[begin : begin + size], "<u4")
        read = descriptor.digitizer_offset + descriptor.digitizer_gain * numbers
        peak = samples[row].max()
        assert np.abs(read[:SAMPLES] - samples[row]).max() < 2.0**-22 * peak
        assert not read[SAMPLES:].any()


def test_invalid_points(tmp_path):
    points = make_points()
    points[7, 1] = np.nan
    writer = vtkhelios.vtkHeliosLASWriter()
    messages = []
    writer.AddObserver("ErrorEvent", lambda *_: messages.append(1))
    writer.SetFileName(str(tmp_path / "a.las"))
    assert writer.Open()
    assert not writer.Write(make_cloud(points, columns()))
    assert messages
    assert writer.Close()
    assert laspy.read(tmp_path / "a.las").header.point_count == 0
