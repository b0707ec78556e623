"""Test the commands for a course: make it, hand out sheets, add students, mark hand-ins."""

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
from course import grading, making, processes, store
from course.collect import collect_hand_ins
from course.grading import grade_hand_ins, mark_student
from course.making import make_right_answers
from course.marking import Mark, mark_sheet
from course.roster import Student, read_roster
from course.sheets import Exercise, draw_sheet
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


# Sheets


@pytest.fixture(scope="module")
def two_sheets(tmp_path_factory):
    """Make a course of two students and two arms; return it with its folder."""
    folder = tmp_path_factory.mktemp("two_sheets") / "hw"
    topics = ("forward kinematics", "Jacobian", "static torque")
    exercises = [Exercise(HANGING, topics), Exercise(ELBOW, POSES)]
    return making.make_course(ROSTER, exercises, folder, secret=SECRET), folder


def strip_questions(course, folder, student):
    """Return a notebook without its questions, its student and the arm's lengths."""
    (path,) = (folder / student).iterdir()
    own, book = course.sheet(student), json.loads(path.read_bytes())
    tables = [section.arm._repr_markdown_() for section in own.sections]
    printed = {question.markdown for question in own.questions} | {*tables}
    own_arms = [section.arm for section in own.sections]
    centres = (x for arm in own_arms for body in arm.bodies for x in body.com)
    lengths = {*(x for arm in own_arms for x in arm.values.values()), *map(abs, centres)}
    for cell in book["cells"]:
        source = "" if cell["source"] in printed else cell["source"]
        for text in (*tables, *(part.description for part in own.parts.values())):
            source = source.replace(text, "")
        source = source.replace(store.name_sheet(course, student), "")
        source = source.replace(student, "").replace(course.names[student], "")
        cell["source"] = re.sub(
            r"\d[\d.]*", lambda m: "" if float(m[0]) in lengths else m[0], source
        )
    return book


def test_notebooks_differ_in_questions_only(two_sheets):
    course, folder = two_sheets
    first, second = course.sheet("ab12"), course.sheet("cd34")
    for mine, other in zip(first.sections, second.sections, strict=True):
        assert all(mine.drawn[topic] != other.drawn[topic] for topic in mine.drawn)
    assert strip_questions(course, folder, "ab12") == strip_questions(course, folder, "cd34")
    assert course.secret not in (folder / "ab12" / "homework.ipynb").read_text("utf-8")


def test_sheet_depends_on_the_secret(two_sheets):
    course, _ = two_sheets
    first = course.sheet("ab12")
    for guess in ("ab12", "Ada", course.title, ""):
        (other,) = draw_sheet(HANGING, guess, POSES).sections
        assert first.sections[0].drawn[POSES[0]] != other.drawn[POSES[0]]


def test_notebook_runs_to_answers_file(two_sheets, tmp_path):
    course, folder = two_sheets
    book = nbformat.read(folder / "ab12" / "homework.ipynb", as_version=4)
    nbformat.validate(book)
    code = [cell.source for cell in book.cells if cell.cell_type == "code"]
    names = re.findall(r"^answer_(\w+) = \.\.\.$", "\n".join(code), re.M)
    assert names == list(course.sheet("ab12").parts)
    script = tmp_path / "run.py"
    text = "\n".join(code).replace("answer_p = ...", "answer_p = [1, '2', np.pi]")
    script.write_text(f"{text}\nassert arm.dof + arm_2.dof == 9", encoding="utf-8")
    subprocess.run([sys.executable, script], cwd=tmp_path, check=True)
    written = json.loads((tmp_path / "answers.json").read_text("utf-8"))
    assert written == {"sheet": store.name_sheet(course, "ab12"), "p": [1, "2", np.pi]}


# Commands


@pytest.fixture
def here(tmp_path, monkeypatch):
    """Change to a folder with a secret, a roster of two students and an arm."""
    monkeypatch.chdir(tmp_path)
    Path("s").write_text(SECRET + "\n", encoding="utf-8")
    Path("r.csv").write_text("id,name\nab,Ada Ü\ncd,Bo\n", encoding="utf-8-sig")
    Path("arm.py").write_text("from tests.course.test_course import MINE\n", encoding="utf-8")
    return tmp_path


