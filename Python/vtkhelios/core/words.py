# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as words: counts with their nouns, settings with units, durations, amounts, speeds."""

import math
import re


def duration(seconds):
    """1:02:03, 2:03 or 0:03; dashes for None."""
    if seconds is None:
        return "-:--"
    whole = int(seconds + 0.5)
    hours, minutes = whole // 3600, whole // 60 % 60
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"


def amount(count):
    """Returns a number of pulses or points: 20,850, 1.23 M."""
    return f"{count / 1e6:,.2f} M" if count >= 999_995 else f"{count:,}"


def speed(rate):
    """Returns a rate, to three digits: 0.25, 3,900, 1.23 M."""
    if rate >= 999_500:
        return f"{rate / 1e6:,.2f} M"
    if rate < 10:
        return f"{rate:.2g}"
    return f"{round(rate, 2 - math.floor(math.log10(rate))):,.0f}"


# The ends of keys, as in halfSwath_deg, the longest first; and names that are not made of words.
UNITS = {
    "_1_m2": "/m²", "_m_s": "m/s", "_percent": "%", "_deg": "deg", "_MiB": "MiB", "_Hz": "Hz",
    "_m2": "m²", "_ns": "ns", "_m": "m", "_s": "s",
}  # fmt: skip
NAMES = {"nohd": "NOHD", "crs": "Coordinate system"}
WORDS = {"max": "maximum", "min": "minimum"}
VERBS = {"are": "is", "have": "has"}


def noun(number, singular):
    """Returns the form of a noun after a number: 1 echo, 2 echoes."""
    if number == 1:
        return singular
    if re.search("(s|x|ch|sh|echo)$", singular):
        return f"{singular}es"
    return re.sub("(?<=[^aeiou])y$", "ie", singular) + "s"


def counted(number, singular, verb=""):
    """Returns a count with its noun, and a verb: 1 flight line, 1,200 flight lines, 1 point is, 2 points are."""
    verb = VERBS[verb] if verb and number == 1 else verb
    return f"{number:,} {noun(number, singular)} {verb}".rstrip()


def digits(value, significant=4):
    """Returns a number with as many digits, all of those before the point, without zeros at its end."""
    if isinstance(value, int) or not math.isfinite(value):
        return f"{value:,}"
    size = math.floor(math.log10(abs(value))) if value else 0
    if size < -4:
        return f"{value:.{significant}g}"
    text = f"{value:,.{max(0, significant - 1 - size)}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def between(low, high, unit, significant=4):
    """Returns two ends of a range, or one value if they are the same: 60 to 78 m, 100 m."""
    ends = dict.fromkeys((digits(low, significant), digits(high, significant)))
    return f"{' to '.join(ends)} {unit}"


def time_span(seconds):
    """Returns a duration for a sentence: 0.27 s, 12 s, 2 min 05 s, 1 h 02 min."""
    if seconds < 59.5:
        return f"{digits(float(seconds), 2)} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02} min" if hours else f"{minutes} min {rest:02} s"


def describe_setting(key, value):
    """Returns a setting of a summary, such as halfSwath_deg, as its name and its value with the unit."""
    end = next((end for end in UNITS if key.endswith(end)), "")
    stem = key.removesuffix(end)
    words = re.sub("([A-Z])", r" \1", stem).replace("_", " ").lower().split()
    name = NAMES.get(stem) or " ".join(WORDS.get(word, word) for word in words)
    return name[:1].upper() + name[1:], f"{_describe(value)} {UNITS.get(end, '')}".rstrip()


def _describe(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        return digits(value)
    if isinstance(value, (list, tuple)):
        return ", ".join(map(_describe, value))
    return str(value)


def describe_settings(settings):
    """Returns the settings of a summary that are set, as rows of a page."""
    return [describe_setting(key, value) for key, value in settings.items() if value is not None]


def no_attribute(owner, name, reason=None):
    """Returns the AttributeError of a name, without the suggestion that Python adds to its own."""
    error = AttributeError(reason or f"{type(owner).__name__} has no attribute {name}")
    error.name, error.obj = "", None  # else it suggests another name beside ours
    return error
