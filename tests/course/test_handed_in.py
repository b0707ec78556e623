"""Test how answers are found in hand-ins, including unusual and hostile files."""

import json
import os
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from course.answers import MARKED_LINE, collect_answers, to_json_value, write_last_cell
from course.files import HandedFile, read_files
from course.handed_in import HandIn, compare_sheet_names, find_sheet_name, read_hand_in
from tests.course.parts import make_zip

PARTS = ("p", "R", "q")
ANSWERS = {"sheet": "ab", "p": [1, 2, 3], "q": "0.1, 0.2"}


def make_notebook(*cells):
    """Make a notebook from pairs of a cell's source and what it printed (None: never run)."""
    cells = [
        {
            "cell_type": "code",
            "source": source.splitlines(keepends=True),
            "outputs": [] if text is None else [{"name": "stdout", "text": text}],
        }
        for source, text in cells
    ]
    return json.dumps({"cells": cells, "nbformat": 4})


def make_printed_notebook(answers, source="answer_p = 1"):
    line = f"{MARKED_LINE}{json.dumps(answers)}\n"
    return make_notebook((source, None), (f'print("{MARKED_LINE}" + text)', line))


def make_nested_zip(depth):
    packed = make_zip({"answers.json": json.dumps(ANSWERS)})
    for _ in range(depth):
        packed = make_zip({"a.zip": packed})
    return packed


def make_broken_zip():
    packed = bytearray(make_zip({"answers.json": '{"p": "' + "x" * 500 + '"}'}))
    packed[60:90] = b"\0" * 30
    return bytes(packed)


def make_sparse_file(path):
    with path.open("wb") as file:
        file.truncate(40 * 2**30)


def make_locked_folder(path):
    path.mkdir()
    (path / "answers.json").write_text('{"p": 1}', encoding="utf-8")
    path.chmod(0)


def make_device(path):
    try:
        os.mknod(path, 0o666 | stat.S_IFCHR, os.makedev(1, 5))  # /dev/zero never ends
    except PermissionError:
        os.mkfifo(path)


def make_deep_folder(path):
    for _ in range(60):
        path.mkdir()
        path = path / "d"
    path.write_text("{}", encoding="utf-8")


def make_many_files(path):
    path.mkdir()
    for number in range(600):
        (path / f"{number}.json").write_text("{}", encoding="utf-8")


