"""The commands of a course as an instructor types them: words, files, exit codes, every option."""

import argparse
import csv
import io
import json
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import nbformat
import pytest

from helpers.arm import ArmError
from helpers.course import autograders, commands, gradebook, sheets, store
from helpers.course.answers import HandIn
from helpers.course.commands import main
from helpers.course.marking import Mark
from helpers.course.roster import Student
from helpers.course.sandbox import Limits
from helpers.course.store import Course, Rules
from tests.test_course import MINE, SECRET, right

TOPICS = ("forward kinematics", "Jacobian")


@pytest.fixture(autouse=True)
def a_machine_with_another_encoding_of_its_own(monkeypatch):
    """What is read or written without saying UTF-8 goes wrong, as it would on some machines."""
    monkeypatch.setattr(io, "text_encoding", lambda encoding, *_: encoding or "utf-16")


@pytest.fixture
def here(tmp_path, monkeypatch):
    """A folder with a secret, a roster of two and an arm of one's own."""
    monkeypatch.chdir(tmp_path)
    Path("s").write_bytes(SECRET)
    Path("r.csv").write_text("id,name\nab,Ada Ü\ncd,Bo\n", encoding="utf-8-sig")
    Path("arm.py").write_text("from tests.test_course import MINE\n", encoding="utf-8")
    return tmp_path


