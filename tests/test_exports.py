"""What comes from learning platforms and goes to them: downloads, tables, packs."""

import csv
import io
import json
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import nbformat
import numpy as np
import pytest
import yaml

from helpers.arm import ArmError
from helpers.course import autograders, collect, commands, gradebook, making, store
from helpers.course.files import Found
from helpers.course.gradebook import CANVAS, MOODLE, filled
from helpers.course.marking import Mark, Rules
from helpers.course.roster import Student
from helpers.robots import ELBOW
from tests.test_course import SECRET, right

FIRST = ["Ada", "Émile", "Jean-Luc", "Zoë", "Mary", "Chika", "José", "Wei", "Nguyễn", "Søren",
         "Björn", "O'Neil"]  # fmt: skip
LAST = ["Lovelace", "Dupont", "Picard", "Łukasz", "Jones", "Okafor", "García", "Zhang", "Văn",
        "Øst", "Müller", "van"]  # fmt: skip
CLASS = {f"s{n:03}": f"{FIRST[n % 12]} {LAST[n // 10]}" for n in range(118)}
CLASS |= {"twin1": "Ada Twin", "twin2": "Ada Twin"}


def answers(student):
    return json.dumps({"sheet": student, "p": [1, 2, len(student)]})


def as_canvas(student, name, n):
    *first, last = name.split()
    short = "".join(c for c in f"{last}{''.join(first)}".lower() if c.isalnum())
    late = "_LATE" * (n % 3 == 0)
    return {f"{short}{late}_{1000 + n}_{90000 + n}_answers-{n % 4}.json": answers(student)}


def as_moodle(student, name, n):
    folder = f"{name.replace(chr(39), '')}_{70000 + n}_assignsubmission_file" + "_" * (n % 2)
    return {f"{folder}/my homework/Answers.JSON": answers(student)}


def as_moodle_flat(student, name, n):
    return {f"{name}_{70000 + n}_assignsubmission_file_answers.json": answers(student)}


def as_gradescope(student, name, n):
    return {f"assignment_5_export/submission_{3000 + n}/answers (1).json": answers(student)}


def by_hand(student, name, n):
    return {f"{student if n % 2 else student.upper()}/answers.json": answers(student)}


def about_gradescope():
    entries = {
        f"submission_{3000 + n}": {
            ":submitters": [{":name": name, ":sid": student if n % 2 else None,
                             ":email": f"{student}@school.example"}],
            ":status": "processed",
        }
        for n, (student, name) in enumerate(CLASS.items())
    }  # fmt: skip
    return {"assignment_5_export/submission_metadata.yml": yaml.safe_dump(entries)}


