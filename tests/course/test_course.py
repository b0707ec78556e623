"""A course as an instructor types it: made, given out, grown, marked; and what it keeps secret."""

import hashlib
import hmac
import json
import os
import re
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import nbformat
import numpy as np
import pytest

from course import __main__ as commands
from course import arms, grading, making, store
from course.grading import grade, mark_student
from course.making import right_work
from course.marking import Mark
from course.roster import Student, read_roster
from course.sheets import sheet
from helpers.arm import Arm, ArmError, Body, prismatic, revolute
from helpers.robots import ARMS, ELBOW, PANDA

SECRET = "a course secret that is long enough"
ROSTER = (Student("ab12", "Ada"), Student("cd34", "Émile"))
HANGING = PANDA.lock(3)
MINE = Arm(
    "An arm the book does not have",
    (revolute(d="h", alpha="pi/2"), revolute(a="a_2"), prismatic(d=0.1, limits=(0, 0.4))),
    values={"h": 0.3, "a_2": 0.4},
)
POSES = ("forward kinematics",)


# What is given out


@pytest.fixture(scope="module")
def given_out(tmp_path_factory):
    """Two sheets, as an instructor makes them."""
    folder = tmp_path_factory.mktemp("given") / "hw"
    topics = ("forward kinematics", "Jacobian", "static torque")
    return making.new(ROSTER, HANGING, folder, topics=topics, secret=SECRET), folder


def besides(course, folder, student):
    """What a student's notebook holds besides what its questions print and whose it is; a length in
    it is blotted out where it is the arm's."""
    (path,) = (folder / student).iterdir()
    mine, book = course.sheet(student), json.loads(path.read_bytes())
    printed = {question.markdown for question in mine.questions} | {mine.arm._repr_markdown_()}
    centres = (x for body in mine.arm.bodies for x in body.com)
    lengths = {*mine.arm.values.values(), *map(abs, centres)}
    for cell in book["cells"]:
        source = "" if cell["source"] in printed else cell["source"]
        for told in (mine.arm._repr_markdown_(), *(part.what for part in mine.parts.values())):
            source = source.replace(told, "")
        source = source.replace(student, "").replace(course.names[student], "")
        cell["source"] = re.sub(
            r"\d[\d.]*", lambda m: "" if float(m[0]) in lengths else m[0], source
        )
    return book


def test_a_notebook_tells_no_more_of_its_key_than_its_questions(given_out):
    """Else two notebooks would differ elsewhere; and no drawn sheet can be drawn again by those who
    have the source and not the secret."""
    course, folder = given_out
    first, second = course.sheet("ab12"), course.sheet("cd34")
    assert all(first.drawn[topic] != second.drawn[topic] for topic in course.topics)
    assert besides(course, folder, "ab12") == besides(course, folder, "cd34")
    assert course.secret not in (folder / "ab12" / "homework.ipynb").read_text("utf-8")
    for guess in ("ab12", "Ada", course.title, ""):
        other = sheet(HANGING, guess, POSES).drawn
        assert first.drawn[POSES[0]] != other[POSES[0]]


def test_the_notebook_is_valid_and_runs_to_an_answers_file(given_out, tmp_path):
    course, folder = given_out
    book = nbformat.read(folder / "ab12" / "homework.ipynb", as_version=4)
    nbformat.validate(book)
    code = [cell.source for cell in book.cells if cell.cell_type == "code"]
    names = re.findall(r"^answer_(\w+) = \.\.\.$", "\n".join(code), re.M)
    assert names == list(course.sheet("ab12").parts)
    script = tmp_path / "run.py"
    text = "\n".join(code).replace("answer_p = ...", "answer_p = [1, '2', np.pi]")
    script.write_text(f"{text}\nassert arm.dof == 6", encoding="utf-8")
    subprocess.run([sys.executable, script], cwd=tmp_path, check=True)
    written = json.loads((tmp_path / "answers.json").read_text("utf-8"))
    assert written == {"sheet": store.name_sheet(course, "ab12"), "p": [1, "2", np.pi]}


# The commands