NEW = "new --roster r.csv --secret s --arm arm.py:MINE --out hw"


def run_command(line, capsys, code=0):
    """Run a command; return what it prints to stdout, or to stderr if it fails."""
    assert commands.main(line.split()) == code
    out, err = capsys.readouterr()
    return err if code else out


def test_commands_make_grades_from_roster(here, capsys):
    output = run_command(f"{NEW} --title Ä --topic Jacobian", capsys)
    assert output == "2 sheets in hw\n"
    course = store.load_course(Path("hw"))
    (exercise,) = course.exercises
    assert (course.title, exercise.topics, exercise.arm.dof) == ("Ä", ("Jacobian",), 3)
    assert course.secret == SECRET
    assert course.names == {"ab": "Ada Ü", "cd": "Bo"}
    key = dict(line.split(": ", 1) for line in run_command("key hw --id cd", capsys).splitlines())
    assert {n: json.loads(x) for n, x in key.items()} == make_right_answers(course.sheet("cd"))
    answers = make_right_answers(course.sheet("ab"))
    answers["J"] = [[*row[:2], 9] for row in answers["J"]]
    Path("hw/ab/answers.json").write_text(json.dumps(answers), encoding="utf-8")
    output = run_command("grade hw --out out --jobs 2", capsys)
    assert output == f"2 students marked: {Path('out/grades.csv')}\n"
    lines = Path("out/grades.csv").read_text("utf-8").splitlines()
    assert lines[0] == "id,name,total,J,xi,J_column,late,note"
    assert lines[1:] == [
        "ab,Ada Ü,2.5,0.5,1.0,1.0,,",
        "cd,Bo,0.0,0.0,0.0,0.0,,nothing was answered",
    ]
    text = Path("out/ab/feedback.txt").read_text("utf-8")
    assert text.startswith("Ä, Ada Ü (ab): 2.5 of 3\n\nJ: 0.5 of 1 for the Jacobian, ")
    assert "    This is what a usual mistake g" in text
    text = Path("out/cd/feedback.txt").read_text("utf-8")
    assert text.startswith("Ä, Bo (cd): 0 of 3\nNote: nothing was answered.\n\nJ: 0")
    assert run_command("gradescope hw --out a/b.zip", capsys).startswith("autograder for 2")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (NEW.replace("r.csv", "none.csv"), "[Errno 2] No such file or directory: 'none.csv'"),
        (NEW.replace(" s ", " none "), "[Errno 2] No such file or directory: 'none'"),
        (NEW.replace(" s ", " short "), "the secret in short is too short; expected 16 letters"),
        (NEW.replace("arm.py:MINE", "Pandabear"), "no arm is called 'Pandabear'; expected one of"),
        ("grade none --out o", "[Errno 2] No such file or directory: 'none/course.json'"),
    ],
)
def test_command_that_fails_reports_on_stderr(here, capsys, line, message):
    Path("short").write_text("123456789012345\n", encoding="utf-8")
    assert run_command(line, capsys, 2).startswith(f"course: {message}")
    assert not Path("hw").exists()


# Changes of a course


def make_course(*students, arm=ELBOW, **options):
    roster = [Student(s, s.upper()) for s in students]
    return making.make_course(roster, [Exercise(arm, POSES)], Path("hw"), **options)


def test_course_grows_and_keeps_sheets(here):
    first = make_course("ab")
    notebook = Path("hw/ab/homework.ipynb").read_text("utf-8")
    second = make_course("ab", "cd", secret=first.secret)
    assert second.sheets["ab"] == first.sheets["ab"]
    assert Path("hw/ab/homework.ipynb").read_text("utf-8") == notebook
    third = make_course("cd")
    assert (third.secret, len(third.sheets)) == (first.secret, 2)
    assert store.load_course(Path("hw")) == third
    assert stat.S_IMODE(Path("hw/course.json").stat().st_mode) == 0o600
    assert Path("hw/.gitignore").read_text("utf-8") == "course.json\n"
    corrected = [Student("ab", "Ada King"), Student("cd", "CD")]
    begun = Path("hw/cd/homework.ipynb").read_text("utf-8").replace("Write 0 for", "Write zero for")
    Path("hw/cd/homework.ipynb").write_text(begun, encoding="utf-8")
    fourth = making.make_course(corrected, third.exercises, Path("hw"))
    assert fourth.names["ab"] == "Ada King"
    assert fourth.sheet("ab") == first.sheet("ab")
    assert "Ada King (ab)" in Path("hw/ab/homework.ipynb").read_text("utf-8")
    assert Path("hw/cd/homework.ipynb").read_text("utf-8") == begun


