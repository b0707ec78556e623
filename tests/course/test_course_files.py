"""Hand-ins of every odd and hostile kind: each costs its author only, and is told in words."""

import io
import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import pytest

from course import making, sandbox
from course.answers import as_typed, collected, last_cell
from course.files import Found, within
from course.grading import grade, mark_one
from course.handed_in import HandIn, read_hand_in
from course.making import right_work
from course.roster import Student
from helpers.robots import ELBOW

SECRET = "a course secret that is long enough"
TOPICS = ("forward kinematics", "inverse kinematics")
PARTS = ("p", "R", "q")
REFUSED = sandbox.refusal()


def notebook(*cells):
    cells = [{"cell_type": "code", "metadata": {}, "outputs": [], "source": c} for c in cells]
    return json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 4})


def zipped(**files):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return file.getvalue()


def sparse(path):
    with path.open("wb") as file:
        file.truncate(40 * 2**30)


def closed(path):
    path.write_text('{"p": 1}', encoding="utf-8")
    path.chmod(0)


def locked_folder(path):
    path.mkdir()
    (path / "answers.json").write_text('{"p": 1}', encoding="utf-8")
    path.chmod(0)


def device(path):
    try:
        os.mknod(path, 0o666 | stat.S_IFCHR, os.makedev(1, 5))  # /dev/zero: it never ends
    except PermissionError:
        os.mkfifo(path)


def deep(path):
    for _ in range(60):
        path.mkdir()
        path = path / "d"
    path.write_text("{}", encoding="utf-8")


def many(path):
    path.mkdir()
    for number in range(600):
        (path / f"{number}.json").write_text("{}", encoding="utf-8")


def bomb():
    return zipped(**{f"{n}.json": b" " * 5_000_000 for n in range(30)})


def nested_zips():
    packed = zipped(**{"answers.json": '{"p": 1}'})
    for _ in range(20):
        packed = zipped(**{"a.zip": packed})
    return packed


def broken_zip():
    packed = bytearray(zipped(**{"answers.json": '{"p": "' + "x" * 500 + '"}'}))
    packed[60:90] = b"\0" * 30
    return bytes(packed)