def typed(line, capsys, code=0):
    """What a command prints: to stdout, or, where it fails, to stderr."""
    assert main(line.split()) == code
    out, err = capsys.readouterr()
    assert not (err, out)[code // 2]
    return (out, err)[code // 2]


NEW = "new --roster r.csv --secret s --arm arm.py:MINE --out hw"


def quick(*students, topics=TOPICS, out="hw", rules=None, title="Homework"):
    return commands.new(
        [Student(s, s.upper()) for s in students], SECRET, MINE, Path(out), title, topics, rules
    )


USAGE = """
new [-h] --roster ROSTER --secret SECRET --arm ARM [--lock JOINT] [--title TITLE] [--topic TOPIC]
 [--digits DIGITS] [--columns COLUMNS] [--cause CAUSE=CREDIT] --out OUT
key [-h] --secret SECRET --id ID [--course COURSE]
grade [-h] --secret SECRET --out OUT [--jobs JOBS] [--seconds SECONDS] [--unprotected] [--as-root]
 [--canvas CANVAS] [--moodle MOODLE] course
gradescope [-h] --secret SECRET --out OUT course
nbgrader [-h] --secret SECRET --id ID --out OUT course
look [-h] folder
classroom [-h] --out OUT
"""


def test_the_commands_take_what_the_instructors_page_says(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "400")
    lines = USAGE.replace("\n ", " ").strip().splitlines()
    for line in lines:
        with pytest.raises(SystemExit, match="0"):
            main([line.split()[0], "--help"])
        told = re.sub(r"\x1b\[[\d;]*m|\n(?= )", "", capsys.readouterr().out).splitlines()[0]
        assert " ".join(told.split()) == f"usage: python -m helpers.course {line}"
    with pytest.raises(SystemExit, match="0"):
        main(["--help"])
    told = capsys.readouterr().out
    assert commands.__doc__ in told
    names = [line.split()[0] for line in lines]
    assert f"{{{','.join(names)}}}" in told
    assert re.findall(r"^    (\w+)  +\w", told, re.M) == names
    book = nbformat.read(Path(__file__).parents[1] / "book/instructors.ipynb", as_version=4)
    page = "\n".join(cell.source for cell in book.cells)
    options = {*re.findall(r"--[a-z-]+", USAGE)} - {"--seconds", "--title", "--topic", "--course"}
    assert {option for option in options if option not in page} == set()
    for wrong in ([], ["mark"], [*NEW.split(), "--topic", "Statics"]):
        with pytest.raises(SystemExit, match="2"):
            main(wrong)


def test_a_course_is_made_with_every_option_and_read_back(here, capsys):
    line = (
        f"{NEW} --lock 1 --lock 3 --digits 0.5 --columns 0.25 --cause J.halves=0.75 --cause a=b=1"
    )
    made = main([*line.split(), "--title", "Homework Ä", "--topic", "Jacobian"])
    assert made == 0
    assert capsys.readouterr() == ("2 sheets in hw\n", "")
    found = store.load(Path("hw"))
    assert found.arm == replace(MINE.lock(3).lock(1), name=f"{MINE.name}, joint 1 and 3 locked")
    assert (found.title, found.topics) == ("Homework Ä", ("Jacobian",))
    assert found.rules == Rules(0.5, 0.25, {"J.halves": 0.75, "a=b": 1.0})
    assert {s: e["name"] for s, e in found.sheets.items()} == {"ab": "Ada Ü", "cd": "Bo"}
    data = json.loads(Path("hw/course.json").read_text("utf-8"))
    assert Path("hw/course.json").read_text("utf-8").startswith('{\n "version": 1,\n "title": "H')
    assert [*data] == ["version", "title", "arm", "topics", "rules", "sheets"]
    assert data["rules"] == {"digits": 0.5, "columns": 0.25, "causes": {"J.halves": 0.75, "a=b": 1}}
    assert sorted(p.name for p in Path("hw").iterdir()) == ["ab", "cd", "course.json"]
    for student in ("ab", "cd"):
        names = sorted(p.name for p in Path("hw", student).iterdir())
        assert names == ["homework.html", "homework.ipynb", "sheet.json"]
        mine = found.sheet(student, SECRET)
        assert mine.parts.keys() == {"J", "xi", "J_column"}
        kept = json.loads(Path("hw", student, "sheet.json").read_text("utf-8"))
        assert kept["drawn"] == mine.drawn
        assert kept["arm"]["values"] == mine.arm.values
        page = Path("hw", student, "homework.html").read_text("utf-8")
        assert f"<p>{found.sheets[student]['name']} ({student})</p>" in page
        assert f"<title>Homework Ä, {student}</title>" in page
        assert "<h1>Homework Ä</h1>" in page
        book = nbformat.read(Path("hw", student, "homework.ipynb"), as_version=4)
        nbformat.validate(book)
        title = f"# Homework Ä\n\n{found.sheets[student]['name']} ({student})\n\n"
        assert book.cells[0].source.startswith(title)
    assert (typed("key --secret s --id cd", capsys)) == found.sheet("cd", SECRET).questions[
        0
    ].key + "\n"


def test_all_that_suits_is_asked_by_default_and_marked_by_the_default_rules(here, capsys):
    assert typed(NEW, capsys) == "2 sheets in hw\n"
    found = store.load(Path("hw"))
    assert (found.title, found.rules, found.arm) == ("Homework", Rules(0.9, 1.0, {}), MINE)
    asked = ("DH table", "forward kinematics", "Jacobian", "inverse kinematics")
    assert found.topics == asked
    answers = json.dumps(right(found.sheet("ab", SECRET)))
    Path("hw/ab/answers.json").write_text(answers, encoding="utf-8")
    said = typed("look hw/ab", capsys)
    assert said.startswith("table: 1\n")
    assert said.count(": 1\n") == len(found.sheet("ab", SECRET).parts) == 7
    said = typed("look hw/cd", capsys)
    assert said.startswith("nothing was answered (answers.json)\ntable: 0\nNot answered.\n\np: 0\n")
    words = "key --secret s --id ab --course hw"
    keys = typed(words, capsys)
    assert keys == "\n\n".join(q.key for q in found.sheet("ab", SECRET).questions) + "\n"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (
            f"{NEW} --cause 0.5",
            "--cause is '0.5'; expected a cause and its credit, such as J.halve",
        ),
        (f"{NEW} --cause a=x", "--cause is 'a=x'; expected"),
        (f"{NEW} --cause a=1.1", "--cause is 'a=1.1'; expected"),
        (f"{NEW} --cause a=-0.1", "--cause is 'a=-0.1'; expected"),
        (f"{NEW} --cause =1", "--cause is '=1'; expected"),
        (NEW.replace("r.csv", "none.csv"), "roster 'none.csv' cannot be read"),
        (NEW.replace(" s ", " none "), "secret file 'none' cannot be read"),
        ("key --secret s --id ../x", "--id is '../x'; expected 1 to 64 letters"),
        (
            "key --secret s --id ab --course none",
            f"{Path('none/course.json')} cannot be read (No such file",
        ),
        ("grade none --secret s --out o", f"{Path('none/course.json')} cannot be read"),
        ("look none", "[Errno 2] No such file or directory"),
        ("gradescope none --secret s --out o", f"{Path('none/course.json')} cannot be read"),
    ],
)
def test_what_goes_wrong_is_told_on_stderr(here, capsys, line, words):
    assert typed(line, capsys, 2).startswith(f"course: {words}")