@pytest.mark.parametrize("change", [{"title": "T"}, {"arm": MINE}, {"secret": "x" * 16}])
def test_another_course_in_folder_is_refused(here, change):
    make_course("ab")
    before = Path("hw/course.json").read_bytes()
    with pytest.raises(ArmError, match="there is a course 'Homework' about Elbow arm with forward"):
        make_course("ab", "cd", **change)
    assert Path("hw/course.json").read_bytes() == before
    assert not Path("hw/cd").exists()


def test_unknown_student_is_refused():
    with pytest.raises(ArmError, match="'zz' is not in this course"):
        store.Course("T", (), SECRET, {}).sheet("zz")


@pytest.mark.parametrize("failures", [0, 1, 20])
def test_sheet_whose_right_answers_fail_is_drawn_again(here, monkeypatch, failures):
    drawn = []

    def mark(sheet, answers):
        drawn.append(sheet)
        return [Mark("p", float(len(drawn) > failures), f"wrong {len(drawn)}")]

    monkeypatch.setattr(making, "mark_sheet", mark)
    if failures == 20:
        with pytest.raises(
            ArmError, match="`p` cannot be marked: its own key is judged 'wrong 20'"
        ):
            make_course("ab")
        return
    (section,) = make_course("ab").sheets["ab"]["sections"]
    assert section["drawn"] == drawn[failures].sections[0].drawn


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{}", "is no course that `new` made: KeyError('exercises')"),
        ("{", "is no course that `new` made: JSONDecodeError("),
        ("[]", "is no course that `new` made: "),
    ],
)
def test_broken_course_file_is_reported(tmp_path, text, message):
    (tmp_path / "course.json").write_text(text, encoding="utf-8")
    with pytest.raises(ArmError, match=re.escape(f"{tmp_path / 'course.json'} {message}")):
        store.load_course(tmp_path)


@pytest.mark.parametrize(
    ("weights", "message"),
    [
        ({"x": 1}, "there is no part 'x'; expected numbers, 0 or more, for some of p, R"),
        ({"p": -1, "R": "2"}, "p is -1; R is '2'; expected"),
        ({"p": True}, "p is True"),
    ],
)
def test_bad_weights_are_reported(here, weights, message):
    make_course("ab")
    data = json.loads(Path("hw/course.json").read_bytes())
    Path("hw/course.json").write_text(json.dumps({**data, "weights": weights}), "utf-8")
    with pytest.raises(ArmError, match=re.escape(message)):
        store.load_course(Path("hw"))


def test_weights_change_the_total_and_are_kept(here):
    make_course("ab")
    data = json.loads(Path("hw/course.json").read_bytes())
    Path("hw/course.json").write_text(json.dumps({**data, "weights": {"p": 2.5}}), "utf-8")
    course = make_course("ab", "cd")
    write_answers("ab", make_right_answers(course.sheet("ab")))
    assert list_totals(grade_hand_ins(Path("hw"), Path("out"), jobs=1)) == [3.5, 0]


def test_dropped_student_leaves_other_sheets_unchanged(here, capsys):
    course = make_course("ab", "cd", "ef")
    assert run_command("drop hw --id cd", capsys) == "2 sheets are left\n"
    left = store.load_course(Path("hw"))
    assert left.sheets == {s: course.sheets[s] for s in ("ab", "ef")}
    assert Path("hw/cd/homework.ipynb").exists()
    assert make_course("cd", secret=course.secret).sheets["cd"] == course.sheets["cd"]