KEY = "the right answers"  # put in by the test
# What is handed in, by the names of files; the marks that it should get (None: all), and words.
ODD = {
    "answers (1).json": ({"answers (1).json": KEY}, None, ""),
    "in capitals": ({"ANSWERS.JSON": KEY}, None, ""),
    "as Canvas renames": ({"lovelaceada_LATE_123_456_answers-1.json": KEY}, None, ""),
    "in a folder": ({"homework/final/answers.json": KEY}, None, ""),
    "in a zip's folder": ({"All.ZIP": {"me/homework 1/answers.json": KEY}}, None, ""),
    "with prefixes": ({"answers.json": "prefixed"}, None, ""),
    "twice the same": ({"answers.json": KEY, "answers (1).json": KEY}, None, ""),
    "with a mark of order": ({"answers.json": "marked"}, None, ""),
    "in UTF-16": ({"answers.json": "wide"}, None, ""),
    "empty beside a right one": ({"answers.json": "{}", "answers (2).json": KEY}, None, ""),
    "a notebook beside {}": ({"answers.json": "{}", "homework (1).ipynb": "book"}, None, ""),
    "two different": ({"a.json": '{"p": 1}', "b.json": '{"p": 2}'}, 0, "2 different answers files"),
    "two notebooks": ({"a.ipynb": notebook("answer_p = 1"), "b.ipynb": notebook("answer_p = 2")}, 0,
                      "there are 2 different notebooks (a.ipynb, b.ipynb); hand in one"),
    "another's": ({"answers.json": "another's"}, 0, "this answers the sheet of 'other', not of"),
    "nothing": ({}, 0, "nothing was answered"),
    "a table": ({"answers.csv": "p,1\r\n"}, 0, "that can be marked; seen: answers.csv"),
    "a picture in a zip": ({"my.zip": {"scan.pdf": b"%PDF"}}, 0, "seen: my.zip/scan.pdf"),
    "no JSON": ({"answers.json": '{"p": 1,\n "R": }'}, 0, "answers.json (this is no JSON: line 2"),
    "other names": ({"answers.json": '{"x": 1}'}, 0, "seen: answers.json"),
    "empty": ({"answers.json": ""}, 0, "seen: answers.json"),
    "no text": ({"answers.json": b"\xff\xfe\xff"}, 0, "seen: answers.json"),
    "deeper lists": ({"answers.json": "[" * 2_000_000}, 0, "seen: answers.json"),
    "deep brackets": ({"answers.json": '{"p": "' + "(" * 1900 + '"}'}, 0, ""),
    "dashes": ({"answers.json": json.dumps(dict.fromkeys(PARTS, "-" * 8000))}, 0, ""),
    "a tower": ({"answers.json": '{"p": "9**9**9**9", "R": "1e999"}'}, 0, ""),
    "a program": ({"answers.json": '{"p": "__import__(\'os\').system(\'touch /tmp/no\')"}'}, 0, ""),
    "NaN": ({"answers.json": '{"p": [NaN, Infinity, -Infinity], "q": [[1e999]]}'}, 0, ""),
    "null": ({"answers.json": '{"p": null, "R": true, "q": [[{}]]}'}, 0, ""),
    "a long number": ({"answers.json": '{"p": ' + "9" * 100_000 + "}"}, 0, ""),
    "a long list": ({"answers.json": json.dumps({"p": [1] * 500_000})}, 0, ""),
    "huge": ({"answers.json": b'{"p": 1}' + b" " * 5_000_001}, 0, "larger than 5,000,000 bytes"),
    "sparse": ({"answers.json": sparse}, 0, "larger than 5,000,000 bytes"),
    "a locked folder": ({"mine": locked_folder}, 0, ""),
    "a device": ({"answers.json": device}, 0, "no ordinary file"),
    "a pipe": ({"answers.json": os.mkfifo}, 0, "no ordinary file"),
    "a link to itself": ({"answers.json": lambda p: p.symlink_to(p)}, 0, "no ordinary file"),
    "a link away": ({"answers.json": lambda p: p.symlink_to("/etc/passwd")}, 0, "no ordinary file"),
    "a link to another's": ({"x": lambda p: p.symlink_to("../../zz")}, 0, "no ordinary file"),
    "a folder of that name": ({"answers.json": Path.mkdir}, 0, "nothing was answered"),
    "folders without end": ({"d": deep}, 0, "seen: d/d/d/"),
    "600 files": ({"many": many}, 0, "more than 200 files"),
    "a bomb": ({"bomb.zip": bomb()}, 0, "50,000,000 bytes"),
    "zips in zips": ({"a.zip": nested_zips()}, 0, "lies too deep"),
    "a broken zip": ({"a.zip": broken_zip()}, 0, "a.zip/"),
    "no zip": ({"a.zip": "PK"}, 0, "no zip that can be read"),
    "a zip that climbs": ({"a.zip": {"../../answers.json": '{"x": 1}'}}, 0, "answers.json"),
    "a name that is no text": ({"\udcff.txt": "x"}, 0, r"seen: \udcff.txt"),
    "a long name": ({"x" * 240 + ".txt": "x"}, 0, "xxx.txt"),
    "a name with a line": ({"a\nb.txt": "x"}, 0, "seen: a"),
    "no notebook": ({"my.ipynb": "{"}, 0, "seen: my.ipynb"),
    "a notebook of lists": ({"my.ipynb": '{"cells": [[]]}'}, 0, "seen: my.ipynb"),
    "a notebook without cells": ({"my.ipynb": '{"cells": []}'}, 0, "my.ipynb answers nothing"),
    "a notebook that fails": (
        {"my.ipynb": notebook("1 / 0")},
        0,
        "the cell `1 / 0` raised ZeroDivisionError: division by zero",
    ),
    "a flood": ({"my.ipynb": notebook("for n in range(1000): print('x' * 10**6)")}, 0, ""),
    "a forged marker": (
        {
            "my.ipynb": notebook(
                "answer_p = answer_R = answer_q = 9\nfrom course import answers, marking\n"
                "marking.mark = lambda sheet, name, _: marking.Mark(name, 1.0, '')\n"
                "answers.collected = lambda _: {'p': [9, 9, 9], 'total': 3}"
            )
        },
        0,
        "",
    ),
    "a forged answer": ({"my.ipynb": notebook("answer_p = type('X', (), {'tolist': 1})()")}, 0, ""),
}  # fmt: skip
RUN = ("notebook", "flood", "forged")
NOT_ROOTS = " or ".join((*RUN, "sandbox", "read", "honestly", "locked", "device"))


