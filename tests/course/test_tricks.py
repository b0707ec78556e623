"""Test that a hand-in cannot change the marks of another student."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from course import making, store
from course.collect import collect_hand_ins
from course.grading import grade_hand_ins
from course.making import make_right_answers
from course.roster import Student
from course.sheets import Exercise
from helpers.arm import ArmError
from helpers.robots import ELBOW
from tests.course.parts import make_zip

NAMES = {f"s{n:02}": f"Student {n}" for n in range(30)}
SUBMITTERS = "submission_1:\n  ':submitters': [{':sid': s02}]\n"


def answer(student, value):
    return json.dumps({"sheet": student, "p": [value, 2, 3]}).encode()


TRICKS = {
    "submission_metadata.yml": SUBMITTERS.encode(),
    "submission_1/answers.json": answer("s02", 0),
    "x submission_metadata.yml": b"[",
    "assignment_5_export/submission_metadata.yml": b"a: &a [x]\nb: *a\n",
    "s02/answers.json": answer("s02", 0),
    "s03_answers.json": answer("s03", 0),
    "student4_LATE_4_5_answers.json": answer("s04", 0),
    "Student 5_5_assignsubmission_file_/answers.json": answer("s05", 0),
    "answers.json": answer("s06", 0),
    "node_modules.zip": make_zip({f"{n}.js": b"" for n in range(20_001)}),
    "zeros.zip": make_zip({f"{n}.bin": bytes(20_000_000) for n in range(4)}),
    "zips.zip": make_zip({f"{n}.zip": make_zip({"z": bytes(19_000_000)}) for n in range(9)}),
    "../../s07/handed_in/answers.json": answer("s07", 0),
    "scan.pdf": bytes(20_000_001),
}


def make_download(path, **files_by_student):
    path.write_bytes(
        make_zip(
            {
                f"{student}/{name}": content
                for student, files in files_by_student.items()
                for name, content in files.items()
            }
        )
    )
    return path


def read_collected(folder):
    """Return for each student all files that `collect` stored."""
    return {
        student: {
            path.relative_to(folder / student).as_posix(): path.read_bytes()
            for path in sorted((folder / student).rglob("*"))
            if path.is_file()
        }
        for student in NAMES
    }


@pytest.fixture
def honest():
    return {student: {"answers.json": answer(student, 1)} for student in NAMES}


def test_tricks_of_a_student_leave_other_marks_unchanged(tmp_path, honest):
    plain = make_download(tmp_path / "plain.zip", **honest)
    tricked = make_download(tmp_path / "tricked.zip", **honest | {"s01": TRICKS})
    collect_hand_ins(plain, NAMES, tmp_path / "a")
    collection = collect_hand_ins(tricked, NAMES, tmp_path / "b")
    before, after = read_collected(tmp_path / "a"), read_collected(tmp_path / "b")
    assert {s: files for s, files in before.items() if s != "s01"} == {
        s: files for s, files in after.items() if s != "s01"
    }
    assert not collection.late
    assert {path.name for path in tmp_path.iterdir()} == {"a", "b", "plain.zip", "tricked.zip"}
    assert any("a hand-in may have 200 files" in message for message in collection.messages)


@pytest.mark.parametrize(
    "name", ["Student 2_7_assignsubmission_file_x_1_2_a.json", "student2_1_2_s03_3_4_a.json"]
)
def test_platform_name_ends_at_its_first_number(tmp_path, name):
    (tmp_path / "d").mkdir()
    (tmp_path / "d" / name).write_bytes(answer("s03", 0))
    assert [*collect_hand_ins(tmp_path / "d", NAMES, tmp_path / "hw").files] == ["s02"]


def test_empty_collection_keeps_the_earlier_one(tmp_path, honest):
    folder = tmp_path / "hw"
    collect_hand_ins(make_download(tmp_path / "1.zip", **honest), NAMES, folder)
    before = read_collected(folder)["s05"]
    huge = {"s05": {"answers.json": answer("s05", 9) + bytes(20_000_000)}}
    collection = collect_hand_ins(make_download(tmp_path / "2.zip", **huge), NAMES, folder)
    assert collection.handed_in == []
    assert collection.messages[0].startswith("not read: s05: s05/answers.json (20,000,0")
    assert collection.messages[1].startswith("s05: no file of this collection can be read, so")
    after = read_collected(folder)["s05"]
    assert {**after, ".not_read.json": b""} == {**before, ".not_read.json": b""}


def make_course(folder, *students, **options):
    roster = [Student(s, s.upper()) for s in students]
    exercises = [Exercise(ELBOW, ("forward kinematics",))]
    return making.make_course(roster, exercises, folder, jobs=1, **options)


def test_feedback_names_a_file_over_the_limit(tmp_path):
    make_course(tmp_path / "hw", "s01")
    sheet = (tmp_path / "hw/s01/homework.ipynb").read_text("utf-8")
    assert "A file may have 20 MB" in sheet
    download = make_download(tmp_path / "1.zip", s01={"answers.json": bytes(20_000_001)})
    collect_hand_ins(download, {"s01": "S01"}, tmp_path / "hw")
    grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1)
    feedback = (tmp_path / "out/s01/feedback.txt").read_text("utf-8")
    assert "answers.json (20,000,001 bytes; a file may have 20,000,000)" in feedback


# Making a course


def test_new_course_keeps_notebooks_of_a_lost_course_file(tmp_path):
    first = make_course(tmp_path, "ab")
    saved = (tmp_path / "course.json").read_bytes()
    (tmp_path / "course.json").unlink()
    with pytest.raises(ArmError, match=r"ab/homework.ipynb holds the sheet .*other numbers"):
        make_course(tmp_path, "ab")
    (tmp_path / "course.json").write_bytes(saved)
    assert make_course(tmp_path, "ab") == first


def test_full_disk_at_first_notebook_keeps_the_secret(tmp_path, monkeypatch):
    """If the disk is full at the first notebook, the repeated command must draw the same sheets."""
    write_text = store.write_text

    def fill_disk(path, text, mode=0o666):
        if path.name == "homework.ipynb":
            raise OSError(28, "No space left on device")
        write_text(path, text, mode)

    with monkeypatch.context() as full:
        full.setattr(store, "write_text", fill_disk)
        with pytest.raises(OSError, match="No space left"):
            make_course(tmp_path, "ab")
    secret = store.load_course(tmp_path).secret
    course = make_course(tmp_path, "ab")
    assert course.secret == secret
    assert not [*tmp_path.rglob(".homework*")]


def test_kill_between_notebook_and_course_file_is_completed(tmp_path, monkeypatch):
    save_course, saved = store.save_course, []

    def stop_at_second(course, folder):
        saved.append(course)
        if len(saved) == 2:
            raise KeyboardInterrupt
        save_course(course, folder)

    with monkeypatch.context() as killed:
        killed.setattr(store, "save_course", stop_at_second)
        with pytest.raises(KeyboardInterrupt):
            make_course(tmp_path, "ab")
    notebook = (tmp_path / "ab/homework.ipynb").read_bytes()
    assert make_course(tmp_path, "ab").sheets == saved[1].sheets
    assert (tmp_path / "ab/homework.ipynb").read_bytes() == notebook


def test_second_command_at_the_same_time_is_refused(tmp_path):
    code = (
        "import sys, pathlib; from course.store import lock_folder\n"
        f"with lock_folder(pathlib.Path({str(tmp_path)!r})):\n"
        "    print('locked', flush=True); sys.stdin.read()"
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    command = [sys.executable, "-c", code]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment
    ) as other:
        assert other.stdout.readline() == b"locked\n"
        with pytest.raises(ArmError, match="another command is changing"):
            make_course(tmp_path, "ab")
        other.kill()
    make_course(tmp_path, "ab")


def test_markup_in_a_name_is_shown_as_it_is(tmp_path):
    roster = [Student("ab", "<b>A_d_a</b> $x$ [l](u)\n# B")]
    exercises = [Exercise(ELBOW, ("forward kinematics",))]
    making.make_course(roster, exercises, tmp_path, jobs=1)
    book = json.loads((tmp_path / "ab/homework.ipynb").read_bytes())
    title = book["cells"][0]["source"].splitlines()[2]
    assert title == r"\<b\>A\_d\_a\</b\> \$x\$ \[l\](u) \# B (ab)"


# Hints and marks by hand


def test_unreadable_hand_in_uses_up_a_hint(tmp_path, monkeypatch):
    course = make_course(tmp_path / "hw", "ab")
    key = make_right_answers(course.sheet("ab"))
    path = tmp_path / "hw/ab/answers.json"
    feedback = tmp_path / "out/ab/feedback.txt"
    for number in range(3):
        path.write_text(json.dumps({**key, "p": [number, 1, 1]}), encoding="utf-8")
        grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1, hints=4)
        assert "p: It was read" in feedback.read_text("utf-8")
    for text in ("{", '{"p": {}}' * 2):
        path.write_text(text, encoding="utf-8")
        grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1, hints=4)
    path.write_text(json.dumps(key), encoding="utf-8")
    grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1, hints=4)
    assert "Hints are given for 4 hand-ins" in feedback.read_text("utf-8")


def test_part_marked_by_hand_appears_in_feedback(tmp_path):
    folder, out = tmp_path / "hw", tmp_path / "out"
    course = make_course(folder, "ab", "cd", by_hand={"derivation": 4.0})
    book = json.loads((folder / "ab/homework.ipynb").read_bytes())
    sources = [cell["source"] for cell in book["cells"]]
    assert any(s.startswith("## derivation\n\n4 points, marked by your") for s in sources)
    key = json.dumps(make_right_answers(course.sheet("ab")))
    (folder / "ab/answers.json").write_text(key, encoding="utf-8")
    first = grade_hand_ins(folder, out, jobs=1)
    assert [row["derivation"] for row in first.rows] == ["", ""]
    feedback = out / "ab/feedback.txt"
    assert "(ab): 2 of 6\n" in feedback.read_text("utf-8")
    assert "derivation: 0 of 4 for what is marked by hand\n    Not marked yet." in (
        feedback.read_text("utf-8")
    )
    template = (out / "marks.csv").read_text("utf-8")
    assert template.splitlines()[:2] == [
        "id,part,points,remark,files", "ab,derivation,,,answers.json; homework.ipynb"
    ]  # fmt: skip
    for points, remark in (("2,5", "no frames"), ("3", "frames found on page 2")):
        marks = f"id;part;points;remark\nab;derivation;{points};{remark}\ncd;derivation;;\n"
        (folder / "marks.csv").write_text(marks, encoding="utf-8")
        rows = grade_hand_ins(folder, out, jobs=1).rows
    assert (rows[0]["total"], rows[0]["derivation"], rows[1]["derivation"]) == (5, 0.75, "")
    assert feedback.read_text("utf-8").endswith(
        "derivation: 3 of 4 for what is marked by hand\n"
        "    Marked by hand: frames found on page 2\n"
        "    Earlier mark: 2.5 of 4. Marked by hand: no frames\n"
    )
    (folder / "marks.csv").write_text("id,part,points,remark\nab,derivation,5,\n", "utf-8")
    with pytest.raises(ArmError, match="points is '5'; expected a number from 0 to 4"):
        grade_hand_ins(folder, out, jobs=1)


def test_part_by_hand_with_a_name_in_use_is_refused(tmp_path):
    with pytest.raises(ArmError, match="p is a part that the sheet has"):
        make_course(tmp_path, "ab", by_hand={"p": 1.0})


def test_error_on_overrides_csv_names_its_replacement(tmp_path):
    make_course(tmp_path / "hw", "ab")
    (tmp_path / "hw/overrides.csv").write_text("id,part,credit,why\n", "utf-8")
    with pytest.raises(ArmError, match=r"earlier edition; expected marks.csv"):
        grade_hand_ins(tmp_path / "hw", tmp_path / "out", jobs=1)