def test_reissued_sheet_has_new_numbers(here, capsys):
    old = make_course("ab", "cd")
    notebook = Path("hw/ab/homework.ipynb").read_bytes()
    write_answers(
        "ab", {**make_right_answers(old.sheet("ab")), "sheet": store.name_sheet(old, "ab")}
    )
    assert run_command("reissue hw --id ab", capsys).endswith("/ab#1\n")
    new = store.load_course(Path("hw"))
    assert new.sheets["cd"] == old.sheets["cd"]
    assert new.sheets["ab"]["sections"] != old.sheets["ab"]["sections"]
    assert Path("hw/ab/.0 homework.ipynb").read_bytes() == notebook
    assert "/ab#1" in Path("hw/ab/homework.ipynb").read_text("utf-8")
    (row, _) = grade_hand_ins(Path("hw"), Path("out"), jobs=1).rows
    assert row["total"] == 0
    assert "another sheet of the same student" in row["note"]


@pytest.mark.parametrize("command", ["drop", "reissue", "key"])
def test_command_refuses_unknown_student(here, capsys, command):
    make_course("ab")
    assert "'zz' is not in this course" in run_command(f"{command} hw --id zz", capsys, 2)


def test_interrupted_course_is_completed(here, monkeypatch):
    """The command is stopped after two of six sheets and then repeated."""
    students = [f"s{n}" for n in range(6)]

    def stop(line):
        if line.startswith("2 of 6"):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make_course(*students, jobs=2, report=stop)
    part = store.load_course(Path("hw"))
    assert list(part.sheets) == students[:2]
    whole = make_course(*students, jobs=2)
    assert list(whole.sheets) == students
    assert {s: whole.sheets[s] for s in students[:2]} == part.sheets
    assert all(Path(f"hw/{s}/homework.ipynb").exists() for s in students)


def test_each_of_two_arms_has_its_own_parts(two_sheets):
    course, _ = two_sheets
    own = course.sheet("ab12")
    assert list(own.parts) == ["p", "R", "J", "xi", "J_column", "g", "tau", "p_2", "R_2"]
    right = make_right_answers(own)
    assert all(mark.credit == 1 for mark in mark_sheet(own, right))
    crossed = {**right, "p": right["p_2"], "p_2": right["p"]}
    wrong = [mark.part for mark in mark_sheet(own, crossed) if mark.credit < 1]
    assert wrong == ["p", "p_2"]


def test_topic_before_its_arm_is_refused(here, capsys):
    with pytest.raises(SystemExit):
        commands.main(["new", "--roster", "r.csv", "--out", "hw", "--topic", "Jacobian"])
    assert "stands before --arm" in capsys.readouterr().err


# Grading a class


def write_answers(student, answers):
    Path(f"hw/{student}/answers.json").write_text(json.dumps(answers), encoding="utf-8")


def list_totals(result):
    return [row["total"] for row in result.rows]


def test_grading_again_marks_only_new_hand_ins(here, monkeypatch):
    course = make_course("ab", "cd")
    assert list_totals(grade_hand_ins(Path("hw"), Path("out"), jobs=1)) == [0, 0]
    write_answers("ab", make_right_answers(course.sheet("ab")))
    first = grade_hand_ins(Path("hw"), Path("out"), jobs=2)
    assert list_totals(first) == [2, 0]
    table = Path("out/grades.csv").read_bytes()
    os.utime("hw/ab/answers.json", (1, 1))
    Path("out/ab/feedback.txt").unlink()
    marked = {s: Path(f"out/{s}/mark.json").stat().st_mtime_ns for s in ("ab", "cd")}
    assert grade_hand_ins(Path("hw"), Path("out"), jobs=1) == first
    assert Path("out/grades.csv").read_bytes() == table
    assert "p: 1 of 1 for" in Path("out/ab/feedback.txt").read_text("utf-8")
    for student, time_of_mark in marked.items():
        assert Path(f"out/{student}/mark.json").stat().st_mtime_ns == time_of_mark


