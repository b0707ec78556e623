"""What comes from learning platforms and goes to them: downloads, tables, packs."""

import csv
import io
import json
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
import yaml

import helpers
from course import __main__ as commands
from course import collect, gradescope, grading, making, store
from course.files import HandedFile
from course.making import right_work
from course.roster import Student
from helpers.arm import ArmError
from helpers.robots import ELBOW
from tests.course.test_course import SECRET

FIRST = ["Ada", "Émile", "Jean-Luc", "Zoë", "Mary", "Chika", "José", "Wei", "Nguyễn", "Søren",
         "Björn", "O'Neil"]  # fmt: skip
LAST = ["Lovelace", "Dupont", "Picard", "Łukasz", "Jones", "Okafor", "García", "Zhang", "Văn",
        "Øst", "Müller", "van"]  # fmt: skip
CLASS = {f"s{n:03}": f"{FIRST[n % 12]} {LAST[n // 10]}" for n in range(118)}
CLASS |= {"twin1": "Ada Twin", "twin2": "Ada Twin"}


def answers(student):
    return json.dumps({"sheet": student, "p": [1, 2, len(student)]})


def on_canvas(name):
    *first, last = name.split()
    return "".join(c for c in f"{last}{''.join(first)}".lower() if c.isalnum())


# Path at which each platform puts the file of the n-th student.
PLACES = {
    "Canvas": lambda _, name, n: (
        f"{on_canvas(name)}{'_LATE' * (n % 3 == 0)}_{1000 + n}_{90000 + n}_answers-{n % 4}.json"
    ),
    "Moodle": lambda _, name, n: (
        f"{name.replace(chr(39), '')}_{70000 + n}_assignsubmission_file{'_' * (n % 2)}"
        "/my homework/Answers.JSON"
    ),
    "Moodle, flat": lambda _, name, n: f"{name}_{70000 + n}_assignsubmission_file_answers.json",
    "Gradescope": lambda *_, n: f"assignment_5_export/submission_{3000 + n}/answers (1).json",
    "by hand": lambda student, _, n: f"{student if n % 2 else student.upper()}/answers.json",
}


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


