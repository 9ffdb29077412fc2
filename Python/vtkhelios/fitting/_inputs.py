# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The points of a flight, in metres and in the order of their times, and its strips."""

import numpy as np

from .. import formats

from ..array_names import (
    AMPLITUDE, CHANNEL_IDS, CLASSIFICATION_IDS, EDGE_OF_FLIGHT_LINE, GPS_TIME, INTENSITY, LEG_IDS,
    NUMBER_OF_RETURNS, RETURN_NUMBER, SCAN_ANGLE, SCAN_DIRECTION_FLAG,
)  # fmt: skip
from ..comparison._inputs import chunk_of, describe, is_path, list_files
from ..core.systems import Metres, find_difference
from ..core.words import counted
from ..formats import FormatError

KEPT = (
    AMPLITUDE, CHANNEL_IDS, CLASSIFICATION_IDS, EDGE_OF_FLIGHT_LINE, GPS_TIME, INTENSITY, LEG_IDS,
    NUMBER_OF_RETURNS, RETURN_NUMBER, SCAN_ANGLE, SCAN_DIRECTION_FLAG,
)  # fmt: skip
FARTHEST = 1e12  # limit of coordinates; larger ones are damaged
GAP = 10.0  # without a point [s], between strips
FEWEST = 1000  # pulses of a strip


class Flight:
    """The points of all clouds: columns by array name, sorted by time; points in metres."""

    def __init__(self, name, columns, crs, notes):
        self.name, self.columns, self.crs, self.notes = name, columns, crs, notes

    def __len__(self):
        return len(self.columns["points"])

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]

    def get(self, name):
        """Returns an array, or None."""
        return self.columns.get(name)


def read_flight(clouds, on_step, unit, limit):
    """Returns the Flight of some clouds; FormatError if they have no points or no times."""
    parts, crs, notes, total = [], "", [], 0
    names = []
    for given in clouds:
        names.append(str(given) if is_path(given) else describe(given))
        for chunk, header, more in _chunks_of(given):
            total += len(chunk["points"])
            if total > limit:
                raise FormatError(
                    f"{names[-1]}: the clouds have more than {counted(limit, 'point')}; give fewer strips, "
                    "or more points in memory"
                )
            if crs and (problem := find_difference(crs, header.crs)):
                raise FormatError(
                    f"{names[-1]}: the coordinate systems of the clouds differ: {problem}"
                )
            crs = crs or header.crs
            notes += [note for note in more if note not in notes]
            parts.append({name: chunk[name] for name in ("points", *KEPT) if name in chunk})
            on_step(f"reading {names[-1]}, {total / 1e6:.2f} M points", 0.0)
    name = names[0] if len(names) == 1 else f"{names[0]} and {len(names) - 1} more"
    if total == 0:
        raise FormatError(f"{name}: has no points; give a cloud with points")
    return _join(name, parts, crs, notes, unit)


def _chunks_of(given):
    if not is_path(given):
        chunk, header = chunk_of(given)
        yield chunk, header, ()
        return
    for path in list_files(given):
        with formats.open_reader(path) as reader:
            for chunk in reader.chunks():
                yield chunk, reader.header, ()
            yield {"points": np.empty((0, 3))}, reader.header, reader.notes


def _join(name, parts, crs, notes, unit):
    parts = [part for part in parts if len(part["points"])]
    common = [key for key in parts[0] if all(key in part for part in parts)]
    columns = {key: np.concatenate([part[key] for part in parts]) for key in common}
    _check(name, columns)
    if unit is None:
        metres = Metres(crs)
        if problem := metres.refuse_degrees(columns["points"][0]):
            raise FormatError(f"{name}: {problem}")
        columns["points"] = metres.convert(columns["points"])
        notes = [*notes, f"{name}: {metres.note}"] if metres.note else notes
    elif unit != 1:
        columns["points"] = columns["points"] * unit
        notes = [
            *notes,
            f"{name}: coordinates have units of {unit:.9g} m; they are converted to metres",
        ]
    order = np.argsort(columns[GPS_TIME], kind="stable")
    columns = {key: values[order] for key, values in columns.items()}
    return Flight(name, columns, crs, notes)