def test_grading_again_reports_changes(here, capsys):
    course = make_course("ab", "cd")
    write_answers("ab", make_right_answers(course.sheet("ab")))
    grade_hand_ins(Path("hw"), Path("out"), jobs=1)
    path = Path("out/ab/mark.json")
    record = json.loads(path.read_bytes())
    record["marks"][0]["credit"] = 0.5  # as an older judge may have stored
    path.write_text(json.dumps(record), encoding="utf-8")
    assert "is now" not in run_command("grade hw --out out --jobs 1", capsys)
    output = run_command("grade hw --out out --jobs 1 --again", capsys)
    assert output.startswith("ab, p: 0.5 is now 1. Right.\n2 students marked")
    assert Path("out/changes.csv").read_text("utf-8").splitlines() == [
        "id,part,before,now,why", "ab,p,0.5,1.0,Right."
    ]  # fmt: skip


def test_marks_by_hand_survive_regrading(here):
    course = make_course("ab")
    Path("hw/marks.csv").write_text("id,part,points,remark\nab,p,0.75,on paper\n", "utf-8")
    assert list_totals(grade_hand_ins(Path("hw"), Path("out"), jobs=1)) == [0.75]
    write_answers("ab", make_right_answers(course.sheet("ab")))
    assert list_totals(grade_hand_ins(Path("hw"), Path("out"), jobs=1, again=True)) == [1.75]
    feedback = Path("out/ab/feedback.txt").read_text("utf-8")
    assert "p: 0.75 of 1 for the tip's position (m)\n    Marked by hand: on paper\n" in feedback


def test_bad_marks_by_hand_are_all_reported(here):
    make_course("ab")
    text = "id;part;points;remark\nzz;p;1;\nab;x;1;\nab;p;2;\nab;p;0,5;\n"
    Path("hw/marks.csv").write_text(text, "utf-8")
    with pytest.raises(ArmError) as error:
        grade_hand_ins(Path("hw"), Path("out"), jobs=1)
    for line in (2, 3, 4):
        assert f"line {line}: " in str(error.value)
    assert "line 5" not in str(error.value)


def test_exports_have_the_columns_of_the_platforms(here):
    make_course("ab", "cd")
    Path("hw/marks.csv").write_text("id,part,points,remark\nab,p,0.75,\n", "utf-8")
    grade_hand_ins(Path("hw"), Path("out"), jobs=1)
    assert Path("out/grades-canvas.csv").read_text("utf-8").splitlines() == [
        "Student,ID,SIS User ID,SIS Login ID,Section,Homework",
        "    Points Possible,,,,,2.0",
        "AB,,,ab,,0.75",
        "CD,,,cd,,0.0",
    ]
    assert Path("out/grades-moodle.csv").read_text("utf-8").splitlines() == [
        "Username,Homework", "ab,0.75", "cd,0.0"
    ]  # fmt: skip
    names = [student.id for student in read_roster(Path("out/grades-canvas.csv"))]
    assert names == ["ab", "cd"]


def list_late(result):
    return [row["late"] for row in result.rows]


def test_late_column_follows_canvas_and_late_csv(here):
    course = make_course("ab", "cd", "ef")
    Path("d").mkdir()
    Path("d/ab_LATE_1_2_answers.json").write_text("{}", "utf-8")
    Path("d/cd_LATE_3_4_answers.json").write_text("{}", "utf-8")
    Path("d/ef_5_6_answers.json").write_text("{}", "utf-8")
    collect_hand_ins(Path("d"), course.names, Path("hw"))
    assert list_late(grade_hand_ins(Path("hw"), Path("out"), jobs=1)) == ["late", "late", ""]
    Path("hw/late.csv").write_text("id;late\ncd;\nef;two days\n", "utf-8")
    assert list_late(grade_hand_ins(Path("hw"), Path("out"), jobs=1)) == ["late", "", "two days"]
    Path("d/ab_LATE_1_2_answers.json").rename("d/ab_1_7_answers.json")
    collect_hand_ins(Path("d"), course.names, Path("hw"))
    assert list_late(grade_hand_ins(Path("hw"), Path("out"), jobs=1))[0] == ""