@pytest.mark.parametrize(("words", "read"), [("a=0", ("a", 0.0)), ("b=c=1", ("b=c", 1.0))])
def test_a_causes_credit_is_0_to_1(words, read):
    assert commands._cause(words) == read


def test_a_roster_grows_and_another_course_goes_elsewhere(here):
    rules = Rules(0.1, 0.2, {"a": 0.3})
    first = quick("ab", rules=rules)
    grown = quick("ab", "cd")
    assert grown.sheets["ab"] == first.sheets["ab"]
    assert grown.rules == rules
    assert store.load(Path("hw")) == grown
    for other in ({"title": "T"}, {"topics": TOPICS[:1]}):
        with pytest.raises(ArmError) as told:
            quick("ab", **other)
        words = f"hw holds the course 'Homework' about {MINE.name}; choose another folder"
        assert str(told.value) == words
    made = commands.new([Student("ab", "AB")], SECRET, MINE, Path("new"), topics=TOPICS[:1])
    assert (made.title, made.rules) == ("Homework", Rules())
    Path("hw/ab/homework.html").unlink()
    quick("ab")
    assert Path("hw/ab/homework.html").exists()


@pytest.mark.parametrize("failures", [0, 1, 19, 20])
def test_a_sheet_that_cannot_be_marked_is_drawn_anew_up_to_twenty_times(
    here, monkeypatch, failures
):
    tried = []

    def prove(sheet):
        tried.append(sheet)
        if len(tried) <= failures:
            raise ArmError(f"hidden {len(tried)}")

    monkeypatch.setattr(commands, "prove", prove)
    monkeypatch.setattr(commands, "_write_sheet", lambda *_: None)
    if failures == 20:
        with pytest.raises(ArmError, match=r"^hidden 20$"):
            quick("ab")
        return
    entry = quick("ab").sheets["ab"]
    course = Course("Homework", MINE, TOPICS, Rules(), {})
    assert entry == store.drawn_sheet(course, "ab", "AB", SECRET, failures)
    assert entry["drawn"] == tried[-1].drawn
    assert len(tried) == failures + 1


def test_what_grade_is_asked_is_what_was_typed(here, monkeypatch, capsys):
    quick("ab", "cd")
    asked = []

    def grade(*given, **how):
        asked.append((given, how))
        rows = [{"id": "ab", "name": "Ada", "total": 1.5, "p": 1, "R": 0.5, "J": 0, "note": ""}]
        return [*rows, {**rows[0], "id": "cd", "name": "Bo", "total": 0.25}]

    monkeypatch.setattr(commands, "grade", grade)
    canvas = "\ufeffStudent,ID,SIS Login ID,Homework (1)\r\nÄ,1,ab,\r\nBo,2,zz,\r\n"
    moodle = (
        "\ufeffIdentifier,Full name,Email address,Grade,Maximum Grade,Last modified (grade)\r\n"
        "1,Bo,,,10,-\r\n2,X,ab@ü,,,-\r\n"
    )
    Path("c.csv").write_text(canvas, encoding="utf-8")
    Path("m.csv").write_text(moodle, encoding="utf-8")
    line = "grade hw --secret s --out o"
    for apart, flags, how in (
        ("nothing", "", ("nothing", 1, 120, False)),
        ("nothing", " --unprotected", ("process", 1, 120, False)),
        ("bubblewrap", " --unprotected --as-root --jobs 3 --seconds 9", ("bubblewrap", 3, 9, True)),
        ("nothing", " --canvas c.csv --moodle m.csv", ("nothing", 1, 120, False)),
    ):
        assert not Path("o/canvas.csv").exists()
        monkeypatch.setattr(commands, "best_apart", lambda apart=apart: apart)
        said = typed(line + flags, capsys)
        assert said == f"2 students marked: {Path('o/grades.csv')}\n"
        apart, jobs, seconds, as_root = how
        limits = Limits(notebook=seconds)
        assert asked.pop() == (
            (Path("hw"), SECRET, Path("o")),
            {"apart": apart, "jobs": jobs, "limits": limits, "as_root": as_root},
        )
    filled = list(csv.reader(Path("o/canvas.csv").read_text("utf-8").splitlines()))
    assert filled == [
        ["Student", "ID", "SIS Login ID", "Homework (1)"], ["Ä", "1", "ab", "1.5"],
        ["Bo", "2", "zz", "0.25"],
    ]  # fmt: skip
    filled = list(csv.reader(Path("o/moodle.csv").read_text("utf-8").splitlines()))
    assert [row[3] for row in filled] == ["Grade", "0.83", "1.50"]
    assert b"\r\r" not in Path("o/moodle.csv").read_bytes()