@pytest.fixture
def here(tmp_path, monkeypatch):
    """A folder with a secret, a roster of two and an arm of one's own."""
    monkeypatch.chdir(tmp_path)
    Path("s").write_text(SECRET + "\n", encoding="utf-8")
    Path("r.csv").write_text("id,name\nab,Ada Ü\ncd,Bo\n", encoding="utf-8-sig")
    Path("arm.py").write_text("from tests.course.test_course import MINE\n", encoding="utf-8")
    return tmp_path


NEW = "new --roster r.csv --secret s --arm arm.py:MINE --out hw"


def typed(line, capsys, code=0):
    """What a command prints: to stdout, or, where it fails, to stderr."""
    assert commands.main(line.split()) == code
    out, err = capsys.readouterr()
    return err if code else out


def test_a_term_from_roster_to_grades(here, capsys):
    said = typed(f"{NEW} --title Ä --topic Jacobian", capsys)
    assert said == "2 sheets in hw\n"
    course = store.load(Path("hw"))
    assert (course.title, course.topics, course.arm.dof) == ("Ä", ("Jacobian",), 3)
    assert course.secret == SECRET
    assert course.names == {"ab": "Ada Ü", "cd": "Bo"}
    told = dict(line.split(": ", 1) for line in typed("key hw --id cd", capsys).splitlines())
    assert {n: json.loads(x) for n, x in told.items()} == right_work(course.sheet("cd"))
    answers = right_work(course.sheet("ab"))
    answers["J"] = [[*row[:2], 9] for row in answers["J"]]
    Path("hw/ab/answers.json").write_text(json.dumps(answers), encoding="utf-8")
    said = typed("grade hw --out out --jobs 2", capsys)
    assert said == f"2 students marked: {Path('out/grades.csv')}\n"
    lines = Path("out/grades.csv").read_text("utf-8").splitlines()
    assert lines[0] == "id,name,total,J,xi,J_column,note"
    assert lines[1:] == [
        "ab,Ada Ü,2.5,0.5,1.0,1.0,",
        "cd,Bo,0.0,0.0,0.0,0.0,nothing was answered",
    ]
    words = Path("out/ab/feedback.txt").read_text("utf-8")
    assert words.startswith("Ä, Ada Ü (ab): 2.5 of 3\n\nJ: 0.5 of 1 for the Jacobian, ")
    assert "    This is what a usual mistake g" in words
    words = Path("out/cd/feedback.txt").read_text("utf-8")
    assert words.startswith("Ä, Bo (cd): 0 of 3\nNote: nothing was answered.\n\nJ: 0")
    assert typed("gradescope hw --out a/b.zip", capsys).startswith("autograder for 2")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (NEW.replace("r.csv", "none.csv"), "[Errno 2] No such file or directory: 'none.csv'"),
        (NEW.replace(" s ", " none "), "[Errno 2] No such file or directory: 'none'"),
        (NEW.replace(" s ", " short "), "the secret in short is too short; expected 16 letters"),
        (NEW.replace("arm.py:MINE", "Pandabear"), "no arm is called 'Pandabear'; expected one of"),
        ("grade none --out o", "[Errno 2] No such file or directory: 'none/course.json'"),
    ],
)
def test_what_goes_wrong_is_told_on_stderr(here, capsys, line, words):
    Path("short").write_text("123456789012345\n", encoding="utf-8")
    assert typed(line, capsys, 2).startswith(f"course: {words}")
    assert not Path("hw").exists()


# A course that changes


def grown(*students, arm=ELBOW, **how):
    roster = [Student(s, s.upper()) for s in students]
    return making.new(roster, arm, Path("hw"), topics=POSES, **how)


