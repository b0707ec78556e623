"""What leaves a course: tables for gradebooks, Gradescope's and nbgrader's files, read back."""

import csv
import io
import json
import tomllib
import zipfile
from dataclasses import replace
from pathlib import Path

import nbformat
import numpy as np
import pytest
import sympy as sp

import helpers
from helpers.arm import ArmError
from helpers.course import autograders, commands, gradebook, store
from helpers.course.marking import Mark
from helpers.course.roster import Student
from tests.test_commands import a_machine_with_another_encoding_of_its_own  # noqa: F401
from tests.test_course import MINE, SECRET, right

MARKS = (
    Mark("p", 1.0, "Right.", "Right."),
    Mark("R", 0.12345678, "Wrong.", "Wrong. All of it.", ("a",)),
    Mark("q_half", 0.9, "Rounded.", "Rounded."),
)


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Two students, two topics, the folders they were given."""
    folder = tmp_path_factory.mktemp("exports") / "hw"
    students = [Student("Ada@x.example", "Ada L"), Student("b.7", "Bo Ü")]
    topics = ("forward kinematics", "Jacobian")
    return commands.new(students, SECRET, MINE, folder, "Homework 1", topics)


def read(text):
    return list(csv.reader(io.StringIO(text, newline="")))


def test_a_line_of_the_grades_rounds_and_adds():
    row = gradebook.grade_row("ab", "Ada", MARKS, "late")
    assert [*row.items()] == [
        ("id", "ab"), ("name", "Ada"), ("total", 2.0235), ("p", 1.0), ("R", 0.1235),
        ("q_half", 0.9), ("note", "late"),
    ]  # fmt: skip
    text = gradebook.table([row, {**row, "name": "=1", "note": "-"}])
    assert text.count("\r\n") == text.count("\n") == 3
    assert read(text) == [
        ["id", "name", "total", "p", "R", "q_half", "note"],
        ["ab", "Ada", "2.0235", "1.0", "0.1235", "0.9", "late"],
        ["ab", "'=1", "2.0235", "1.0", "0.1235", "0.9", "'-"],
    ]


@pytest.mark.parametrize("first", ["=", "+", "-", "@", "\t", "\r", "\n", "|", "%"])
def test_what_a_spreadsheet_would_run_is_quoted(first):
    assert gradebook.safe(f"{first}1") == f"'{first}1"
    assert gradebook.safe(f"a{first}1") == f"a{first}1"


def test_gradescope_reads_a_score_a_test_each_and_words():
    def test(name, number, score, status, output):
        return {
            "name": name, "number": number, "score": score, "max_score": 1.0, "status": status,
            "output": output, "output_format": "text", "visibility": "visible",
        }  # fmt: skip

    expected = {
        "score": 2.0235,
        "output": "Every part is judged below.",
        "output_format": "text",
        "tests": [
            test("p", "1", 1.0, "passed", "Right."),
            test("R", "2", 0.1235, "failed", "Wrong. All of it."),
            test("q_half", "3", 0.9, "failed", "Rounded."),
        ],
    }
    assert gradebook.gradescope(MARKS, "") == expected
    assert gradebook.gradescope(MARKS, "late") == {**expected, "output": "late"}


@pytest.mark.parametrize("text", ["{", "[1]", b"\xff", None])
def test_results_that_cannot_be_read_are_none(tmp_path, text):
    if text is not None:
        (tmp_path / "results.json").write_bytes(text.encode() if isinstance(text, str) else text)
    assert gradebook.read_results(tmp_path) == {}


def test_results_are_written_whole_and_read_back(tmp_path):
    gradebook.write_results(tmp_path / "a" / "b", {"é": [1.5, None]})
    assert gradebook.read_results(tmp_path / "a" / "b") == {"é": [1.5, None]}
    with pytest.raises(ValueError, match="JSON compliant"):
        gradebook.write_results(tmp_path / "a" / "b", {"score": float("nan")})
    assert gradebook.read_results(tmp_path / "a" / "b") == {"é": [1.5, None]}
    assert [path.name for path in (tmp_path / "a" / "b").iterdir()] == ["results.json"]


CANVAS = "Student,ID,SIS User ID,SIS Login ID,Homework 1 (7),Homework 10 (8),Homework 1b (9)"


@pytest.mark.parametrize(
    ("line", "filled"),
    [
        ("Ada L,1,x,ab,,,", "Ada L,1,x,ab,0.333333,,"),
        ("Ada L,1,cd,zz,,,", "Ada L,1,cd,zz,2,,"),
        ("Bo,1,x,y,9,,", "Bo,1,x,y,3,,"),
        ("Bo,1,ab,cd,9,,", "Bo,1,ab,cd,2,,"),
        ("Nobody,ab,x,y,9,8,7", "Nobody,ab,x,y,9,8,7"),
        ("Bo,1", "Bo,1,,,3,,"),
    ],
)
def test_canvas_is_filled_by_login_then_user_then_name(line, filled):
    totals = {"ab": 1 / 3, "cd": 2.0, "Bo": 3.0}
    text = gradebook.fill_canvas(f"\ufeff{CANVAS}\r\n{line}\r\n", totals, "Homework 1")
    assert text == f"{CANVAS}\r\n{filled}\r\n"


def test_a_short_line_of_canvas_matches_nobody():
    text = "Student,ID,Homework 1,SIS Login ID\r\nNo,1\r\nAda,2,\r\n"
    found = gradebook.fill_canvas(text, {"Ada": 0.5, "": 9}, "Homework 1")
    assert read(found)[1:] == [["No", "1"], ["Ada", "2", "0.5", ""]]


MOODLE = "Identifier,Full name,Email address,Grade,Maximum Grade,Last modified (grade)"


@pytest.mark.parametrize(
    ("line", "filled"),
    [
        ("1,Ada,ab@x,,20.00,-", "1,Ada,ab@x,2.50,20.00,-"),
        ("1,Ada,cd@x.y,,20.00,-", "1,Ada,cd@x.y,20.00,20.00,-"),
        ("1,Bo,zz@x,,10,-", "1,Bo,zz@x,7.50,10,-"),
        ("1,Bo,,,,-", "1,Bo,,6.00,,-"),
        ("1,Bo", "1,Bo,,6.00,,"),
        ("1,Nobody,x@y,5,20.00,-", "1,Nobody,x@y,5,20.00,-"),
        ("1,Nobody", "1,Nobody"),
    ],
)
def test_moodle_is_filled_by_mail_then_its_first_half_then_name(line, filled):
    totals = {"ab": 1.0, "cd@x.y": 8.0, "cd": 1.0, "Bo": 6.0}
    text = gradebook.fill_moodle(f"\ufeff{MOODLE}\r\n{line}\r\n", totals, 8.0)
    assert text == f"{MOODLE}\r\n{filled}\r\n"
    nameless = MOODLE.replace("Full name", "Name").replace("Email", "E-mail")
    text = f"{nameless}\r\n{line}\r\n"
    assert gradebook.fill_moodle(text, {**totals, "XXXX": 1.0}, 8.0) == text


@pytest.mark.parametrize(
    ("fill", "export", "words"),
    [
        ("canvas", "", "the export is empty; expected a line of headings"),
        ("moodle", "", "the export is empty; expected a line of headings"),
        ("canvas", "Name,ID", "the Canvas export has the columns Name, ID; expected Student"),
        ("canvas", "Student,A", "the Canvas export has the columns Student, A; expected ID"),
        ("canvas", "Student,ID,T (1),T (2)", "the Canvas export has 2 columns called 'T'; expected"
         " one; it has Student, ID, T (1), T (2)"),
        *(("moodle", MOODLE.replace(name, "X"), f"the Moodle worksheet has the columns "
           f"{MOODLE.replace(name, 'X').replace(',', ', ')}; expected {name} (the importer wants"
           " the language of the site to be English)")
          for name in ("Identifier", "Maximum Grade", "Last modified (grade)")),
        ("moodle", MOODLE.replace(",Grade", ",X"), "the Moodle worksheet has the columns Identifi"
         "er, Full name, Email address, X, Maximum Grade, Last modified (grade); expected Grade"
         " (the importer wants the language of the site to be English)"),
    ],
)  # fmt: skip
def test_an_export_that_lacks_a_column_is_told(fill, export, words):
    with pytest.raises(ArmError) as told:
        getattr(gradebook, f"fill_{fill}")(export, {}, "T")
    assert str(told.value) == words


def test_the_zip_holds_the_course_the_helpers_and_no_secret(course, tmp_path):
    (tmp_path / "a").mkdir()
    for path in (tmp_path / "a/x.zip", tmp_path / "b/c/x.zip"):
        autograders.gradescope_zip(course, path)
    package = Path(helpers.__file__).parent
    sources = {
        f"package/helpers/{p.relative_to(package).as_posix()}": p
        for p in package.rglob("*")
        if p.is_file() and "__pycache__" not in p.parts
    }
    with zipfile.ZipFile(tmp_path / "b/c/x.zip") as file:
        ours = ["setup.sh", "run_autograder", "course.json", "package/pyproject.toml"]
        assert file.namelist() == [*ours, *sorted(sources)] or (
            file.namelist()[:4] == ours and {*file.namelist()[4:]} == {*sources}
        )
        assert [file.getinfo(n).external_attr >> 16 for n in ours] == [0o100755] * 2 + [
            0o100644
        ] * 2
        assert {info.compress_type for info in file.infolist()} == {zipfile.ZIP_DEFLATED}
        for name in ("package/helpers/arm.py", "package/helpers/course/commands.py"):
            assert file.read(name) == sources[name].read_bytes()
        assert file.read("course.json").decode() == store.text(course)
        project = tomllib.loads(file.read("package/pyproject.toml").decode())
        assert "course" in project["project"]["optional-dependencies"]
        assert file.read("setup.sh").startswith(b"#!/usr/bin/env bash\n")


def handed_in(course, root, student, users, answers=None):
    """A folder laid out like /autograder, with this student's right answers."""
    store.save(course, root / "source")
    (root / "submission").mkdir(parents=True)
    found = right(course.sheet(student, SECRET)) if answers is None else answers
    text = json.dumps(found)
    (root / "submission" / "answers.json").write_text(text, encoding="utf-8")
    if users is not None:
        text = json.dumps({"users": users})
        (root / "submission_metadata.json").write_text(text, encoding="utf-8")
    found = autograders.run_gradescope(root)
    assert json.loads((root / "results" / "results.json").read_text("utf-8")) == found
    return found