def marks(**credits):
    return tuple(Mark(name, credit, f"{name} h", f"{name} w") for name, credit in credits.items())


def test_grading_writes_what_it_returns_and_marks_by_the_courses_rules(here, monkeypatch, capsys):
    course = quick("ab", "cd", rules=Rules(digits=0.4), topics=TOPICS[:1])
    read = []

    def read_hand_in(folder, apart, limits, *, as_root):
        read.append((folder, apart, limits, as_root))
        return HandIn({"id": folder.name}, "late" if folder.name == "cd" else "")

    def mark_sheet(sheet, answers, rules):
        assert rules == course.rules
        who = next(s for s in ("ab", "cd") if course.sheet(s, SECRET) == sheet)
        assert answers in ({"id": who}, {})
        return marks(p=1.0 if answers else 0.0, R=0.12345)

    monkeypatch.setattr(commands, "read_hand_in", read_hand_in)
    monkeypatch.setattr(commands, "mark_sheet", mark_sheet)
    monkeypatch.setattr(commands, "best_apart", lambda: "bubblewrap")
    monkeypatch.setattr(commands.sys.stderr, "isatty", lambda: True, raising=False)
    rows = commands.grade(Path("hw"), SECRET, Path("o"))
    assert capsys.readouterr().err.endswith("] 2 of 2 students\n")
    first = {"id": "ab", "name": "AB", "total": 1.1235, "p": 1.0, "R": 0.1235, "note": ""}
    second = {**first, "id": "cd", "name": "CD", "note": "late"}
    assert rows == [first, second]
    assert read == [(Path("hw", s), "bubblewrap", Limits(), False) for s in ("ab", "cd")]
    text = Path("o/grades.csv").read_bytes().decode()
    assert (
        text
        == "id,name,total,p,R,note\r\nab,AB,1.1235,1.0,0.1235,\r\ncd,CD,1.1235,1.0,0.1235,late\r\n"
    )
    results = json.loads(Path("o/cd/results.json").read_text("utf-8"))
    assert Path("o/cd/results.json").read_text("utf-8").startswith('{\n "score": 1.1235,\n "outp')
    assert results == {
        **gradebook.gradescope(marks(p=1.0, R=0.12345), "late"),
        "extra_data": {"fingerprint": results["extra_data"]["fingerprint"], "row": second},
    }
    page = Path("o/cd/feedback.html").read_text("utf-8")
    assert "<h1>Homework: 1.12345 of 2</h1>" in page
    assert "<p>CD (cd)</p>" in page
    assert "<p>Note: late.</p>" in page
    again = commands.grade(Path("hw"), SECRET, Path("o"))
    assert again == rows
    assert len(read) == 2
    for how in ({"apart": "nothing"}, {"limits": Limits(7, 8, 9), "as_root": True}):
        commands.grade(Path("hw"), SECRET, Path("o"), **how)
    assert read[2:] == [
        *((Path("hw", s), "nothing", Limits(), False) for s in ("ab", "cd")),
        *((Path("hw", s), "bubblewrap", Limits(7, 8, 9), True) for s in ("ab", "cd")),
    ]

    def broken(*_, **__):
        raise MemoryError

    monkeypatch.setattr(commands, "read_hand_in", broken)
    rows = commands.grade(Path("hw"), SECRET, Path("p"))
    trouble = "marking stopped (MemoryError); please look at it by hand"
    assert [(row["total"], row["note"]) for row in rows] == [(0.1235, trouble)] * 2
    with pytest.raises(ArmError, match="the secret is another"):
        commands.grade(Path("hw"), b"x" * 16, Path("q"))