def test_a_course_grows_and_what_is_changed_is_changed_on_purpose(here):
    first = grown("ab")
    given = Path("hw/ab/homework.ipynb").read_text("utf-8")
    second = grown("ab", "cd", secret=first.secret)
    assert second.sheets["ab"] == first.sheets["ab"]
    assert Path("hw/ab/homework.ipynb").read_text("utf-8") == given
    third = grown("cd")
    assert (third.secret, len(third.sheets)) == (first.secret, 2)
    assert store.load(Path("hw")) == third
    assert stat.S_IMODE(Path("hw/course.json").stat().st_mode) == 0o600
    assert Path("hw/.gitignore").read_text("utf-8") == "course.json\n"
    corrected = [Student("ab", "Ada King"), Student("cd", "CD")]
    Path("hw/cd/homework.ipynb").write_text("begun", encoding="utf-8")
    fourth = making.new(corrected, ELBOW, Path("hw"), topics=POSES)
    assert fourth.names["ab"] == "Ada King"
    assert fourth.sheet("ab") == first.sheet("ab")
    assert "Ada King (ab)" in Path("hw/ab/homework.ipynb").read_text("utf-8")
    assert Path("hw/cd/homework.ipynb").read_text("utf-8") == "begun"


@pytest.mark.parametrize("how", [{"title": "T"}, {"arm": MINE}, {"secret": "x" * 16}])
def test_another_course_or_secret_is_refused_and_nothing_is_changed(here, how):
    grown("ab")
    before = Path("hw/course.json").read_bytes()
    with pytest.raises(ArmError, match="there is a course 'Homework' about Elbow arm with the"):
        grown("ab", "cd", **how)
    assert Path("hw/course.json").read_bytes() == before
    assert not Path("hw/cd").exists()


def test_who_has_no_sheet_is_told():
    with pytest.raises(ArmError, match="'zz' is not in this course"):
        store.Course("T", ELBOW, POSES, SECRET, {}).sheet("zz")


@pytest.mark.parametrize("failures", [0, 1, 20])
def test_a_sheet_that_cannot_be_marked_is_drawn_anew(here, monkeypatch, failures):
    tried = []

    def judged(sheet, answers):
        tried.append(sheet)
        return [Mark("p", float(len(tried) > failures), f"wrong {len(tried)}")]

    monkeypatch.setattr(making, "mark_sheet", judged)
    if failures == 20:
        with pytest.raises(
            ArmError, match="`p` cannot be marked: its own key is judged 'wrong 20'"
        ):
            grown("ab")
        return
    assert grown("ab").sheets["ab"]["drawn"] == tried[failures].drawn


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{}", "is no course that `new` made: KeyError('arm')"),
        ("{", "is no course that `new` made: JSONDecodeError("),
        ("[]", "is no course that `new` made: "),
    ],
)
def test_a_course_that_cannot_be_read_is_told(tmp_path, text, words):
    (tmp_path / "course.json").write_text(text, encoding="utf-8")
    with pytest.raises(ArmError, match=re.escape(f"{tmp_path / 'course.json'} {words}")):
        store.load(tmp_path)


# Grading a class


def write_answers(student, answers):
    Path(f"hw/{student}/answers.json").write_text(json.dumps(answers), encoding="utf-8")


def totals(result):
    return [row["total"] for row in result.rows]


def test_grading_again_marks_only_new_hand_ins(here, monkeypatch):
    course = grown("ab", "cd")
    assert totals(grade(Path("hw"), Path("out"), jobs=1)) == [0, 0]
    write_answers("ab", right_work(course.sheet("ab")))
    first = grade(Path("hw"), Path("out"), jobs=2)
    assert totals(first) == [2, 0]
    table = Path("out/grades.csv").read_bytes()
    os.utime("hw/ab/answers.json", (1, 1))
    Path("out/ab/feedback.txt").unlink()
    marked = {s: Path(f"out/{s}/mark.json").stat().st_mtime_ns for s in ("ab", "cd")}
    assert grade(Path("hw"), Path("out"), jobs=1) == first
    assert Path("out/grades.csv").read_bytes() == table
    assert "p: 1 of 1 for" in Path("out/ab/feedback.txt").read_text("utf-8")
    for student, time_of_mark in marked.items():
        assert Path(f"out/{student}/mark.json").stat().st_mtime_ns == time_of_mark