def test_stats_count_parts_and_mistakes(here, capsys):
    course = make_course("ab", "cd", "ef")
    keys = {student: make_right_answers(course.sheet(student)) for student in ("ab", "cd")}
    write_answers("ab", keys["ab"])
    write_answers("cd", {**keys["cd"], "p": [1000 * x for x in keys["cd"]["p"]], "R": "1 2 3"})
    grade_hand_ins(Path("hw"), Path("out"), jobs=1)
    lines = run_command("stats hw --out out", capsys).splitlines()
    assert [line.split() for line in lines[:3]] == [
        ["part", "mean", "right", "partly", "wrong", "not", "answered"],
        ["p", "0.50", "1", "1", "0", "1"],
        ["R", "0.33", "1", "0", "1", "1"],
    ]
    assert lines[5].split(maxsplit=2) == [
        "1", "p", "The position is in millimetres: use metres"
    ]  # fmt: skip
    assert Path("out/statistics.svg").read_text("utf-8").startswith("<?xml")
    assert "holds no marks" in run_command("stats hw --out none", capsys, 2)


def test_late_csv_with_unknown_students_is_refused(here):
    make_course("ab")
    Path("hw/late.csv").write_text("id,late\nzz,1\nab,1\nyy,1\n", "utf-8")
    with pytest.raises(ArmError, match="line 2: no student 'zz'; line 4: no student 'yy'"):
        grade_hand_ins(Path("hw"), Path("out"), jobs=1)


def test_hints_hide_marks_and_stop_after_three(here):
    course = make_course("ab")
    key = make_right_answers(course.sheet("ab"))
    for number in range(5):
        write_answers("ab", {**key, "p": [1000 * x + number * 1e-5 for x in key["p"]]})
        grade_hand_ins(Path("hw"), Path("out"), jobs=1, hints=3)
        hints = Path("out/ab/feedback.txt").read_text("utf-8")
        assert ("The position is in millimetres" in hints) == (number < 3)
        assert "of 1" not in hints
        assert "Right" not in hints
    assert "Hints are given for 3 hand-ins" in hints


def test_hand_in_to_a_different_course_is_not_marked(here):
    course = make_course("ab")
    name = store.name_sheet(course, "ab")
    write_answers("ab", {**make_right_answers(course.sheet("ab")), "sheet": "ffffff/ab"})
    (row,) = grade_hand_ins(Path("hw"), Path("out"), jobs=1).rows
    assert (row["total"], row["note"]) == (
        0,
        f"this answers 'ffffff/ab', another sheet of the same student; {name!r} is valid",
    )


def test_crash_while_reading_a_hand_in_is_reported(here, monkeypatch):
    course = make_course("ab")
    monkeypatch.setattr("course.grading.read_hand_in", lambda *_: 1 / 0)
    record = mark_student(Path("hw"), Path("out"), course)
    assert record["note"] == "marking it stopped; please look at it by hand (ZeroDivisionError)"


def test_crashed_process_affects_only_that_student(here, monkeypatch):
    make_course("ab", "cd")
    monkeypatch.setattr(processes, "START_METHOD", "fork")
    real = grading.read_hand_in
    monkeypatch.setattr(
        grading,
        "read_hand_in",
        lambda files, parts: os._exit(1) if len(files) > 1 else real(files, parts),
    )
    write_answers("ab", {"p": [1, 2, 3]})
    notes = [row["note"] for row in grade_hand_ins(Path("hw"), Path("out"), jobs=1).rows]
    assert notes == ["marking it stopped; please look at it by hand", "nothing was answered"]


