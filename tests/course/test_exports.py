"""Test downloads of learning platforms, tables of grades and Gradescope's autograder."""

import csv
import io
import json
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
import yaml

import helpers
from course import __main__ as commands
from course import collect, gradescope, grading, making, sending, store
from course.files import HandedFile, Member
from course.making import make_right_answers
from course.roster import Student
from course.sheets import Exercise
from helpers.arm import ArmError
from helpers.robots import ELBOW
from tests.course.test_course import SECRET

FIRST = ["Ada", "Émile", "Jean-Luc", "Zoë", "Mary", "Chika", "José", "Wei", "Nguyễn", "Søren",
         "Björn", "O'Neil"]  # fmt: skip
LAST = ["Lovelace", "Dupont", "Picard", "Łukasz", "Jones", "Okafor", "García", "Zhang", "Văn",
        "Øst", "Müller", "van"]  # fmt: skip
NAMES = {f"s{n:03}": f"{FIRST[n % 12]} {LAST[n // 10]}" for n in range(118)}
NAMES |= {"twin1": "Ada Twin", "twin2": "Ada Twin"}


def write_answers(student):
    return json.dumps({"sheet": student, "p": [1, 2, len(student)]})


def format_canvas_name(name):
    *first, last = name.split()
    return "".join(c for c in f"{last}{''.join(first)}".lower() if c.isalnum())


# Path of the n-th student's file in each platform's download.
PATHS = {
    "Canvas": lambda _, name, n: (
        f"{format_canvas_name(name)}{'_LATE' * (n % 3 == 0)}"
        f"_{1000 + n}_{90000 + n}_answers-{n % 4}.json"
    ),
    "Moodle": lambda _, name, n: (
        f"{name.replace(chr(39), '')}_{70000 + n}_assignsubmission_file{'_' * (n % 2)}"
        "/my homework/Answers.JSON"
    ),
    "Moodle, flat": lambda _, name, n: f"{name}_{70000 + n}_assignsubmission_file_answers.json",
    "Gradescope": lambda *_, n: f"assignment_5_export/submission_{3000 + n}/answers (1).json",
    "by hand": lambda student, _, n: f"{student if n % 2 else student.upper()}/answers.json",
}


def list_gradescope_submitters():
    entries = {
        f"submission_{3000 + n}": {
            ":submitters": [{":name": name, ":sid": student if n % 2 else None,
                             ":email": f"{student}@school.example"}],
            ":status": "processed",
        }
        for n, (student, name) in enumerate(NAMES.items())
    }  # fmt: skip
    return {"assignment_5_export/submission_metadata.yml": yaml.safe_dump(entries)}