def test_again_says_what_changed(here, capsys):
    course = grown("ab", "cd")
    write_answers("ab", right_work(course.sheet("ab")))
    grade(Path("hw"), Path("out"), jobs=1)
    path = Path("out/ab/mark.json")
    record = json.loads(path.read_bytes())
    record["marks"][0]["credit"] = 0.5  # as an older judge had it
    path.write_text(json.dumps(record), encoding="utf-8")
    assert "is now" not in typed("grade hw --out out --jobs 1", capsys)
    said = typed("grade hw --out out --jobs 1 --again", capsys)
    assert said.startswith("ab, p: 0.5 is now 1. Right.\n2 students marked")
    assert Path("out/changes.csv").read_text("utf-8").splitlines() == [
        "id,part,before,now,why", "ab,p,0.5,1.0,Right."
    ]  # fmt: skip


def test_overrides_last(here):
    course = grown("ab")
    Path("hw/overrides.csv").write_text("id,part,credit,why\nab,p,0.75,on paper\n", "utf-8")
    assert totals(grade(Path("hw"), Path("out"), jobs=1)) == [0.75]
    write_answers("ab", right_work(course.sheet("ab")))
    assert totals(grade(Path("hw"), Path("out"), jobs=1, again=True)) == [1.75]
    feedback = Path("out/ab/feedback.txt").read_text("utf-8")
    assert "p: 0.75 of 1 for the tip's position (m)\n    Set by hand: on paper\n" in feedback


def test_bad_overrides_are_all_told(here):
    grown("ab")
    text = "id;part;credit;why\nzz;p;1;\nab;x;1;\nab;p;2;\nab;p;0,5;\n"
    Path("hw/overrides.csv").write_text(text, "utf-8")
    with pytest.raises(ArmError) as error:
        grade(Path("hw"), Path("out"), jobs=1)
    for line in (2, 3, 4):
        assert f"line {line}: " in str(error.value)
    assert "line 5" not in str(error.value)


def test_hints_tell_no_mark_and_end_after_three_hand_ins(here):
    course = grown("ab")
    key = right_work(course.sheet("ab"))
    for number in range(5):
        write_answers("ab", {**key, "p": [1000 * x + number * 1e-5 for x in key["p"]]})
        grade(Path("hw"), Path("out"), jobs=1, before_deadline=True)
        hints = Path("out/ab/feedback.txt").read_text("utf-8")
        assert ("The position is in millimetres" in hints) == (number < 3)
        assert "of 1" not in hints
        assert "Right" not in hints
    assert "Hints are given for 3 hand-ins" in hints


def test_hand_in_of_another_course_is_not_marked(here):
    course = grown("ab")
    write_answers("ab", {**right_work(course.sheet("ab")), "sheet": "ffffff/ab"})
    (row,) = grade(Path("hw"), Path("out"), jobs=1).rows
    assert (row["total"], row["note"]) == (
        0,
        "this answers a sheet of another course ('ffffff/ab')",
    )


def test_reader_that_breaks_is_reported(here, monkeypatch):
    course = grown("ab")
    monkeypatch.setattr("course.grading.read_hand_in", lambda *_: 1 / 0)
    record = mark_student(Path("hw"), Path("out"), course)
    assert record["note"] == "marking it stopped; please look at it by hand (ZeroDivisionError)"


def test_process_that_ends_costs_its_author_only(here, monkeypatch):
    grown("ab", "cd")
    monkeypatch.setattr(grading, "_START", "fork")
    real = grading.read_hand_in
    monkeypatch.setattr(
        grading,
        "read_hand_in",
        lambda files, parts: os._exit(1) if len(files) > 1 else real(files, parts),
    )
    write_answers("ab", {"p": [1, 2, 3]})
    notes = [row["note"] for row in grade(Path("hw"), Path("out"), jobs=1).rows]
    assert notes == ["marking it stopped; please look at it by hand", "nothing was answered"]