@pytest.mark.skipif(sys.platform == "win32", reason="no signal can be sent")
def test_killed_grader_leaves_no_worker(here):
    make_course("ab", "cd", "ef")
    command = [sys.executable, "-m", "course", "grade", "hw", "--out", "o"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    process = subprocess.Popen([*command, "--jobs", "2"], env=environment, start_new_session=True)
    while not Path("o").exists() and process.poll() is None:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    for _ in range(600):
        workers = subprocess.run(["pgrep", "-s", str(process.pid)], capture_output=True).stdout
        if not workers:
            return
        time.sleep(0.1)
    pytest.fail("workers stay")


# Seeds, arms, rosters


def test_seed_is_hmac_of_title_student_and_attempt():
    course = store.Course("Ü", (), SECRET, {})
    expected = hmac.new(SECRET.encode(), b'["\\u00dc", "ab", 1, 3]', hashlib.sha256)
    assert store.derive_seed(course, "ab", 1, 3) == expected.hexdigest()


LIMITED = Arm(
    "An arm with every field, Ä",
    (
        revolute("a_1", "pi/2", 0.25, "pi", limits=(-1, 2), speed=3, effort=40),
        prismatic(d="h", limits=(0, np.inf), speed=0.5),
    ),
    values={"a_1": 0.3, "h": 0.4},
    home=(0.5, 0.25),
    source="made up",
).with_bodies([Body(1.5, (0.1, 0, 0.2)), Body(2, (0, 0.3, 0))])


@pytest.mark.parametrize("arm", [*ARMS, HANGING, MINE, LIMITED], ids=lambda arm: arm.name)
def test_arm_survives_json(arm):
    data = json.loads(json.dumps(store.arm_to_json(arm), allow_nan=False))
    back = store.arm_from_json(data)
    assert back == arm
    assert (back.source, back.home, back.bodies) == (arm.source, arm.home, arm.bodies)
    for wrong in ({k: v for k, v in data.items() if k != "rows"}, {**data, "other": 1}):
        with pytest.raises(ArmError, match=r"the stored arm lacks or mistypes .*(rows|other)"):
            store.arm_from_json(wrong)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("id,name\n../x,A\n", r"line 2: id is '\.\./x'"),
        ("id,name\nab,A\ncd,C\n Ab ,B\n", "line 4: id 'Ab' stands above already"),
        *(
            (f"id,name\n{student},A\n", r"^roster line 2: id is ")
            for student in ("", "a" * 65, ".a", "a.", "a b", "é", "CON", "con.txt", "Lpt9.a.b")
        ),
        ("student,name\nab,A\n", "has the columns student, name; expected id and name"),
        ("id,name\nab,A\ncd\n", "line 3 has the columns id; expected id and name"),
        ("id,name\n", "holds no student"),
        ("id,name\nab,\udcff\n", "is not in UTF-8; save it as CSV UTF-8"),
        ('id,name\nab,"Ada\ncd,Bo\n', "unexpected end of data; expected a second quotation mark"),
    ],
)
def test_bad_roster_is_reported_by_line(tmp_path, text, message):
    path = tmp_path / "roster.csv"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(ArmError, match=message):
        read_roster(path)


def test_roster_with_other_columns_is_read(tmp_path):
    path = tmp_path / "r.csv"
    text = '\ufeffmail,name,id\r\nx, Ada Ü , xcon.a_b@c-D9 \r\ny,"L,\r\nA",con1\r\n'
    for separator in ",;":
        path.write_bytes(text.replace(",", separator).encode())
        expected = (Student("xcon.a_b@c-D9", "Ada Ü"), Student("con1", f"L{separator}\r\nA"))
        assert read_roster(path) == expected


@pytest.mark.parametrize(
    "text",
    [
        "sep=;\nID;Name\nab;Ada L\n",
        "Username\tFirst name\tLast name\nab\tAda\tL\n\t\t\n",
        "Student,ID,SIS Login ID,Section\n    Points Possible,,,\nAda L,91,ab,1\n",
        "Student,ID,SIS User ID,SIS Login ID,Section,HW (7)\n,,,,,Manual Posting\n"
        '    Mögliche Punkte,,,,,10\n"Ada L",91,u1,ab,1,\n',
        "LastName,FirstName,ID,SIS Login ID,Section\n    Points Possible,,,,\nL,Ada,91,ab,1\n",
        "First Name,Last Name,SID,Email,Role\nAda,L,ab,ada@x.example,Student\n",
        "First name,Last name,Email address\nAda,L,ab\n",
        " id , Name \n ab , Ada L \n",
    ],
)
def test_roster_of_platforms_is_read(tmp_path, text):
    path = tmp_path / "r.csv"
    path.write_text(text, encoding="utf-8-sig")
    assert read_roster(path) == (Student("ab", "Ada L"),)


def test_every_bad_roster_line_is_reported(tmp_path):
    path = tmp_path / "r.csv"
    path.write_text("id,name\n../x,A\nab,B\nAB,C\n", encoding="utf-8")
    with pytest.raises(ArmError, match=r"line 2: id is .*; roster line 4: id 'AB' stands above"):
        read_roster(path)