KEY = json.dumps(ANSWERS)
BOOK = make_printed_notebook(ANSWERS)
BLANK = make_notebook(("answer_sheet = 'ab'\nanswer_p = ...", None))
FOUND = {
    "renamed by a browser": {"answers (1).json": KEY},
    "in capitals": {"ANSWERS.JSON": KEY},
    "with a hidden ending": {"answers.json.txt": KEY},
    "renamed by Canvas": {"lovelaceada_LATE_123_456_answers-1.json": KEY},
    "in a folder": {"homework/final/answers.json": KEY},
    "in a zip's folder": {"All.ZIP": make_zip({"me/homework 1/answers.json": KEY})},
    "with prefixes": {"a.json": json.dumps({f"answer_{k}": x for k, x in ANSWERS.items()})},
    "twice the same": {"answers.json": KEY, "answers (1).json": KEY},
    "with a byte order mark": {"answers.json": KEY.encode("utf-8-sig")},
    "in UTF-16": {"answers.json": KEY.encode("utf-16")},
    "empty beside a right file": {"answers.json": "{}", "answers (2).json": KEY},
    "a saved notebook": {"homework (1).ipynb": BOOK},
    "a notebook beside an empty file": {"answers.json": "{}", "homework.ipynb": BOOK},
    "a notebook beside the same file": {"answers.json": KEY, "homework.ipynb": BOOK},
    "a notebook beside a blank one": {"a.ipynb": BLANK, "homework.ipynb": BOOK},
}
TROUBLE = {
    "two different files": ({"a.json": '{"p": 1}', "b.json": '{"p": 2}'}, "2 different answers f"),
    "two different notebooks": (
        {"a.ipynb": make_printed_notebook({"p": 1}), "b.ipynb": make_printed_notebook({"p": 2})},
        "there are 2 different notebooks (a.ipynb, b.ipynb); hand in one",
    ),
    "a notebook that was never run": (
        {"a.ipynb": make_notebook(("answer_p = 1", None), (f"print({MARKED_LINE!r})", None))},
        "a.ipynb was never run: choose Restart and run all, save it",
    ),
    "a notebook without its last cell": (
        {"a.ipynb": make_notebook(("answer_p = 1", "1\n"))}, "its last cell was not run"
    ),
    "a notebook run before it was answered": (
        {"a.ipynb": make_printed_notebook({"sheet": "ab"})}, "its last cell was not run after"
    ),
    "a marked line of broken JSON": (
        {"a.ipynb": make_notebook(("answer_p = 1", None), (MARKED_LINE, f"{MARKED_LINE}{{"))},
        "its last cell was not run",
    ),
    "a blank sheet": ({"a.ipynb": BLANK}, "nothing was answered"),
    "nothing": ({}, "nothing was handed in"),
    "a table": ({"answers.csv": "p,1\r\n"}, "that can be marked; seen: answers.csv"),
    "a picture in a zip": ({"my.zip": make_zip({"scan.pdf": b"%PDF"})}, "seen: my.zip/scan.pdf"),
    "no JSON": ({"answers.json": '{"p": 1,\n "R": }'}, "answers.json (this is no JSON: line 2"),
    "other names": ({"answers.json": '{"x": 1}'}, "seen: answers.json"),
    "an empty file": ({"answers.json": ""}, "seen: answers.json"),
    "no text": ({"answers.json": b"\xff\xfe\xff"}, "seen: answers.json"),
    "deep lists": ({"answers.json": "[" * 2_000_000}, "seen: answers.json"),
    "a huge file": ({"answers.json": b'{"p": 1}' + b" " * 20_000_000}, "20,000,008 bytes; a file"),
    "a sparse file": ({"answers.json": make_sparse_file}, "42,949,672,960 bytes; a file may"),
    "a locked folder": ({"mine": make_locked_folder}, ""),
    "a device": ({"answers.json": make_device}, "no ordinary file"),
    "a pipe": ({"answers.json": os.mkfifo}, "no ordinary file"),
    "a link to itself": ({"answers.json": lambda p: p.symlink_to(p)}, "no ordinary file"),
    "a link away": ({"answers.json": lambda p: p.symlink_to("/etc/passwd")}, "no ordinary file"),
    "a link to a neighbour": ({"x": lambda p: p.symlink_to("../../zz")}, "no ordinary file"),
    "a folder of that name": ({"answers.json": Path.mkdir}, "nothing was handed in"),
    "a deep folder": ({"d": make_deep_folder}, "seen: d/d/d/"),
    "600 files": ({"many": make_many_files}, "a hand-in may have 200 files"),
    "a zip bomb": ({"bomb.zip": make_zip({f"{n}.json": b" " * 20_000_000 for n in range(3)})},
                   "50,000,000 bytes"),
    "zips in zips": ({"a.zip": make_nested_zip(20)}, "lies too deep"),
    "a broken zip": ({"a.zip": make_broken_zip()}, "a.zip/"),
    "no zip": ({"a.zip": "PK"}, "no zip that can be read"),
    "a zip that climbs": ({"a.zip": make_zip({"../../answers.json": '{"x": 1}'})}, "answers.j"),
    "a name that is no text": ({"\udcff.txt": "x"}, r"seen: \udcff.txt"),
    "no notebook": ({"my.ipynb": "{"}, "seen: my.ipynb"),
    "a notebook of lists": ({"my.ipynb": '{"cells": [[]]}'}, "seen: my.ipynb"),
}  # fmt: skip


def write_files(folder, files):
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if callable(content):
            content(path)
        else:
            path.write_bytes(content if isinstance(content, bytes) else content.encode())


@pytest.mark.parametrize("kind", FOUND)
def test_read_hand_in_finds_answers(kind, tmp_path):
    write_files(tmp_path, FOUND[kind])
    assert read_hand_in(read_files(tmp_path), PARTS) == HandIn(ANSWERS)


@pytest.mark.parametrize("kind", TROUBLE)
def test_unreadable_hand_in_is_reported(kind, tmp_path):
    files, message = TROUBLE[kind]
    write_files(tmp_path, files)
    hand_in = read_hand_in(read_files(tmp_path), PARTS)
    assert not hand_in.answers or kind == "a locked folder"  # root may read it
    assert message in hand_in.trouble
    for path in tmp_path.glob("mine"):
        path.chmod(0o755)


