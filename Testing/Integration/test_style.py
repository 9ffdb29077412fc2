# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Formatting, spelling and licence lines of all tracked files."""

import ast
import collections
import io
import pathlib
import re
import shutil
import subprocess
import sys
import tokenize

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tracked(*suffixes):
    """The tracked files with these suffixes (none: all), without inputs of the fuzz tests and sources
    of LASzip."""
    if not shutil.which("git") or not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    listing = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True, text=True
    ).stdout
    files = [pathlib.Path(name) for name in listing.split("\0") if name]
    return [
        str(path)
        for path in files
        if (not suffixes or path.suffix in suffixes)
        and not {"seeds", "LASzip"} & set(path.parts)
        and (ROOT / path).is_file()
    ]


def run(tool, *arguments):
    """Returns the output of a tool of the environment or of the system; skips if it is not
    installed."""
    program = shutil.which(tool, path=pathlib.Path(sys.executable).parent) or shutil.which(tool)
    if not program:
        pytest.skip(f"{tool} is not installed")
    done = subprocess.run(
        [program, *arguments],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return done.returncode, done.stdout


def test_clang_format():
    code, text = run("clang-format-14", "--dry-run", "-Werror", *tracked(".h", ".cxx"))
    assert code == 0, f"run clang-format-14 -i:\n{text}"


def test_black():
    code, text = run("black", "--check", "--quiet", *tracked(".py"))
    if "does not match the running version" in text:
        pytest.skip("black is not the version of pyproject.toml")
    assert code == 0, f"run black on:\n{text}"


def test_ruff():
    code, text = run("ruff", "check", "--quiet", "--no-cache", *tracked(".py", ".ipynb"))
    assert code == 0, text


def test_spelling():
    code, text = run(
        "codespell", *tracked(".h", ".cxx", ".py", ".md", ".sh", ".cmake", ".xml", ".txt")
    )
    assert code == 0, text


def test_licence_lines():
    files = tracked(".h", ".cxx", ".py", ".sh", ".cmake", ".module", ".in", ".toml", ".yml") + [
        name for name in tracked(".txt") if name.endswith("CMakeLists.txt")
    ]
    missing = [name for name in files if "SPDX-License-Identifier" not in (ROOT / name).read_text()]
    assert missing == []


def test_folders_are_small():
    sizes = collections.Counter(str(pathlib.Path(name).parent) for name in tracked())
    assert {folder: size for folder, size in sizes.items() if size >= 40} == {}


# Verbs that do not say what a function does (CONTRIBUTING.md); properties and VTK's names are allowed.
_VERBS = re.compile(
    r"\b(?!(?:TakeReference|TakeSmartPointer|TellG|Keep(?:Invalid|Grids|FileTimes)\w*|"
    r"Keeps\w*)\b)(?:Take|Put|Look|Keep|Tell|Complain|Judge|Note|Shake|Relate|Settle|Ask|Answer)"
    r"(?:[A-Z]\w*)?\("
)


def find_verbs(text):
    """The names of functions in C++ with a verb that does not say what happens."""
    code = re.sub(r"//[^\n]*|>::Take\(", "", text)
    return [name for name in _VERBS.findall(code) if name != "Note("]


def test_verbs_are_found():
    assert find_verbs("void TellAll();\nint Put(int);\nx.LookAtRow(3);") == [
        "TellAll(",
        "Put(",
        "LookAtRow(",
    ]
    assert find_verbs("vtkSmartPointer<A>::Take(b); r->KeepInvalidOn(); = Note();") == []


def test_functions_are_named_by_verbs():
    found = {
        name: find_verbs((ROOT / name).read_text())
        for name in tracked(".h", ".cxx")
        if "heliosConeTest" not in name
    }
    assert {name: verbs for name, verbs in found.items() if verbs} == {}


def test_errors_are_a_status():
    told = [
        name
        for name in tracked(".h", ".cxx")
        if re.search(
            r"or (an )?empty string", " ".join((ROOT / name).read_text().replace("///", "").split())
        )
    ]
    assert told == [], "return helios::Status (heliosStatus.h)"


# Openings of comments that leave out their subject: "Of a run", "as in the file", "What a file has".
_NO_SUBJECT = re.compile(r"(?:@[{\w]+\s+)*(?:of|as|that of|those of|what)\b", re.IGNORECASE)
_CXX_TOKENS = re.compile(
    r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/', re.DOTALL
)
_HEAD = re.compile(r"(?:SPDX-[^\n]*\n\s*)+")


def find_cxx_comments(text):
    """Yields line and text of every comment of C++; lines of // that follow each other are one."""
    lines = text.split("\n")
    begin, block, end, line, at = 0, [], 0, 1, 0
    for token in _CXX_TOKENS.finditer(text):
        comment = token.group()
        if comment[0] != "/":
            continue
        line, at = line + text.count("\n", at, token.start()), token.start()
        whole = lines[line - 1].strip().startswith("//")
        if block and not (whole and line == end + 1 and comment[:3] == block[0][:3]):
            yield begin, _strip(block)
            block = []
        begin = begin if block else line
        block.append(comment)
        end = line if whole else 0
    if block:
        yield begin, _strip(block)


def _strip(comments):
    """Returns the words of comments without their marks, and without the licence."""
    words = "\n".join(re.sub(r"(?m)^\s*(?:/\*+|\*+/?|///?[<!]?)|\*+/$", "", c) for c in comments)
    return _HEAD.sub("", words.strip()).strip()


def find_python_comments(text):
    """Yields line and text of every docstring and comment of Python."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)):
            words = ast.get_docstring(node)
            if words:
                yield node.body[0].lineno, words
    end = 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            line = token.start[0]
            whole = token.line.strip().startswith("#")
            if not (whole and line == end + 1):
                yield line, token.string.strip("# ")
            end = line if whole else 0


def find_without_subject(name, text):
    """Returns "line: begin" of the comments of a file that leave out what they speak of."""
    find = find_python_comments if name.endswith(".py") else find_cxx_comments
    return [f"{line}: {words[:50]}" for line, words in find(text) if _NO_SUBJECT.match(words)]


def test_comments_without_subject_are_found():
    text = (
        '// SPDX-License-Identifier: x\n// What a file has.\nint a; // of a run\nf("// as one");\n'
        "/// Returns the rest\n/// of a line.\nint b; ///< as in the file\n"
        "/**\n * Of a run, or a part.\n */\n/// @{\n/// Those of others.\n// Offset of a block\n"
    )
    found = find_without_subject("a.h", text)
    assert [line.split(":")[0] for line in found] == ["1", "3", "7", "8", "11"]
    text = (
        '"""As another."""\n\n\ndef f():\n    """Returns what it has."""\n    return 1  # of two\n'
    )
    found = find_without_subject("a.py", text)
    assert [line.split(":")[0] for line in found] == ["1", "6"]


def test_comments_have_a_subject():
    found = {
        name: find_without_subject(name, (ROOT / name).read_text())
        for name in tracked(".h", ".cxx", ".py")
    }
    assert {name: lines for name, lines in found.items() if lines} == {}


# Names that do not say what a thing is; properties of public classes keep theirs.
_NAMES = re.compile(
    r"\b(?!(?:Set|Get)?Least(?:Share|Amplitude|SpecularShare)(?:M\w\wValue)?\b)"
    r"\w*(?:Least|Most|Fewest)[A-Z]\w*|\b_?(?:MOST|LEAST|FEWEST)_\w+|"
    r"\b(?:LasSheet|OpenNowhere|MarkLine|WriteWords|OnePlane|GetRest|SetStand)\b"
)


def find_names(text):
    """Returns the names in code that the glossary or its table of words replaces."""
    return sorted(set(_NAMES.findall(text)))


def test_names_are_found():
    text = "int MostRays; x.FindLeastHeight(1); SetLeastShare(2); class LasSheet; MOST_CELLS = 3"
    assert find_names(text) == ["FindLeastHeight", "LasSheet", "MOST_CELLS", "MostRays"]


def test_names_are_of_the_glossary():
    here = pathlib.Path(__file__).name
    found = {
        name: find_names((ROOT / name).read_text())
        for name in tracked(".h", ".cxx", ".py")
        if not name.endswith(here)
    }
    assert {name: names for name, names in found.items() if names} == {}