def put(folder, files, answers):
    """Lay out what a student hands in. A notebook writes a file, and holds its sources in lines."""
    lines = [f"answer_{name} = {answer!r}\npass" for name, answer in answers.items()]
    book = json.loads(notebook("open('picture.svg', 'w').write('x')", *lines))
    for cell in book["cells"]:
        cell["source"] = cell["source"].splitlines(keepends=True)
    text = json.dumps(answers)
    contents = {
        KEY: text, "marked": text.encode("utf-8-sig"), "wide": text.encode("utf-16"),
        "prefixed": json.dumps({f"answer_{name}": answer for name, answer in answers.items()}),
        "another's": json.dumps({"sheet": "other", "p": [9, 9, 9]}), "book": json.dumps(book),
    }  # fmt: skip
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if callable(content):
            content(path)
            continue
        if isinstance(content, dict):
            content = zipped(**{n: contents.get(c, c) for n, c in content.items()})
        content = contents.get(content, content)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A class of one, whose sheet every odd hand-in answers, and the folder it was given."""
    folder = tmp_path_factory.mktemp("odd") / "hw"
    made = making.new([Student("ab", "Ada")], ELBOW, folder, topics=TOPICS, secret=SECRET)
    return made, folder / "ab"


@pytest.mark.parametrize("kind", ODD)
def test_an_odd_hand_in_is_found_or_told(course, kind, tmp_path):
    if REFUSED and any(word in kind for word in RUN):
        pytest.skip(REFUSED)
    (made, given), (files, total, words) = course, ODD[kind]
    shutil.copytree(given, tmp_path / "ab")
    put(tmp_path / "ab", files, right_work(made.sheet("ab")))
    row = mark_one(tmp_path, tmp_path / "out", 0 if REFUSED else 40, made)
    assert row["total"] == (3 if total is None else total), row
    assert words in row["note"], row["note"]
    if total is None:
        assert row["note"] == ""
    words = (tmp_path / "out" / "ab" / "feedback.txt").read_text("utf-8")
    assert words.startswith("Homework, ")
    assert not Path("/tmp/no").exists()
    for path in (tmp_path / "ab").glob("mine"):
        path.chmod(0o755)


def test_who_works_honestly_loses_nothing_by_the_others(tmp_path):
    """Marked as a class, each in a process of its own."""
    odd = ("deeper lists", "a tower", "a bomb", "a device")
    students = [Student("honest", "Honest"), *(Student(f"s{n}", k) for n, k in enumerate(odd))]
    course = making.new(students, ELBOW, tmp_path / "hw", topics=TOPICS, secret=SECRET)
    for student in students:
        files = ODD.get(student.name, ({"answers.json": KEY},))[0]
        put(tmp_path / "hw" / student.id, files, right_work(course.sheet(student.id)))
    honest, *others = grade(tmp_path / "hw", tmp_path / "out", jobs=2)
    assert honest == {
        "id": "honest", "name": "Honest", "total": 3, "p": 1, "R": 1, "q": 1, "note": ""
    }  # fmt: skip
    assert [row["total"] for row in others] == [0] * len(odd)


def test_a_notebook_that_is_not_run_is_told_with_what_to_do():
    files = [Found("a.ipynb", notebook("answer_p = 1").encode())]
    words = "a.ipynb: notebooks are not run here; hand in answers.json, which its last cell writes"
    assert read_hand_in(files, PARTS) == HandIn({}, words)


@pytest.mark.skipif(os.geteuid() != 0, reason="this is an ordinary user")
def test_what_is_not_done_for_the_superuser_is_right_for_an_ordinary_user():
    """The sandbox, and notebooks among the hand-ins, by the system's Python with our packages."""
    assert "type the command as an ordinary user" in sandbox.refusal()
    python = f"/usr/bin/python{sys.version_info[0]}.{sys.version_info[1]}"
    words = ["setpriv", "--reuid=54321", "--regid=54321", "--clear-groups", python]
    root, folder = Path(__file__).parents[2], Path(tempfile.mkdtemp(dir="/tmp"))
    folder.chmod(0o777)
    environment = {
        "PATH": os.environ["PATH"], "HOME": str(folder), "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONPATH": f"{root}:{Path(pytest.__file__).parents[1]}",
    }  # fmt: skip
    probe = [*words, "-c", "import nbclient, pytest, course"]
    if not Path(python).exists() or subprocess.run(probe, env=environment, cwd="/").returncode:
        pytest.skip(f"an ordinary user has no {python} here that reads the packages")
    tests = [__file__, str(Path(__file__).with_name("test_sandbox.py"))]
    command = [*words, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-k", NOT_ROOTS]
    command += [f"--basetemp={folder / 'pytest'}", *tests]
    done = subprocess.run(command, env=environment, cwd=root, capture_output=True, text=True)
    subprocess.run(["rm", "-rf", folder], check=True)
    assert done.returncode == 0, done.stdout
    assert "notebooks are not run here" not in done.stdout


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read all")
def test_what_may_not_be_read_is_told(tmp_path):
    closed(tmp_path / "a.json")
    assert within(tmp_path)[0].trouble == "cannot be read: Permission denied"


def test_a_folder_that_is_not_there_is_told(tmp_path):
    (found,) = within(tmp_path / "none")
    assert str(found) == "none (cannot be read: No such file or directory)"


def test_answers_are_kept_as_they_were_typed(tmp_path, monkeypatch):
    import numpy as np
    import sympy as sp

    q_1 = sp.Symbol("q_1")
    typed = {
        "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": 2j, "n": np.float64(0.5), "m": sp.Matrix([q_1]),
        "l": [1, (2, np.array([3]))], "d": {1: np.int64(2), "x": {"y": 1j}}, "s": q_1 + 1,
        "falsy": 0,
    }  # fmt: skip
    kept = {
        "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": "2j", "n": 0.5, "m": [["q_1"]],
        "l": [1, [2, [3]]], "d": {"1": 2, "x": {"y": "1j"}}, "s": "q_1 + 1",
        "falsy": 0,
    }  # fmt: skip
    for name, value in typed.items():
        assert as_typed(value) == kept[name]
    names = {f"answer_{name}": value for name, value in typed.items()}
    others = {"answer_none": None, "answer_dots": ..., "my_answer_x": 1, "answer": 2, "t": 3}
    assert collected({**names, **others}) == kept
    monkeypatch.chdir(tmp_path)
    exec(last_cell(), {**names, **others})
    assert json.loads(Path("answers.json").read_text("utf-8")) == kept