@pytest.mark.parametrize(
    ("platform", "folder"), [*((platform, False) for platform in PLACES), ("Moodle", True)]
)
def test_a_class_of_120_is_sorted_whatever_the_platform_called_it(tmp_path, platform, folder):
    files = about_gradescope() if platform == "Gradescope" else {}
    for n, (student, name) in enumerate(CLASS.items()):
        files[PLACES[platform](student, name, n=n)] = answers(student)
    files |= {"__MACOSX/._x": "noise", ".DS_Store": "noise"}
    download = tmp_path / "download"
    with zipfile.ZipFile(f"{download}.zip", "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    if folder:
        with zipfile.ZipFile(f"{download}.zip") as archive:
            archive.extractall(download)
    place = download if folder else Path(f"{download}.zip")
    for _ in range(2):  # again, in place of the first
        placed, doubtful = collect.collect(place, CLASS, tmp_path / "hw")
        assert doubtful == ()
        assert placed.keys() == CLASS.keys()
    for student in CLASS:
        (path,) = (tmp_path / "hw" / student / "handed_in").iterdir()
        assert json.loads(path.read_bytes())["sheet"] == student


def sort(**files):
    names = {"ab": "Ada Twin", "cd": "Ada Twin", "ef": "Bo Berg", "gh": "Li Na"}
    placed, doubtful = collect.sort([HandedFile(n, c.encode()) for n, c in files.items()], names)
    return {s: [f.name for f in group] for s, group in placed.items()}, doubtful


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
    assert [words.split(":")[1].strip() for words in doubtful] == [
        "twinada_1_2_answers.json", "bergbo_5_6_answers.json", "nobody_7_8_homework.pdf",
        "Participant_11_assignsubmission_file_x.json",
    ]  # fmt: skip
    assert doubtful[1].endswith("answers the sheet of 'gh', not of 'ef'")
    assert "twinada may be ab or cd; the sheet in it does not tell" in doubtful[0]


def test_collecting_is_told_on_one_screen(tmp_path, capsys):
    roster = [Student("ab", "Ada Lovelace"), Student("cd", "Bo Berg")]
    made = making.new(roster, ELBOW, tmp_path / "hw", topics=("forward kinematics",))
    download = tmp_path / "d"
    (download / "x").mkdir(parents=True)
    key = json.dumps(right_work(made.sheet("ab")))
    (download / "lovelaceada_1_2_answers-1.json").write_text(key, encoding="utf-8")
    (download / "x" / "scan.pdf").write_bytes(b"%PDF")
    (download / "ab").mkdir()
    with zipfile.ZipFile(download / "ab" / "all.zip", "w") as climbing:
        climbing.writestr("../../../../evil.txt", "out of here")
    assert commands.main(["collect", str(tmp_path / "hw"), str(download)]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0] == "1 of 2 students handed in"
    assert said[1].startswith("not placed: x/scan.pdf: x is nobody in the course")
    assert {path.parent.name for path in tmp_path.rglob("*evil.txt")} == {"handed_in"}
    words = ["grade", str(tmp_path / "hw"), "--out", str(tmp_path / "out")]
    assert commands.main(words) == 0
    assert "ab,Ada Lovelace,2.0,1.0,1.0," in (tmp_path / "out" / "grades.csv").read_text("utf-8")
    assert commands.main(["collect", str(tmp_path / "hw"), str(tmp_path / "none.zip")]) == 2
    assert "none.zip is not there; expected a download" in capsys.readouterr().err


def test_an_export_of_gradescope_that_cannot_be_read_is_told():
    for text in ("{", "[]", "a: b", "a: {b: c}"):
        with pytest.raises(ArmError, match=r"^x/submission_metadata\.yml cannot be read: "):
            sort(**{"x/submission_metadata.yml": text})


def test_no_word_of_the_grades_is_a_formula():
    rows = [{"id": "ab", "name": "Ada", "total": 2.0235}, {"id": "cd", "name": "=1", "total": 0}]
    text = grading.format_table(rows)
    assert text == "id,name,total\r\nab,Ada,2.0235\r\ncd,'=1,0\r\n"
    for first in "=+-@\t\r\n|%":
        told = grading.format_table([{"name": f"{first}1"}])
        assert list(csv.reader(io.StringIO(told, newline="")))[1] == [f"'{first}1"]


# Other systems


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Two students, two topics, the folders they were given."""
    folder = tmp_path_factory.mktemp("exports") / "hw"
    students = [Student("Ada@x.example", "Ada L"), Student("b.7", "Bo Ü")]
    topics = ("forward kinematics", "Jacobian")
    return making.new(students, ELBOW, folder, topics=topics, secret=SECRET)


@pytest.fixture(scope="module")
def unpacked(course, tmp_path_factory):
    """Gradescope's folder as it is before setup.sh installs what the helpers need."""
    root = tmp_path_factory.mktemp("autograder")
    gradescope.pack(course, root / "a.zip")
    with zipfile.ZipFile(root / "a.zip") as file:
        file.extractall(root / "source")
        modes = {i.filename: i.external_attr >> 16 & 0o777 for i in file.infolist()}
    return root, modes


def test_the_zip_holds_the_course_the_helpers_and_no_secret(unpacked):
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


def handed_in(root, users, given):
    folder = root / "submission"
    folder.mkdir(exist_ok=True)
    (folder / "answers (1).json").write_text(json.dumps(given), encoding="utf-8")
    about = json.dumps({"users": users})
    (root / "submission_metadata.json").write_text(about, encoding="utf-8")


def test_gradescope_marks_by_what_was_packed(course, unpacked):
    root, _ = unpacked
    given = right_work(course.sheet("b.7"))
    handed_in(root, [{"email": "B.7@school.example", "name": "B", "id": 9}], given)
    command = [sys.executable, "-m", "course.gradescope", str(root)]
    subprocess.run(command, cwd=root / "source", check=True)
    results = json.loads((root / "results" / "results.json").read_text("utf-8"))
    assert results["score"] == len(results["tests"]) == 5
    assert (
        results["output"]
        == "Read as the sheet of b.7: every part was read.\n" + results["output"].partition("\n")[2]
    )
    assert results["tests"][0]["visibility"] == "after_published"
    assert "p: It was read; no usual mistake" in results["output"]


@pytest.mark.parametrize(
    ("users", "words"),
    [
        ([{"email": "ada@X.example"}], "Read as the sheet of Ada@x.example: "),
        ([{"email": "x@y", "name": "bo ü"}], "Read as the sheet of b.7: "),
        ([{"email": "x@y", "name": "Nobody"}], "No sheet of this course belongs to your name"),
        ([{"email": "ada@x.example"}, {"email": "b.7@z"}], "More than one sheet of this course"),
        ([{}], "No sheet of this course"),
        (None, "Marking stopped (TypeError); please tell your instructor."),
    ],
)
def test_gradescope_finds_whose_sheet_it_is_or_says_so(course, unpacked, users, words):
    root, _ = unpacked
    handed_in(root, users, {"p": [1, 2, 3]})
    results = gradescope.run(root)
    assert results["output"].startswith(words)
    assert results["score"] == 0
    assert json.loads((root / "results" / "results.json").read_bytes()) == results


def test_gradescope_says_whose_sheet_was_answered(course, unpacked):
    root, _ = unpacked
    other = {
        **right_work(course.sheet("Ada@x.example")),
        "sheet": store.name_sheet(course, "Ada@x.example"),
    }
    handed_in(root, [{"email": "b.7@z"}], other)
    results = gradescope.run(root)
    words = "Read as the sheet of b.7: this answers the sheet of 'Ada@x.example', not of 'b.7'."
    assert results["output"].startswith(words)
    assert results["score"] == 0