def test_several_at_a_time_are_as_many_as_asked(monkeypatch):
    made = []

    class Pool(ThreadPoolExecutor):
        def __init__(self, workers):
            made.append(workers)
            super().__init__(workers)

    monkeypatch.setattr(commands, "ProcessPoolExecutor", Pool)
    monkeypatch.setattr(commands, "_grade_one", lambda task: task + 1)
    assert sorted(commands._done([1, 2, 3], 2)) == [2, 3, 4]
    assert list(commands._done([1, 2, 3], 1)) == [2, 3, 4]
    assert made == [2]


def test_a_mark_is_kept_until_something_that_it_depends_on_changes(here):
    course = quick("ab", "cd")
    job = commands._Job(
        course, "ab", "Ada", SECRET, Path("hw/ab"), Path("o"), "nothing", Limits(), False
    )
    Path("hw/ab/answers.json").write_text("{}", encoding="utf-8")
    before = commands._fingerprint(job)
    assert re.fullmatch("[0-9a-f]{64}", before)
    Path("hw/ab/notes.txt").write_text("of no account", encoding="utf-8")
    Path("hw/ab/link.ipynb").symlink_to(here / "s")
    Path("hw/ab/folder.ipynb").mkdir()
    assert commands._fingerprint(job) == before
    found = {before}
    for change in (
        {"apart": "process"}, {"limits": Limits(1)}, {"student": "cd"},
        {"course": replace(course, rules=Rules(0.1))}, {"folder": Path("hw/cd")},
    ):  # fmt: skip
        found.add(commands._fingerprint(replace(job, **change)))
    for name, text in (("answers.json", '{"p": 1}'), ("homework.ipynb", "x"), ("b.ipynb", "y")):
        Path("hw/ab", name).write_text(text, encoding="utf-8")
        found.add(commands._fingerprint(job))
    Path("hw/ab/b.ipynb").rename("hw/ab/c.ipynb")
    found.add(commands._fingerprint(job))
    assert len(found) == 10


@pytest.mark.skipif(sys.platform != "linux", reason="other disks refuse such a name")
def test_a_name_of_a_file_that_is_no_text_stops_nobody(here):
    quick("ab")
    Path("hw/ab/homework.ipynb").unlink()
    for name in ("\udcfe.ipynb", "\udcff.ipynb"):
        Path("hw/ab", name).write_text("{", encoding="utf-8")
    (row,) = commands.grade(Path("hw"), SECRET, Path("o"), apart="nothing")
    assert row["note"].startswith("there are 2 notebooks (\udcfe.ipynb, \udcff.ipynb)")
    assert r"(\udcfe.ipynb" in Path("o/grades.csv").read_text("utf-8")


def test_an_autograder_and_a_workflow_are_written_where_asked(here, capsys):
    course = quick("ab", "cd")
    out = "gradescope hw --secret s --out a/b/c.zip"
    assert typed(out, capsys) == f"autograder for 2 students: {Path('a/b/c.zip')}\n"
    Path("other").write_bytes(b"z" * 16)
    before = Path("a/b/c.zip").read_bytes()
    said = typed(out.replace(" s ", " other "), capsys, 2)
    assert said.startswith("course: the stored sheet of 'ab' was changed, or the secret is another")
    assert Path("a/b/c.zip").read_bytes() == before
    line = "classroom --out x/.github/homework.yml"
    assert typed(line, capsys) == f"workflow file: {Path('x/.github/homework.yml')}\n"
    assert Path("x/.github/homework.yml").read_text("utf-8") == autograders.CLASSROOM
    line = "nbgrader hw --secret s --id cd --out n/source.ipynb"
    assert typed(line, capsys) == f"source notebook: {Path('n/source.ipynb')}\n"
    book = nbformat.read(Path("n/source.ipynb"), as_version=4)
    nbformat.validate(book)
    expected = autograders.nbgrader_notebook(course, course.sheet("cd", SECRET))
    assert json.loads(Path("n/source.ipynb").read_text("utf-8")) == expected


def test_a_command_runs_what_it_is_named_after():
    found = argparse.ArgumentParser().add_subparsers()
    parser = commands._command(found, "x", len, "say so")
    assert parser.parse_args([]).run is len
    assert parser.description == "say so"
    assert sheets.FILE == "sheet.json"