def _check(name, columns):
    points = columns["points"]
    wrong = ~(np.abs(points) <= FARTHEST).all(axis=1)
    if wrong.any():
        row = int(np.flatnonzero(wrong)[0])
        place = ", ".join(f"{value:g}" for value in points[row])
        raise FormatError(
            f"{name}: point {row} is ({place}), expected numbers within {FARTHEST:g}; correct it, or "
            "drop it with vtkhelios convert"
        )
    if GPS_TIME not in columns:
        raise FormatError(
            f"{name}: has no {GPS_TIME}, which identifies the pulses; give a cloud with times, as "
            "LAS of point format 1, 3 or 6 to 10"
        )
    times = columns[GPS_TIME]
    finite = np.isfinite(times)
    if not finite.any() or np.ptp(times[finite]) == 0:
        raise FormatError(
            f"{name}: {GPS_TIME} is {times[0]:g} at all points, so that no pulses are known; give a "
            "cloud with times"
        )
    if not finite.all():
        columns.update({key: values[finite] for key, values in columns.items()})


def find_strips(flight):
    """Returns the rows of the strips, and their LegIds or None; notes on strips that are too
    short."""
    times = flight[GPS_TIME]
    source = flight[LEG_IDS] if LEG_IDS in flight else np.zeros(len(times), np.int64)
    strips = []
    for number in np.unique(source):
        rows = np.flatnonzero(source == number)
        ends = np.flatnonzero(np.diff(times[rows]) > GAP) + 1
        for part in np.split(rows, ends):
            strips.append((part, int(number) if LEG_IDS in flight else None))
    strips.sort(key=lambda strip: times[strip[0][0]])
    good, notes, most = [], [], 0
    for rows, number in strips:
        pulses = len(np.unique(times[rows]))
        most = max(most, pulses)
        if pulses >= FEWEST:
            good.append((rows, number))
        else:
            notes.append(
                f"a strip of {pulses} pulses at {GPS_TIME} {times[rows[0]]:.3f} is left out; "
                f"{FEWEST} are needed"
            )
    if not good:
        raise FormatError(
            f"{flight.name}: has {most} pulses in its longest strip, too few for a fit; give a cloud "
            f"with {FEWEST} or more of different {GPS_TIME}, no more than {GAP:g} s apart"
        )
    return good, notes


class Pulses:
    """The pulses of a strip by time: the first return of each, and the lines through the first and
    the last return of those with several."""

    def __init__(self, flight, rows):
        if CHANNEL_IDS in flight:
            channel = flight[CHANNEL_IDS][rows]
            rows = rows[channel == np.bincount(channel - channel.min()).argmax() + channel.min()]
        times = flight[GPS_TIME][rows]
        number = flight[RETURN_NUMBER][rows] if RETURN_NUMBER in flight else np.ones(len(rows))
        rows = rows[np.lexsort((number, times))]
        self.rows = rows
        self.times, first, counts = np.unique(
            flight[GPS_TIME][rows], return_index=True, return_counts=True
        )
        self.first = rows[first]
        self.points = flight["points"][self.first]
        self.last = flight["points"][rows[first + counts - 1]]
        self.is_whole = np.zeros(len(first), bool)
        if RETURN_NUMBER in flight and NUMBER_OF_RETURNS in flight:
            of = flight[NUMBER_OF_RETURNS][self.first]
            final = flight[RETURN_NUMBER][rows[first + counts - 1]]
            self.is_whole = (flight[RETURN_NUMBER][self.first] == 1) & (final == of)
            self.is_whole &= (of > 1) & (counts == of)
        self._flight = flight

    def __len__(self):
        return len(self.times)

    def get(self, name):
        """Returns an array at the first returns, or None."""
        return self._flight[name][self.first] if name in self._flight else None