@pytest.mark.skipif(sys.platform == "win32", reason="no signal can be sent")
def test_who_kills_the_grader_leaves_no_worker(here):
    grown(*(f"s{n}" for n in range(8)))
    command = [sys.executable, "-m", "course", "grade", "hw", "--out", "o"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    process = subprocess.Popen([*command, "--jobs", "3"], env=environment, start_new_session=True)
    while not Path("o").exists() and process.poll() is None:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    for _ in range(600):
        left = subprocess.run(["pgrep", "-s", str(process.pid)], capture_output=True).stdout
        if not left:
            return
        time.sleep(0.1)
    pytest.fail("workers stay")


# Its parts


def test_seeds_are_hmacs_of_all_that_they_stand_for():
    course = store.Course("Ü", ELBOW, POSES, SECRET, {})
    mac = hmac.new(SECRET.encode(), b'["\\u00dc", "ab", 3]', hashlib.sha256)
    assert store.seed(course, "ab", 3) == mac.hexdigest()


LIMITED = Arm(
    "An arm with all that an arm may have, Ä",
    (
        revolute("a_1", "pi/2", 0.25, "pi", limits=(-1, 2), speed=3, effort=40),
        prismatic(d="h", limits=(0, np.inf), speed=0.5),
    ),
    values={"a_1": 0.3, "h": 0.4},
    home=(0.5, 0.25),
    source="made up",
).with_bodies([Body(1.5, (0.1, 0, 0.2)), Body(2, (0, 0.3, 0))])


@pytest.mark.parametrize("arm", [*ARMS, HANGING, MINE, LIMITED], ids=lambda arm: arm.name)
def test_an_arm_survives_json(arm):
    data = json.loads(json.dumps(arms.to_json(arm), allow_nan=False))
    back = arms.from_json(data)
    assert back == arm
    assert (back.source, back.home, back.bodies) == (arm.source, arm.home, arm.bodies)
    for wrong in ({k: v for k, v in data.items() if k != "rows"}, {**data, "other": 1}):
        with pytest.raises(ArmError, match=r"the stored arm lacks or mistypes .*(rows|other)"):
            arms.from_json(wrong)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("id,name\n../x,A\n", r"line 2: id is '\.\./x'"),
        ("id,name\nab,A\ncd,C\n Ab ,B\n", "line 4: id 'Ab' stands above already"),
        *(
            (f"id,name\n{student},A\n", r"^roster line 2: id is ")
            for student in ("", "a" * 65, ".a", "a.", "a b", "é", "CON", "con.txt", "Lpt9.a.b")
        ),
        ("student,name\nab,A\n", "has the columns student, name; expected id and name"),
        ("id,name\nab,A\ncd\n", "line 3 has the columns id, name; expected id and name"),
        ("id,name\n", "holds no student"),
        ("id,name\nab,\udcff\n", "is not in UTF-8; save it as CSV UTF-8"),
    ],
)
def test_a_roster_that_cannot_be_used_is_told_by_its_line(tmp_path, text, words):
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(ArmError, match=words):
        read_roster(path)


def test_a_roster_is_read_with_spaces_signs_and_other_columns(tmp_path):
    path = tmp_path / "r.csv"
    text = '\ufeffmail,name,id\r\nx, Ada Ü , xcon.a_b@c-D9 \r\ny,"L,\r\nA",con1\r\n'
    for between in ",;":
        path.write_bytes(text.replace(",", between).encode())
        expected = (Student("xcon.a_b@c-D9", "Ada Ü"), Student("con1", f"L{between}\r\nA"))
        assert read_roster(path) == expected


@pytest.mark.parametrize(
    "text",
    [
        "sep=;\nID;Name\nab;Ada L\n",
        "Username\tFirst name\tLast name\nab\tAda\tL\n\t\t\n",
        "Student,ID,SIS Login ID,Section\n    Points Possible,,,\nAda L,91,ab,1\n",
        " id , Name \n ab , Ada L \n",
    ],
)
def test_roster_is_read_as_platforms_export_it(tmp_path, text):
    path = tmp_path / "r.csv"
    path.write_text(text, encoding="utf-8-sig")
    assert read_roster(path) == (Student("ab", "Ada L"),)


def test_every_bad_line_of_a_roster_is_told(tmp_path):
    path = tmp_path / "r.csv"
    path.write_text("id,name\n../x,A\nab,B\nAB,C\n", encoding="utf-8")
    with pytest.raises(ArmError, match=r"line 2: id is .*; roster line 4: id 'AB' stands above"):
        read_roster(path)