@pytest.mark.parametrize("folder", [False, True], ids=["zip", "folder"])
@pytest.mark.parametrize("platform", [as_canvas, as_moodle, as_moodle_flat, as_gradescope, by_hand])
def test_a_class_of_120_is_sorted_whatever_the_platform_called_it(tmp_path, platform, folder):
    files = about_gradescope() if platform is as_gradescope else {}
    for n, (student, name) in enumerate(CLASS.items()):
        files |= platform(student, name, n)
    files |= {"__MACOSX/._x": "noise", ".DS_Store": "noise"}
    download = tmp_path / "download"
    with zipfile.ZipFile(f"{download}.zip", "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    if folder:
        with zipfile.ZipFile(f"{download}.zip") as archive:
            archive.extractall(download)
    found = collect.sort(
        collect.read_download(download if folder else Path(f"{download}.zip")), CLASS
    )
    assert found.doubtful == ()
    assert found.placed.keys() == CLASS.keys()
    collect.put(found, tmp_path / "hw")
    collect.put(found, tmp_path / "hw")  # again, in place of the first
    for student in CLASS:
        (path,) = (tmp_path / "hw" / student / "handed_in").iterdir()
        assert json.loads(path.read_bytes())["sheet"] == student


def sort(**files):
    names = {"ab": "Ada Twin", "cd": "Ada Twin", "ef": "Bo Berg", "gh": "Li Na"}
    found = collect.sort([Found(n, c.encode()) for n, c in files.items()], names)
    return {s: [f.name for f in group] for s, group in found.placed.items()}, found.doubtful


def test_what_is_not_certain_is_listed_and_not_placed():
    placed, doubtful = sort(**{
        "twinada_1_2_answers.json": "{}",
        "twinada_3_4_answers.json": answers("cd"),
        "bergbo_5_6_answers.json": answers("gh"),  # another's sheet, in Bo's own name
        "nobody_7_8_homework.pdf": "%PDF",
        "anon_x_9_answers.json": answers("gh"),
        "Participant_11_assignsubmission_file_x.json": "{}",
    })  # fmt: skip
    assert placed == {
        "cd": ["twinada_3_4_answers.json"], "ef": ["bergbo_5_6_answers.json"],
        "gh": ["anon_x_9_answers.json"],
    }  # fmt: skip
    assert [words.split(":")[0] for words in doubtful] == [
        "twinada_1_2_answers.json", "nobody_7_8_homework.pdf",
        "Participant_11_assignsubmission_file_x.json",
    ]  # fmt: skip
    assert "twinada may be ab or cd; the sheet in it does not tell" in doubtful[0]


def test_the_sheet_speaks_from_a_notebook_too():
    text = json.dumps({"cells": [{"source": "answer_sheet = 'ab'  # whose"}]})
    assert sort(**{"anon_x_9_homework.ipynb": text})[0] == {"ab": ["anon_x_9_homework.ipynb"]}


def test_collecting_is_told_on_one_screen(tmp_path, capsys):
    roster = [Student("ab", "Ada Lovelace"), Student("cd", "Bo Berg")]
    made = making.new(roster, SECRET, ELBOW, tmp_path / "hw", topics=("forward kinematics",))
    download = tmp_path / "d"
    (download / "x").mkdir(parents=True)
    key = json.dumps(right(made.sheet("ab", SECRET)))
    (download / "lovelaceada_1_2_answers-1.json").write_text(key, encoding="utf-8")
    (download / "x" / "scan.pdf").write_bytes(b"%PDF")
    assert commands.main(["collect", str(tmp_path / "hw"), str(download)]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0] == "1 of 2 students handed in"
    assert said[1].startswith("not placed: x/scan.pdf: x is nobody in the course")
    (tmp_path / "s").write_bytes(SECRET)
    words = ["grade", str(tmp_path / "hw"), "--secret", str(tmp_path / "s")]
    assert commands.main([*words, "--out", str(tmp_path / "out")]) == 0
    assert "ab,Ada Lovelace,2.0,1.0,1.0," in (tmp_path / "out" / "grades.csv").read_text("utf-8")
    assert commands.main(["collect", str(tmp_path / "hw"), str(tmp_path / "none.zip")]) == 2
    assert "none.zip cannot be read" in capsys.readouterr().err


# Gradebooks

MARKS = (
    Mark("p", 1.0, "Right.", "Right."), Mark("R", 0.12345678, "Wrong.", "Wrong. All.", ("a",)),
    Mark("q", 0.9, "Rounded.", "Rounded."),
)  # fmt: skip
NAMES = {"ab": "Ada Lovelace", "cd": "Bo Berg"}
SHARES = {"ab": 0.65, "cd": 1.0}


def read(text, comma=","):
    return list(csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline=""), delimiter=comma))


def test_a_line_of_the_grades_rounds_adds_and_runs_no_formula():
    row = gradebook.grade_row("ab", "Ada", MARKS, "late")
    text = gradebook.table([row, {**row, "name": "=1", "note": "-"}])
    assert text.count("\r\n") == text.count("\n") == 3
    assert read(text) == [
        ["id", "name", "total", "p", "R", "q", "note"],
        ["ab", "Ada", "2.0235", "1.0", "0.1235", "0.9", "late"],
        ["ab", "'=1", "2.0235", "1.0", "0.1235", "0.9", "'-"],
    ]
    for first in "=+-@\t\r\n|%":
        assert read(gradebook.table([{"name": f"{first}1"}]))[1] == [f"'{first}1"]


