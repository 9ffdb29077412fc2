# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Symbols that the libraries of a wheel would share with other copies of the same libraries.

GCC marks static members of templates STB_GNU_UNIQUE. The dynamic linker merges symbols of this kind
across the process, also between libraries that are otherwise separate, such as those of two VTKs.
Weak symbols are what they are without -fgnu-unique.
"""

from elftools.elf.elffile import ELFFile

STB_WEAK, STB_GNU_UNIQUE = 2, 10
_INFO = 4  # the offset of st_info in a symbol of a 64-bit file: binding * 16 + type


def make_unique_weak(path):
    """Changes unique symbols of a library to weak ones, in place. Returns their number."""
    with open(path, "r+b") as file:
        table = ELFFile(file).get_section_by_name(".dynsym")
        start, size = table["sh_offset"] + _INFO, table["sh_entsize"]
        count = 0
        for i in range(table.num_symbols()):
            file.seek(start + i * size)
            info = file.read(1)[0]
            if info >> 4 == STB_GNU_UNIQUE:
                file.seek(start + i * size)
                file.write(bytes([STB_WEAK << 4 | info & 15]))
                count += 1
    return count