@pytest.mark.parametrize(
    ("platform", "folder"), [*((platform, False) for platform in PATHS), ("Moodle", True)]
)
def test_class_of_120_is_sorted_for_each_platform(tmp_path, platform, folder):
    files = list_gradescope_submitters() if platform == "Gradescope" else {}
    for n, (student, name) in enumerate(NAMES.items()):
        files[PATHS[platform](student, name, n=n)] = write_answers(student)
    files |= {"__MACOSX/._x": "noise", ".DS_Store": "noise"}
    download = tmp_path / "download"
    with zipfile.ZipFile(f"{download}.zip", "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    if folder:
        with zipfile.ZipFile(f"{download}.zip") as archive:
            archive.extractall(download)
    path = download if folder else Path(f"{download}.zip")
    if platform in ("Canvas", "Moodle", "Moodle, flat"):
        collection = collect.collect_hand_ins(path, NAMES, tmp_path / "hw")
        assert NAMES.keys() - collection.files.keys() == {"twin1", "twin2"}  # same name
        keys = [
            re.search("write '(.*?)' and the id", message)[1] for message in collection.messages
        ]
        rows = [f"{key},twin{n}" for n, key in enumerate(sorted(keys), 1)]
        (tmp_path / "hw" / "placed.csv").write_text("\n".join(["hand-in,id", *rows]), "utf-8")
    for _ in range(2):  # the second collection replaces the first
        collection = collect.collect_hand_ins(path, NAMES, tmp_path / "hw")
        assert collection.messages == ()
        assert {*collection.handed_in} == NAMES.keys()
    for student in NAMES:
        (path,) = (tmp_path / "hw" / student / "handed_in").iterdir()
        assert json.loads(path.read_bytes())["sheet"] == student


def sort_files(**files):
    names = {"ab": "Ada Twin", "cd": "Ada Twin", "ef": "Bo Berg", "gh": "Li Na"}
    handed = [HandedFile(name, content.encode()) for name, content in files.items()]
    members = [Member(file.name, lambda file=file: file) for file in handed]
    collection = collect.sort_by_student(members, names)
    return {
        s: [f.name for f in group] for s, group in collection.files.items()
    }, collection.messages


def test_doubtful_files_are_reported_and_assigned_to_nobody():
    placed, messages = sort_files(**{
        "twinada_1_2_answers.json": "{}",
        "twinada_3_4_answers.json": write_answers("cd"),
        "bergbo_5_6_answers.json": write_answers("gh"),  # Bo's file with another student's sheet
        "nobody_7_8_homework.pdf": "%PDF",
        "anon_x_9_answers.json": write_answers("gh"),
        "Participant_11_assignsubmission_file_x.json": "{}",
    })  # fmt: skip
    assert placed == {"ef": ["bergbo_5_6_answers.json"]}
    assert [message.split(": ")[1] for message in messages] == [
        "twinada_1", "twinada_3", "bergbo_5_6_answers.json", "nobody_7", "anon_x_9_answers",
        "Participant_11",
    ]  # fmt: skip
    assert messages[2].endswith("answers the sheet of 'gh', not of 'ef'")
    assert "twinada may be ab or cd. Its files: twinada_1_2_answers.json. If" in messages[0]
    assert "twinada may be ab or cd; its sheet names cd. Its files" in messages[1]
    assert "nobody is nobody in the course" in messages[3]


def test_two_hand_ins_under_one_name_are_reported():
    placed, messages = sort_files(**{"bergbo_5_6_a.json": "{}", "bergbo_7_8_a.json": "{}"})
    assert placed == {}
    assert all("bergbo_5 and bergbo_7 both bear the name of ef" in text for text in messages)


def test_placed_csv_with_unknown_student_is_refused(tmp_path):
    (tmp_path / "placed.csv").write_text("hand-in,id\nbergbo_5,zz\n", "utf-8")
    (tmp_path / "d").mkdir()
    with pytest.raises(ArmError, match=r"placed\.csv cannot be used; line 2: no student 'zz'"):
        collect.collect_hand_ins(tmp_path / "d", {"ef": "Bo Berg"}, tmp_path)


def test_collect_command_reports_and_places(tmp_path, capsys):
    roster = [Student("ab", "Ada Lovelace"), Student("cd", "Bo Berg")]
    course = making.make_course(roster, [Exercise(ELBOW, ("forward kinematics",))], tmp_path / "hw")
    download = tmp_path / "d"
    (download / "x").mkdir(parents=True)
    key = json.dumps(make_right_answers(course.sheet("ab")))
    (download / "lovelaceada_1_2_answers-1.json").write_text(key, encoding="utf-8")
    (download / "x" / "scan.pdf").write_bytes(b"%PDF")
    (download / "ab").mkdir()
    with zipfile.ZipFile(download / "ab" / "all.zip", "w") as climbing:
        climbing.writestr("../../../../evil.txt", "out of here")
    assert commands.main(["collect", str(tmp_path / "hw"), str(download)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "1 of 2 students handed in something that can be read"
    assert lines[1].startswith(
        "not placed: x: x is nobody in the course. Its files: x/scan.pdf. If"
    )
    assert {path.parent.name for path in tmp_path.rglob("*evil.txt")} == {"handed_in"}
    arguments = ["grade", str(tmp_path / "hw"), "--out", str(tmp_path / "out")]
    assert commands.main(arguments) == 0
    assert "ab,Ada Lovelace,2.0,1.0,1.0," in (tmp_path / "out" / "grades.csv").read_text("utf-8")
    assert commands.main(["collect", str(tmp_path / "hw"), str(tmp_path / "none.zip")]) == 2
    assert "none.zip is not there; expected a download" in capsys.readouterr().err


BILLION_LAUGHS = "a: &a [x, x]\n" + "".join(f"b{n}: &b{n} [*a, *a, *a]\n" for n in range(9))


@pytest.mark.parametrize(
    "text",
    ["{", "[]", "[", "5", "x:", "a: b", "a: {b: c}", "a: 2026-99-99", "[" * 5000, BILLION_LAUGHS],
    ids=lambda text: text[:8],
)
def test_bad_gradescope_list_is_reported_and_ignored(text):
    placed, messages = sort_files(**{"submission_metadata.yml": text, "ef/a.json": "{}"})
    assert placed == {"ef": ["ef/a.json"]}
    assert messages[0].startswith("passed over: submission_metadata.yml cannot be read: ")


def test_gradescope_labels_are_read_as_texts():
    entries = "submission_1: {':submitters': [{':sid': 007}]}\n"
    files = {"submission_metadata.yml": entries, "submission_1/a.json": "{}"}
    handed = [Member(name, lambda n=name: HandedFile(n, files[n].encode())) for name in files]
    assert [*collect.sort_by_student(handed, {"007": "Bo", "7": "Al"}).files] == ["007"]


def test_texts_in_csv_files_are_never_formulas():
    rows = [{"id": "ab", "name": "Ada", "total": 2.0235}, {"id": "cd", "name": "=1", "total": 0}]
    text = grading.format_csv(rows)
    assert text == "id,name,total\r\nab,Ada,2.0235\r\ncd,'=1,0\r\n"
    for first in "=+-@\t\r\n|%":
        text = grading.format_csv([{"name": f"{first}1"}])
        assert list(csv.reader(io.StringIO(text, newline="")))[1] == [f"'{first}1"]
        for text in (f"Ada;{first}1", f"Ada;  {first}1", f"Ada\n{first}1"):  # other separators
            (row,) = csv.DictReader(io.StringIO(grading.format_csv([{"name": text}]), newline=""))
            assert f"'{first}1" in row["name"]


@pytest.mark.parametrize(
    ("handed", "expected"),
    [
        ("lovelaceada_LATE_12_345_note.txt", "lovelaceada_LATE_12_345_feedback.txt"),
        ("Ada Lovelace_7_assignsubmission_file_/n.txt", "Ada Lovelace_7_assignsubmission_file_/"),
        ("Ada Lovelace_7_assignsubmission_file_n.txt", "Ada Lovelace_7_assignsubmission_file_"),
    ],
)
def test_send_packs_by_the_names_of_the_download(tmp_path, capsys, handed, expected):
    exercises = [Exercise(ELBOW, ("forward kinematics",))]
    roster = [Student("ab", "Ada Lovelace"), Student("cd", "Bo Berg")]
    making.make_course(roster, exercises, tmp_path / "hw", jobs=1)
    grading.grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1)
    with zipfile.ZipFile(tmp_path / "d.zip", "w") as archive:
        archive.writestr(handed, "hello")
    line = f"send {tmp_path}/hw {tmp_path}/d.zip --out {tmp_path}/f.zip"
    for option, name in (("", "homework.ipynb"), (f" --results {tmp_path}/out", "feedback.txt")):
        assert commands.main((line + option).split()) == 0
        with zipfile.ZipFile(tmp_path / "f.zip") as archive:
            (packed,) = archive.namelist()
            assert packed == expected.removesuffix("feedback.txt") + name
            folder = tmp_path / ("out" if option else "hw") / "ab" / name
            assert archive.read(packed) == folder.read_bytes()
    assert "feedback for 1 of 2" in (text := capsys.readouterr().out)
    assert text.endswith("not in the download: cd\n")


def test_send_refuses_a_download_without_names_of_a_platform(course, tmp_path):
    (tmp_path / "b.7").mkdir()
    (tmp_path / "b.7" / "a.txt").write_text("x", encoding="utf-8")
    with pytest.raises(ArmError, match="has no names of Canvas or Moodle"):
        sending.pack_for_platform(course, tmp_path, tmp_path, tmp_path / "f.zip")


# Gradescope


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Make a course of two students and two topics."""
    folder = tmp_path_factory.mktemp("exports") / "hw"
    students = [Student("Ada@x.example", "Ada L"), Student("b.7", "Bo Ü")]
    topics = ("forward kinematics", "Jacobian")
    return making.make_course(students, [Exercise(ELBOW, topics)], folder, secret=SECRET)


@pytest.fixture(scope="module")
def unpacked(course, tmp_path_factory):
    """Unpack the autograder as Gradescope does before it runs setup.sh."""
    root = tmp_path_factory.mktemp("autograder")
    gradescope.pack_autograder(course, root / "a.zip")
    with zipfile.ZipFile(root / "a.zip") as file:
        file.extractall(root / "source")
        modes = {i.filename: i.external_attr >> 16 & 0o777 for i in file.infolist()}
    return root, modes


def test_autograder_contains_the_course_without_its_secret(unpacked):
    root, modes = unpacked
    assert modes["setup.sh"] == modes["run_autograder"] == 0o755
    assert {*modes} > {"setup.sh", "run_autograder", "course.json"}
    assert not any(SECRET.encode() in p.read_bytes() for p in root.rglob("*.json"))
    needs = (root / "source" / "requirements.txt").read_text("utf-8")
    assert "numpy" in needs
    assert "nbclient" not in needs
    for package in (Path(helpers.__file__).parent, Path(gradescope.__file__).parent):
        for path in package.rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                packed = root / "source" / package.name / path.relative_to(package)
                assert packed.read_bytes() == path.read_bytes()
    for script in ("setup.sh", "run_autograder"):
        text = (root / "source" / script).read_bytes()
        assert subprocess.run(["bash", "-n"], input=text, check=False).returncode == 0


def submit(root, users, answers):
    folder = root / "submission"
    folder.mkdir(exist_ok=True)
    (folder / "answers (1).json").write_text(json.dumps(answers), encoding="utf-8")
    metadata = json.dumps({"users": users})
    (root / "submission_metadata.json").write_text(metadata, encoding="utf-8")


def test_gradescope_marks_from_the_pack(course, unpacked):
    root, _ = unpacked
    answers = make_right_answers(course.sheet("b.7"))
    submit(root, [{"email": "B.7@school.example", "name": "B", "id": 9}], answers)
    command = [sys.executable, "-m", "course.gradescope", str(root)]
    subprocess.run(command, cwd=root / "source", check=True)
    results = json.loads((root / "results" / "results.json").read_text("utf-8"))
    assert results["score"] == len(results["tests"]) == 5
    assert results["output"] == "Read as the sheet of b.7: every part was read."
    assert results["tests"][0]["visibility"] == "after_published"
    assert "p: " not in results["output"]  # no hints by default


def test_gradescope_gives_as_many_hints_as_asked(course, tmp_path):
    gradescope.pack_autograder(course, tmp_path / "a.zip", hints=1)
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        file.extractall(tmp_path / "source")
    submit(tmp_path, [{"email": "B.7@school.example"}], make_right_answers(course.sheet("b.7")))
    assert "p: It was read; no usual mistake" in gradescope.run_autograder(tmp_path)["output"]
    metadata = {"users": [{"email": "B.7@x"}], "previous_submissions": [{}]}
    (tmp_path / "submission_metadata.json").write_text(json.dumps(metadata), encoding="utf-8")
    assert "Hints are given for 1 hand-ins" in gradescope.run_autograder(tmp_path)["output"]


@pytest.mark.parametrize(
    ("users", "message"),
    [
        ([{"email": "ada@X.example"}], "Read as the sheet of Ada@x.example: "),
        ([{"email": "x@y", "name": "bo ü"}], "Read as the sheet of b.7: "),
        ([{"email": "x@y", "name": "Nobody"}], "No sheet of this course belongs to your name"),
        ([{"email": "ada@x.example"}, {"email": "b.7@z"}], "More than one sheet of this course"),
        ([{}], "No sheet of this course"),
        (None, "Marking stopped (TypeError); please tell your instructor."),
    ],
)
def test_gradescope_finds_the_sheet_of_the_user(course, unpacked, users, message):
    root, _ = unpacked
    submit(root, users, {"p": [1, 2, 3]})
    results = gradescope.run_autograder(root)
    assert results["output"].startswith(message)
    assert results["score"] == 0
    assert json.loads((root / "results" / "results.json").read_bytes()) == results


def test_gradescope_reports_answers_to_another_sheet(course, unpacked):
    root, _ = unpacked
    other = {
        **make_right_answers(course.sheet("Ada@x.example")),
        "sheet": store.name_sheet(course, "Ada@x.example"),
    }
    submit(root, [{"email": "b.7@z"}], other)
    results = gradescope.run_autograder(root)
    message = "Read as the sheet of b.7: this answers the sheet of 'Ada@x.example', not of 'b.7'."
    assert results["output"].startswith(message)
    assert results["score"] == 0