HEAD = "Student,ID,SIS User ID,SIS Login ID,Section,Homework (77),Other (78)\r\n"
TOP = f'{HEAD}"    Points Possible",,,,,10,5\r\n'
MOODLE_HEAD = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified (grade)\r\n"
)


@pytest.mark.parametrize(
    ("export", "text", "points"),
    [
        (CANVAS, TOP + '"Lovelace, Ada",1,x,ab,A,,3\r\n"Berg, Bo",2,y,CD,A,4,\r\n',
         ["6.50", "10.00"]),
        (CANVAS, TOP + '"Lovelace, Ada",1,,,A\r\n"Berg, Bo",2,,,A,4,\r\n', ["6.50", "10.00"]),
        (CANVAS, "\ufeff" + TOP + '"Student, Test",9,,,A,,\r\nBo,2,cd,,A,,\r\n', ["10.00"]),
        (CANVAS, HEAD + " Points Possible,,,,,100,5\r\n,,,,,Manual Posting,\r\nA,1,,ab@x.y,A,,\r\n",
         ["65.00"]),
        (CANVAS, TOP.replace(",", ";").replace(";10;", ";20,0;") + "A;1;;ab;S;;\r\n", ["13,00"]),
        (MOODLE, MOODLE_HEAD + "Participant 1,A,ab@x,,,20.00,-\r\nP 2,B,cd@x,,,20.00,-\r\n",
         ["13.00", "20.00"]),
        (MOODLE, MOODLE_HEAD + 'Participant 1,A,ab@x,,,"100,00",-\r\n', ["65,00"]),
        (MOODLE, MOODLE_HEAD + "Participant 1,Ada LOVELACE,,,,20.00,-\r\n", ["13.00"]),
    ],
)  # fmt: skip
def test_an_export_is_filled_where_every_row_is_certain(export, text, points):
    comma = ";" if text.count(";") > text.count(",") else ","
    before, after = read(text, comma), read(filled(text, export, SHARES, NAMES, "Homework"), comma)
    column = 5 if export is CANVAS else 4
    students = [
        row for row in after[1:] if row[0].strip() not in ("", "Points Possible", "Student, Test")
    ]
    assert [row[column] for row in students] == points
    for old, new in zip(before, after, strict=True):
        old += [""] * (len(new) - len(old))
        assert old[:column] + old[column + 1 :] == new[:column] + new[column + 1 :]
    assert text.startswith("\ufeff") == filled(text, export, SHARES, NAMES, "Homework").startswith(
        "\ufeff"
    )


@pytest.mark.parametrize(
    ("export", "text", "words"),
    [
        (CANVAS, TOP + "Ada Twin,1,,,A,,\r\n", "Ada Twin: ab or cd"),
        (CANVAS, TOP + "A,1,,ab,A,,\r\nAda Twin,2,,zz,A,,\r\n", "Ada Twin: nobody in the course"),
        (CANVAS, TOP + "A,1,,ab@x,A,,\r\nB,2,,ab@y,A,,\r\n", "A: ab\nB: ab"),
        (CANVAS, TOP + "A,1,cd,ab,A,,\r\n", "A: ab or cd"),
        (CANVAS, TOP, "it has no rows"),
        (CANVAS, HEAD + "A,1,,ab,A,,\r\n", "the export's maximum is ''; expected a number"),
        (CANVAS, TOP.replace("10", "(read only)") + "A,1,,ab,A,,\r\n", "is '(read only)'"),
        (CANVAS, TOP.replace("Homework", "X") + "A,1,,ab,A,,\r\n", "0 columns called 'Homework'"),
        (CANVAS, "Name,Grade\r\n", "expected Student, ID"),
        (CANVAS, "", "expected Student, ID"),
        (MOODLE, "Kennung,Grade\r\n", "expected Identifier, Full name, Maximum Grade, Last"),
        (MOODLE, MOODLE_HEAD + "P 1,A,ab@x,,,-,-\r\n", "the export's maximum is '-'"),
    ],
)  # fmt: skip
def test_an_export_with_a_doubt_is_not_filled_and_the_doubt_is_told(export, text, words):
    names = {"ab": "Ada Twin", "cd": "Ada Twin"}
    with pytest.raises(ArmError) as told:
        filled(text, export, SHARES, names, "Homework")
    assert words in str(told.value)


