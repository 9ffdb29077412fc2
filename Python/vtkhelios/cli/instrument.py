# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios instrument: a scanner from the calibration of its manufacturer, a pulse from its records."""

import pathlib

from ..core.files import cannot_be_written, write_whole
from ..formats import FormatError
from ..surveys import instruments, measured_pulse
from ._messages import Messages
from ._standard import folder_of_standard, is_standard, read_input

SUMMARY = "write a scanner from the calibration of its manufacturer, or its recorded pulse"
STANDARD = ("path",)

EPILOG = """\
Reads the metadata of an Ouster sensor (JSON) and writes a <scanner> with optics="spinning": beams with
elevation, azimuth and origin, the rates of its mode and its place on the base. Add what metadata do not
have, such as the beam divergence, from the data sheet. In a survey: scanner="os1.xml#ID".

Of a PulseWaves file (.pls, its .wvs beside it) it writes the mean outgoing pulse, a CSV file of times [ns]
and powers for <FWFSettings pulseShape="pulse.csv"/>.

examples:
  vtkhelios instrument os1.json --output os1.xml
  vtkhelios instrument os1.json --id roof_lidar > os1.xml
  curl http://SENSOR/api/v1/sensor/metadata | vtkhelios instrument - > os1.xml
  vtkhelios instrument flight.pls --output pulse.csv

exit codes: 0 done, 1 failed, 2 wrong usage.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "path",
        metavar="FILE",
        help="metadata of an Ouster sensor (.json; - is standard input), or PulseWaves (.pls)",
    )
    parser.add_argument("--id", help="id of the scanner; default: of product and mode")
    parser.add_argument("--output", "-o", metavar="FILE", help="the file; default: print it")


def _read(arguments):
    if is_standard(arguments.path):
        with folder_of_standard() as folder:
            return instruments.read_ouster(read_input(folder / "metadata.json"), arguments.id)
    path = pathlib.Path(arguments.path)
    if path.suffix.lower() != ".pls":
        return instruments.read_ouster(arguments.path, arguments.id)
    comment = f"the mean outgoing pulse of {path.name}"
    return measured_pulse.to_text(measured_pulse.read_pulse(path), comment)


def run(arguments):
    with Messages(results=False) as messages:
        try:
            text = _read(arguments)
        except (instruments.InstrumentError, FormatError) as error:
            messages.error(str(error))
            return 1
        except OSError as error:
            messages.error(f"{arguments.path}: {error.strerror}; check the name of the file")
            return 1
        if not arguments.output:
            print(text, end="")
            return 0
        try:
            write_whole(pathlib.Path(arguments.output), text)
        except OSError as error:
            messages.error(cannot_be_written(error, arguments.output, "--output"))
            return 1
    print(arguments.output)
    return 0
