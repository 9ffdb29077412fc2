# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damages the bytes of a file, the same way for the same random numbers.

A mutator is a function of (data, random) that returns bytes. ``mutate`` applies one to four of the
mutators of a kind of file.
"""

import re

NUMBER = re.compile(rb"(?<![\w.])[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
TAG = re.compile(rb"<(/?)([A-Za-z_][\w:.-]*)([^<>]*?)(/?)>")
VALUE = re.compile(rb'="([^"]*)"')

NUMBERS = (
    b"nan", b"inf", b"-inf", b"1e308", b"-1e308", b"1e-320", b"1e999", b"-0", b"0", b"-1", b"1",
    b"2", b"255", b"256", b"32768", b"65536", b"2147483647", b"2147483648", b"-2147483649",
    b"4294967296", b"9223372036854775807", b"9223372036854775808", b"18446744073709551616",
    b"99999999999999999999999", b"1e9", b"1e18", b"0.1", b"1,5", b"1.5.5", b"0x10", b"1e", b"+",
    b"", b"abc", b"1_000", b"\xd9\xa1",
)  # fmt: skip
TRAPS = NUMBERS + (
    b"\n", b"\r", b" ", b"\t", b"/", b"//", b"\\\n", b"#", b"<", b">", b"&", b"&#0;", b'"', b"'",
    b"{", b"}", b"[", b"]", b"(", b")", b"\x1b[31m", b"%s%n", b"../../../etc/passwd", b"\0",
    b"\xef\xbb\xbf", b"\xff\xfe", b"\xc3(", b"\xed\xa0\x80", b"\xf4\x90\x80\x80",
)  # fmt: skip
LONGEST = 200_000  # bytes added by a mutator at one position


# Bytes.


def cut_off(data, random):
    return data[: random.randrange(len(data) + 1)]


def change_bytes(data, random):
    first, last = _range(data, random)
    return data[:first] + random.randbytes(last - first) + data[last:]


def flip_bit(data, random):
    if not data:
        return data
    place = random.randrange(len(data))
    return data[:place] + bytes([data[place] ^ 1 << random.randrange(8)]) + data[place + 1 :]


def delete_bytes(data, random):
    first, last = _range(data, random)
    return data[:first] + data[last:]


def double_bytes(data, random):
    first, last = _range(data, random)
    return data[:last] + data[first:]


def move_bytes(data, random):
    first, last = _range(data, random)
    place = random.randrange(len(data) + 1)
    return data[:place] + data[first:last] + data[place:]


def insert_trap(data, random):
    first, last = _range(data, random)
    last = random.choice((first, last))
    return data[:first] + random.choice(TRAPS) + data[last:]


def insert_zeros(data, random):
    place = random.randrange(len(data) + 1)
    return data[:place] + bytes(random.choice((1, 2, 8, 64, 4096))) + data[place:]


def append_bytes(data, random):
    return data + random.choice((b"\0" * 16, random.randbytes(40), data[-100:], b"\n\n"))


def _range(data, random, longest=16):
    first = random.randrange(len(data) + 1)
    return first, min(len(data), first + random.randint(1, longest))


# Binary headers.


def change_integer(data, random, begin=0, end=400):
    """Replaces a possible integer of a header by a critical value."""
    end = min(end, len(data))
    width = random.choice((1, 2, 4, 8))
    if end - begin < width:
        return data
    place = random.randrange(begin, end - width + 1)
    if random.random() < 0.7:
        place -= place % 2
    top = 1 << 8 * width
    old = int.from_bytes(data[place : place + width], "little")
    value = random.choice(
        (0, 1, 2, top - 1, top // 2 - 1, top // 2, len(data), len(data) - 1, len(data) + 1,
         old + 1, old - 1, old * 2, old // 2, 255, 65535)
    )  # fmt: skip
    order = random.choice(("little", "little", "big"))
    return data[:place] + (value % top).to_bytes(width, order) + data[place + width :]


def change_integer_anywhere(data, random):
    begin = random.randrange(len(data) + 1)
    return change_integer(data, random, begin, begin + 64)


# Texts.


def change_number(data, random):
    found = list(NUMBER.finditer(data[:LONGEST]))
    if not found:
        return insert_trap(data, random)
    place = random.choice(found)
    return data[: place.start()] + random.choice(NUMBERS) + data[place.end() :]


def swap_numbers(data, random):
    found = list(NUMBER.finditer(data[:LONGEST]))
    if len(found) < 2:
        return data
    one, other = sorted(random.sample(found, 2), key=lambda match: match.start())
    return (
        data[: one.start()] + other[0] + data[one.end() : other.start()] + one[0]
        + data[other.end() :]
    )  # fmt: skip


def damage_lines(data, random):
    """Deletes, duplicates, swaps, joins, cuts or lengthens lines."""
    lines = data.splitlines(keepends=True)
    if not lines:
        return data
    here, there = random.randrange(len(lines)), random.randrange(len(lines))
    what = random.randrange(7)
    if what == 0:
        del lines[here]
    elif what == 1:
        lines.insert(there, lines[here])
    elif what == 2:
        lines[here], lines[there] = lines[there], lines[here]
    elif what == 3:
        lines[here] = lines[here].rstrip(b"\r\n") + b" "
    elif what == 4:
        words = lines[here].split(b" ")
        del words[random.randrange(len(words))]
        lines[here] = b" ".join(words)
    elif what == 5:
        lines[here] *= random.choice((2, 10, 500))
    else:
        lines[here] = lines[here].rstrip(b"\r\n") + random.choice(TRAPS) * 3 + b"\n"
    return b"".join(lines)[: max(len(data), LONGEST)]


def lengthen(data, random):
    """A very long line, word or run of brackets."""
    place = random.randrange(len(data) + 1)
    unit = random.choice((b" ", b"9", b"a", b"(", b"[", b"{", b"-", b"1 ", b"0,", b"/", b"\n"))
    count = random.choice((100, 5000, 100_000)) // len(unit)
    return data[:place] + unit * count + data[place:]


def change_line_ends(data, random):
    return data.replace(b"\n", random.choice((b"\r\n", b"\r", b"\n\n", b"\n \n")))


# XML.


def damage_elements(data, random):
    """Deletes, duplicates, moves, misspells or nests an element, by its tags only."""
    tags = list(TAG.finditer(data[:LONGEST]))
    if not tags:
        return insert_trap(data, random)
    tag = random.choice(tags)
    first, last = tag.start(), _end_of(data, tag, tags)
    element = data[first:last]
    what = random.randrange(6)
    if what == 0:
        return data[:first] + data[last:]
    if what == 1:
        return data[:last] + element + data[last:]
    if what == 2:
        place = random.choice(tags).end()
        return data[:place] + element + data[place:]
    if what == 3:
        name = bytearray(tag[2])
        name[random.randrange(len(name))] = random.choice(b"abcxyz_")
        return data[: tag.start(2)] + bytes(name) + data[tag.end(2) :]
    if what == 4:
        depth = random.choice((2, 50, 5000))
        head = b"<" + tag[2] + b">"
        return data[:first] + head * depth + element + b"</" + tag[2] + b">" * depth + data[last:]
    return (
        data[: tag.start(1)]
        + random.choice((b"/", b"?", b"!--", b"![CDATA["))
        + data[tag.start(1) :]
    )


def _end_of(data, tag, tags):
    """End of the element of a tag."""
    if tag[1] or tag[4]:
        return tag.end()
    depth = 0
    for other in tags:
        if other.start() < tag.start() or other[2] != tag[2] or other[4]:
            continue
        depth += -1 if other[1] else 1
        if depth == 0:
            return other.end()
    return tag.end()


def damage_attributes(data, random):
    """Deletes, duplicates, empties or swaps values, or inserts bad values or units."""
    found = list(VALUE.finditer(data[:LONGEST]))
    if not found:
        return change_number(data, random)
    one, other = random.choice(found), random.choice(found)
    what = random.randrange(5)
    if what == 0:
        value = random.choice(TRAPS).replace(b'"', b"&quot;").replace(b"<", b"&lt;")
    elif what == 1:
        value = other[1]
    elif what == 2:
        value = _in_other_unit(one[1], random)
    elif what == 3:
        value = one[1] + b" " + one[1]
    else:
        begin = data.rfind(b" ", 0, one.start())
        return data[:begin] + data[one.end() :] if begin > 0 else data
    return data[: one.start(1)] + value + data[one.end(1) :]


def _in_other_unit(text, random):
    try:
        value = float(text)
    except ValueError:
        return text + text
    factor = random.choice((1000, 0.001, 57.3, 0.0174, 1e6, 1e-6, 1e9, 1e-9, -1, 100, 0.01))
    return repr(value * factor).encode()


def nest_json(data, random):
    opening, closing = random.choice(((b"[", b"]"), (b'{"a":', b"}")))
    depth = random.choice((2, 200, 20_000))
    place = random.randrange(len(data) + 1)
    return random.choice(
        (opening * depth + data + closing * depth, data[:place] + opening * depth + data[place:])
    )


BYTES = (
    cut_off, change_bytes, flip_bit, delete_bytes, double_bytes, move_bytes, insert_trap,
    insert_zeros, append_bytes,
)  # fmt: skip
TOKENS = (change_number, change_number, change_number, swap_numbers, damage_lines, damage_lines)
KINDS = {
    "text": BYTES + TOKENS + TOKENS + (lengthen, change_line_ends),
    "binary": BYTES + (change_integer,) * 6 + (change_integer_anywhere,) * 3,
    "mixed": BYTES + TOKENS + (change_integer, change_integer_anywhere),
    "xml": BYTES + (damage_attributes,) * 8 + (damage_elements,) * 4 + (change_number,) * 2
    + (lengthen,),
    "json": BYTES + TOKENS + (change_number,) * 4 + (lengthen, nest_json),
}  # fmt: skip


def mutate(data, kind, random):
    """The data with one to four mutations of a file kind."""
    for _ in range(random.choice((1, 1, 1, 2, 3, 4))):
        data = random.choice(KINDS[kind])(data, random)
    return data