NOBODY = "No sheet of this course belongs to your name, e-mail address or id; tell your instructor."


@pytest.mark.parametrize(
    ("users", "student"),
    [
        ([{"email": "ada@X.example"}], "Ada@x.example"),
        ([{"email": "B.7@school.example", "name": "?"}], "b.7"),
        ([{"email": "", "name": "bo ü"}], "b.7"),
        ([{}, {"name": "ada l"}], "Ada@x.example"),
        ([{"email": "x.b.7", "name": "ada"}], None),
        ([], None),
        ([{}], None),
        (None, None),
        ({"a": 1}, "Marking stopped (AttributeError); please tell your instructor."),
        (5, None),
    ],
)
def test_gradescope_finds_the_sheet_by_mail_or_name(course, tmp_path, users, student):
    found = handed_in(course, tmp_path, "b.7", users)
    if student is None or student.startswith("Marking"):
        assert found == {"score": 0, "output": student or NOBODY, "tests": []}
        return
    assert found["output"] == f"Marked as the sheet of {student}. Every part is judged below."
    assert found["output_format"] == "text"
    assert [test["name"] for test in found["tests"]] == ["p", "R", "J", "xi", "J_column"]
    assert (found["score"] == 5) == (student == "b.7")


def test_gradescope_marks_by_the_courses_rules_and_says_what_went_wrong(course, tmp_path):
    ruled = replace(course, rules=store.Rules(causes={"numbers.millimetres": 0.625}))
    p = (1000 * course.sheet("b.7", SECRET).parts["p"].value).tolist()
    users = [{"email": "b.7"}]
    found = handed_in(ruled, tmp_path / "a", "b.7", users, {"p": p})
    assert [test["score"] for test in found["tests"]] == [0.625, 0, 0, 0, 0]
    found = handed_in(ruled, tmp_path / "b", "b.7", users, [])
    assert found["score"] == 0
    said = "Marked as the sheet of b.7. answers.json could not be read: holds no names"
    assert found["output"] == said
    (tmp_path / "c").mkdir()
    found = autograders.run_gradescope(tmp_path / "c")
    words = "Marking stopped (ArmError); please tell your instructor."
    assert found == {"score": 0, "output": words, "tests": []}
    assert gradebook.read_results(tmp_path / "c" / "results") == found