def test_read_hand_in_prefers_file_over_notebook():
    files = [HandedFile("answers.json", b'{"p": 1}'), HandedFile("a.ipynb", BOOK.encode())]
    hand_in = read_hand_in(files, PARTS)
    assert hand_in.answers == {"p": 1}
    assert hand_in.trouble.startswith("a.ipynb printed other answers; those of the answers file")


def test_marked_line_of_another_cell_is_ignored():
    line = f"{MARKED_LINE}{json.dumps({'p': 9})}\n"
    book = make_notebook(("print(9)", line), (f"# {MARKED_LINE}", f"{MARKED_LINE}{KEY}\n"))
    assert read_hand_in([HandedFile("a.ipynb", book.encode())], PARTS).answers == ANSWERS


def test_last_marked_answer_line_is_read():
    text = f'{MARKED_LINE}{{"p": 9}}\n{MARKED_LINE}{KEY}\nmore\n'
    book = make_notebook((MARKED_LINE, text))
    assert read_hand_in([HandedFile("a.ipynb", book.encode())], PARTS).answers == ANSWERS


@pytest.mark.parametrize(
    ("found", "message"),
    [
        (None, ""),
        ("0a1b/ab", ""),
        ("0a1b/cd", "this answers the sheet of 'cd', not of 'ab'"),
        ("ffff/ab", "this answers 'ffff/ab', another sheet of the same student; '0a1b/ab' is"),
        ("0a1b/ab#1", "this answers '0a1b/ab#1', another sheet of the same student"),
        (["x"], "this answers the sheet of"),
    ],
)
def test_answers_to_a_wrong_sheet_are_reported(found, message):
    result = compare_sheet_names(found, "0a1b/ab")
    assert result.startswith(message)
    assert bool(result) == bool(message)


@pytest.mark.parametrize("lines", [False, True])
def test_sheet_name_is_found_in_notebook_and_answers(lines):
    source = "import numpy\nanswer_sheet = 'ab'  # whose"
    source = source.splitlines(keepends=True) if lines else source
    book = {"cells": [{"cell_type": "code", "source": source}]}
    assert find_sheet_name(HandedFile("a.ipynb", json.dumps(book).encode())) == "ab"
    assert find_sheet_name(HandedFile("a.json", KEY.encode())) == "ab"
    assert find_sheet_name(HandedFile("a.json", b"[1]")) == ""


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read all")
def test_file_without_permission_is_reported(tmp_path):
    path = tmp_path / "a.json"
    path.write_text("{}", encoding="utf-8")
    path.chmod(0)
    assert read_files(tmp_path)[0].trouble == "cannot be read: Permission denied"


def test_missing_folder_is_reported(tmp_path):
    (file,) = read_files(tmp_path / "none")
    assert str(file) == "none (cannot be read: No such file or directory)"


TYPED = {
    "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": 2j, "n": np.float64(0.5),
    "m": sp.Matrix([sp.Symbol("q_1")]), "l": [1, (2, np.array([3]))],
    "d": {1: np.int64(2), "x": {"y": 1j}}, "s": sp.Symbol("q_1") + 1, "falsy": 0,
}  # fmt: skip
STORED = {
    "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": "2j", "n": 0.5, "m": [["q_1"]],
    "l": [1, [2, [3]]], "d": {"1": 2, "x": {"y": "1j"}}, "s": "q_1 + 1", "falsy": 0,
}  # fmt: skip


def test_answers_keep_their_values():
    for name, value in TYPED.items():
        assert to_json_value(value) == STORED[name]
    names = {f"answer_{name}": value for name, value in TYPED.items()}
    others = {"answer_none": None, "answer_dots": ..., "my_answer_x": 1, "answer": 2, "t": 3}
    assert collect_answers({**names, **others}) == STORED


def test_last_cell_prints_and_writes_the_same_answers(tmp_path):
    script = tmp_path / "run.py"
    script.write_text(f"answer_p = [1, '0,50', 2j]\n{write_last_cell()}", encoding="utf-8")
    run = subprocess.run([sys.executable, script], cwd=tmp_path, check=True, capture_output=True)
    book = make_notebook((write_last_cell(), run.stdout.decode()))
    expected = HandIn({"p": [1, "0,50", "2j"]})
    assert read_hand_in([HandedFile("a.ipynb", book.encode())], PARTS) == expected
    assert read_hand_in(read_files(tmp_path), PARTS) == expected