def test_grades_are_filled_into_exports_from_the_command_line(course, tmp_path, capsys):
    (tmp_path / "s").write_bytes(SECRET)
    (tmp_path / "c.csv").write_text(TOP + "A,1,,Ada@x.example,A,,\r\nB,2,,b.7,A,,\r\n", "utf-8")
    (tmp_path / "m.csv").write_text(f"{MOODLE_HEAD}P 1,Zoe,zz@x,,,20.00,-\r\n", "utf-8")
    words = ["grade", str(course[1]), "--secret", str(tmp_path / "s"), "--out", str(tmp_path / "o")]
    assert commands.main([*words, "--canvas", str(tmp_path / "c.csv")]) == 0
    assert f"filled: {tmp_path / 'o' / 'canvas.csv'}" in capsys.readouterr().out
    assert commands.main([*words, "--moodle", str(tmp_path / "m.csv")]) == 2
    assert "not certain are:\nZoe: nobody" in capsys.readouterr().err
    assert not (tmp_path / "o" / "moodle.csv").exists()


# Other systems


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Two students, two topics, the folders they were given."""
    folder = tmp_path_factory.mktemp("exports") / "hw"
    students = [Student("Ada@x.example", "Ada L"), Student("b.7", "Bo Ü")]
    topics = ("forward kinematics", "Jacobian")
    return making.new(students, SECRET, ELBOW, folder, topics=topics), folder


@pytest.fixture(scope="module")
def unpacked(course, tmp_path_factory):
    """Gradescope's folder with the wheel installed, as setup.sh does but for what it needs."""
    root = tmp_path_factory.mktemp("autograder")
    autograders.gradescope_zip(course[0], root / "a.zip")
    with zipfile.ZipFile(root / "a.zip") as file:
        file.extractall(root / "source")
        modes = {i.filename: i.external_attr >> 16 & 0o777 for i in file.infolist()}
    (wheel,) = (root / "source").glob("*.whl")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index"]
    pip += ["--disable-pip-version-check", "--target", str(root / "env"), str(wheel)]
    subprocess.run(pip, check=True)
    return root, modes


def test_the_zip_holds_the_course_a_wheel_and_no_secret(unpacked):
    root, modes = unpacked
    assert modes["setup.sh"] == modes["run_autograder"] == 0o755
    assert {*modes} > {"setup.sh", "run_autograder", "course.json"}
    assert SECRET not in (root / "a.zip").read_bytes()
    (info,) = (root / "env").glob("*.dist-info")
    needs = (info / "METADATA").read_text("utf-8")
    assert "Requires-Dist: numpy" in needs
    assert 'extra == "course"' in needs
    source = Path(autograders.__file__).parents[1]
    for path in source.rglob("*"):
        if path.is_file() and "__pycache__" not in path.parts:
            packed = root / "env" / "helpers" / path.relative_to(source)
            assert packed.read_bytes() == path.read_bytes()
    for script in ("setup.sh", "run_autograder"):
        text = (root / "source" / script).read_bytes()
        assert subprocess.run(["bash", "-n"], input=text, check=False).returncode == 0