def about(cell):
    return cell["metadata"].get("nbgrader")


def test_an_nbgrader_notebook_has_a_solution_and_a_hidden_test_for_each_part(course):
    sheet = course.sheet("b.7", SECRET)
    book = autograders.nbgrader_notebook(course, sheet)
    nbformat.validate(book)
    parts = ["p", "R", "J", "xi", "J_column"]
    dashed = [name.replace("_", "-") for name in parts]
    pairs = [[f"answer-{name}", f"test-{name}"] for name in dashed]
    ids = ["title", "arm", "setup", "question-1", *pairs[0], *pairs[1], "question-2"]
    assert [cell["id"] for cell in book["cells"]] == [*ids, *pairs[2], *pairs[3], *pairs[4]]
    assert book["cells"][0]["source"].startswith("# Homework 1\n\nOne sheet for everybody (all)\n")
    kinds = {"setup": (False, False, True), "answer": (False, True, False)}
    kinds["test"] = (True, False, True)
    for cell in book["cells"]:
        kind = cell["id"].split("-")[0]
        if kind in ("title", "arm", "question"):
            assert about(cell) is None
            continue
        grade, solution, locked = kinds[kind]
        expected = {
            "grade": grade, "solution": solution, "locked": locked, "task": False,
            "schema_version": 3, "grade_id": cell["id"], **({"points": 1} if grade else {}),
        }  # fmt: skip
        assert about(cell) == expected
        assert cell["cell_type"] == "code"
        assert (cell["outputs"], cell["execution_count"]) == ([], None)
    by_id = {cell["id"]: cell["source"] for cell in book["cells"]}
    for name, dash in zip(parts, dashed, strict=True):
        assert by_id[f"answer-{dash}"].splitlines() == [
            f"# answer_{name}: {sheet.parts[name].what}",
            "### BEGIN SOLUTION",
            f"answer_{name} = None",
            "### END SOLUTION",
        ]
        lines = by_id[f"test-{dash}"].splitlines()
        assert lines[0] == "### BEGIN HIDDEN TESTS"
        assert lines[-1] == "### END HIDDEN TESTS"
        space = {f"answer_{name}": right(sheet)[name]}
        exec("\n".join(lines[1:-2]), space)
        assert eval(lines[-2], space) == 1


def test_nbgrader_takes_what_a_sheet_takes(course):
    sheet = course.sheet("b.7", SECRET)
    kept = {"arm": store.arms.to_json(sheet.arm), "drawn": sheet.drawn}
    p, six = sheet.parts["p"].value, sheet.parts["J_column"].value
    for name, answer, credit in (
        ("p", p, 1), ("p", p.tolist(), 1), ("p", tuple(p), 1), ("p", sp.Matrix(p), 1),
        ("p", None, 0), ("p", ..., 0), ("p", np.add(p, [0.002, 0, 0]), 0), ("p", object(), 0),
        ("J_column", sp.Matrix([sp.sympify(f) for f in six]), 1),
        ("J", sheet.parts["J"].value.round(1), 0.9),
    ):  # fmt: skip
        assert autograders.credit(name, answer, kept) == credit, (name, answer)
    thirds = sheet.parts["J"].value.copy()
    thirds[0] += 0.5
    assert autograders.credit("J", thirds, kept) == 0


def test_looking_says_every_part_in_words(course, tmp_path):
    sheet = course.sheet("b.7", SECRET)
    kept = {"arm": store.arms.to_json(sheet.arm), "drawn": sheet.drawn}
    (tmp_path / "sheet.json").write_text(json.dumps(kept), encoding="utf-8")
    answers = {"p": np.round(sheet.parts["p"].value, 4).tolist(), "R": "É"}
    (tmp_path / "answers.json").write_text(
        json.dumps(answers, ensure_ascii=False), encoding="utf-8"
    )
    words, marks = autograders.look(tmp_path)
    assert [mark.part for mark in marks] == ["p", "R", "J", "xi", "J_column"]
    assert words == "\n".join(
        ["p: 1", "Right.", "", "R: 0", marks[1].words, "",
         *(line for n in ("J", "xi", "J_column") for line in (f"{n}: 0", "Not answered.", ""))]
    )  # fmt: skip
    (tmp_path / "answers.json").unlink()
    assert autograders.look(tmp_path)[0].startswith("nothing was handed in (answers.json)\np: 0\n")
    cells = [{"cell_type": "code", "source": "answer_p = 1"}]
    (tmp_path / "a.ipynb").write_text(json.dumps({"cells": cells}), encoding="utf-8")
    unasked = "it has no answers.json, and notebooks are not run without leave"
    assert autograders.look(tmp_path)[0].startswith(f"{unasked} (answers.json)\np: 0\n")
    (tmp_path / "source").mkdir()
    store.save(course, tmp_path / "source")
    (tmp_path / "submission").mkdir()
    (tmp_path / "a.ipynb").rename(tmp_path / "submission/a.ipynb")
    about = json.dumps({"users": [{"email": "b.7"}]})
    (tmp_path / "submission_metadata.json").write_text(about, encoding="utf-8")
    said = autograders.run_gradescope(tmp_path)["output"]
    assert said == f"Marked as the sheet of b.7. {unasked}"