def handed_in(root, users, given):
    folder = root / "submission"
    folder.mkdir(exist_ok=True)
    (folder / "answers (1).json").write_text(json.dumps(given), encoding="utf-8")
    about = json.dumps({"users": users})
    (root / "submission_metadata.json").write_text(about, encoding="utf-8")


def test_gradescope_marks_by_the_installed_wheel(course, unpacked):
    root, _ = unpacked
    given = right(course[0].sheet("b.7", SECRET))
    handed_in(root, [{"email": "B.7@school.example", "name": "B", "id": 9}], given)
    command = [sys.executable, "-m", "helpers.course.autograders", str(root)]
    subprocess.run(command, cwd=root, env={"PYTHONPATH": str(root / "env")}, check=True)
    results = json.loads((root / "results" / "results.json").read_text("utf-8"))
    assert results["score"] == len(results["tests"]) == 5
    assert results["output"] == "Marked as the sheet of b.7. Every part is judged below."
    assert set(results["tests"][0]) == {
        "name", "number", "score", "max_score", "status", "output", "output_format", "visibility",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("users", "words"),
    [
        ([{"email": "ada@X.example"}], "Marked as the sheet of Ada@x.example."),
        ([{"email": "x@y", "name": "bo ü"}], "Marked as the sheet of b.7."),
        ([{"email": "x@y", "name": "Nobody"}], "No sheet of this course belongs to your name"),
        ([{"email": "ada@x.example"}, {"email": "b.7@z"}], "More than one sheet of this course"),
        ([{}], "No sheet of this course"),
        (None, "Marking stopped (TypeError); please tell your instructor."),
    ],
)
def test_gradescope_finds_whose_sheet_it_is_or_says_so(course, unpacked, users, words):
    root, _ = unpacked
    handed_in(root, users, {"p": [1, 2, 3]})
    results = autograders.run_gradescope(root)
    assert results["output"].startswith(words)
    assert results["score"] == 0
    assert json.loads((root / "results" / "results.json").read_bytes()) == results


def test_an_nbgrader_notebook_has_a_solution_and_a_hidden_test_for_each_part(course):
    sheet = course[0].sheet("b.7", SECRET)
    book = autograders.nbgrader_notebook(course[0], sheet)
    nbformat.validate(nbformat.from_dict(book))
    names = {"answer_" + name: value for name, value in right(sheet).items()}
    cells = [cell for cell in book["cells"] if "nbgrader" in cell["metadata"]]
    both = [f"{kind}-{n.replace('_', '-')}" for n in sheet.parts for kind in ("answer", "test")]
    assert [cell["id"] for cell in cells] == ["setup", *both]
    for answer, test in zip(cells[1::2], cells[2::2], strict=True):
        about = answer["metadata"]["nbgrader"]
        assert (about["solution"], about["grade"], about["locked"]) == (True, False, False)
        _, begin, stub, end = answer["source"].splitlines()
        assert (begin, end) == ("### BEGIN SOLUTION", "### END SOLUTION")
        assert stub.endswith(" = None")
        about = test["metadata"]["nbgrader"]
        assert (about["grade"], about["locked"], about["points"]) == (True, True, 1)
        begin, *lines, last, end = test["source"].splitlines()
        assert (begin, end) == ("### BEGIN HIDDEN TESTS", "### END HIDDEN TESTS")
        space = dict(names)
        exec("\n".join(lines), space)
        assert eval(last, space) == 1
    assert autograders.credit("p", np.zeros(3), space["stored"]) == 0


def test_a_named_mistake_is_worth_what_the_course_says_in_gradescope_too(course, unpacked):
    root, _ = unpacked
    ruled = replace(course[0], rules=Rules(causes={"numbers.millimetres": 0.625}))
    store.save(ruled, root / "source")
    p = (1000 * course[0].sheet("b.7", SECRET).parts["p"].value).tolist()
    handed_in(root, [{"email": "b.7"}], {"p": p})
    assert autograders.run_gradescope(root)["score"] == 0.625
