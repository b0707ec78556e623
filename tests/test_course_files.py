"""The files of a course: sheets and pages, what is handed in, rosters and secrets; each read back
by another reader, or told in words where it cannot be read.
"""

import base64
import hashlib
import hmac
import json
import math
import re
from dataclasses import replace
from pathlib import Path

import nbformat
import numpy as np
import pytest
import sympy as sp
from matplotlib.figure import Figure

from helpers.arm import Arm, ArmError, Body, prismatic, revolute
from helpers.command_line import read_arm
from helpers.course import answers, arms, feedback, secrets, sheets, store
from helpers.course.answers import HandIn, as_typed, collected, hand_in, read_hand_in
from helpers.course.marking import Mark
from helpers.course.roster import Student, must_name_a_folder, read_roster
from helpers.course.sandbox import Limits, Ran
from helpers.course.store import Course, Rules
from helpers.robots import PANDA, UR10E
from helpers.variants import Sheet
from tests.test_commands import a_machine_with_another_encoding_of_its_own  # noqa: F401
from tests.test_course import MINE, SECRET
from tests.test_marking import DRAWN

LIMITED = Arm(
    "An arm with all that an arm may have, Ä",
    (
        revolute("a_1", "pi/2", 0.25, "pi", limits=(-1, 2), speed=3, effort=40),
        prismatic(d="h", limits=(0, math.inf), speed=0.5),
    ),
    values={"a_1": 0.3, "h": 0.4},
    home=(0.5, 0.25),
    source="made up",
).with_bodies([Body(1.5, (0.1, 0, 0.2)), Body(2, (0, 0.3, 0))])
AS_JSON = {
    "name": "An arm with all that an arm may have, Ä",
    "rows": [
        {"kind": "revolute", "a": "a_1", "alpha": "pi/2", "d": 0.25, "theta": "pi",
         "lower": -1, "upper": 2, "speed": 3, "effort": 40},
        {"kind": "prismatic", "a": 0, "alpha": 0, "d": "h", "theta": 0, "lower": 0, "speed": 0.5},
    ],
    "values": {"a_1": 0.3, "h": 0.4},
    "bodies": [{"mass": 1.5, "com": [0.1, 0, 0.2]}, {"mass": 2, "com": [0, 0.3, 0]}],
    "home": [0.5, 0.25],
    "source": "made up",
}  # fmt: skip
COURSE = Course("Homework Ä", MINE, ("Jacobian",), Rules(0.5, 0.25, {"a": 0.75}), {})
TABLE, POSE = (Sheet(MINE, {topic: DRAWN[topic]}) for topic in ("DH table", "forward kinematics"))


def numbers(data):
    """An arm's data with numbers for the texts that are numbers."""
    plain = {k: [numbers(x) for x in v] if k == "rows" else v for k, v in data.items()}
    return {k: float(v) if isinstance(v, str) and v.isdigit() else v for k, v in plain.items()}


@pytest.mark.parametrize("arm", [LIMITED, PANDA.lock(3), MINE], ids=lambda arm: arm.name)
def test_an_arm_is_plain_data(arm):
    data = arms.to_json(arm)
    if arm is LIMITED:
        assert json.loads(json.dumps(numbers(data))) == AS_JSON
        assert arms.from_json(AS_JSON) == LIMITED
    locked = [row for row in data["rows"] if row["kind"] not in ("revolute", "prismatic")]
    assert len(locked) == arm.name.count("Panda")
    assert all(row["at"] == 0 for row in locked)
    back = arms.from_json(json.loads(json.dumps(data)))
    assert back == arm
    assert (back.source, back.home, back.bodies) == (arm.source, arm.home, arm.bodies)


@pytest.mark.parametrize("key", AS_JSON)
def test_an_arm_that_lacks_something_is_told(key):
    with pytest.raises(ArmError) as told:
        arms.from_json({k: v for k, v in AS_JSON.items() if k != key})
    said = f"the stored arm lacks or mistypes {key!r}; expected what to_json makes"
    assert str(told.value) == said
    with pytest.raises(ArmError, match=r"^arm is "):
        arms.to_json(AS_JSON)


def test_an_arm_from_words_and_the_joints_that_are_held(tmp_path):
    assert arms.find_arm("panda") == PANDA
    held = arms.find_arm("Panda", (3, 5))
    assert held.rows == PANDA.lock(5).lock(3).rows
    assert held.name == f"{PANDA.lock(5).lock(3).name}, joint 3 and 5 locked"
    path = tmp_path / "arm.py"
    path.write_text("from helpers.robots import UR10E\nOTHER = 3\n", encoding="utf-8")
    assert read_arm(f"{path}:UR10E") == UR10E
    for words, said in (
        (f"{path}:OTHER", f"OTHER of {path} is 3; expected an Arm"),
        (f"{path}:NONE", f"NONE of {path} is None; expected an Arm"),
        ("no.py:A", "no.py is not there; expected a Python file, as in my_arm.py:ARM"),
    ):
        with pytest.raises(ArmError) as told:
            read_arm(words)
        assert str(told.value) == said
    with pytest.raises(ArmError, match="no arm is called 'a:b'"):
        read_arm("a:b")


URDF = """<robot name="two"><link name="l0"/><link name="l1"/><link name="l2"/><link name="l3"/>
<joint name="j1" type="revolute"><parent link="l0"/><child link="l1"/><axis xyz="0 0 1"/>
<origin xyz="0 0 0.2"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/><axis xyz="0 1 0"/>
<origin xyz="0.3 0 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="j3" type="fixed"><parent link="l2"/><child link="l3"/><origin xyz="0.1 0 0"/></joint>
</robot>"""


@pytest.mark.parametrize("ending", ["urdf", "xml"])
def test_an_arm_is_read_from_a_description_between_two_links(tmp_path, ending):
    path = tmp_path / f"two.{ending}"
    path.write_text(URDF, encoding="utf-8")
    assert read_arm(str(path)).dof == 2
    assert read_arm(str(path), "l1").dof == 1
    whole, short = (read_arm(str(path), None, tip) for tip in ("l3", "l2"))
    assert whole == read_arm(str(path))
    assert whole != short


# A course on disk


def stored():
    entry = store.drawn_sheet(COURSE, "ab", "Ada Ü", SECRET)
    return replace(COURSE, sheets={"ab": entry})


def test_a_course_is_written_as_json_and_read_back(tmp_path):
    course = stored()
    folder = tmp_path / "a" / "b"
    store.save(course, folder)
    store.save(course, folder)
    assert [path.name for path in folder.iterdir()] == ["course.json"]
    text = (folder / "course.json").read_text(encoding="utf-8")
    assert text == store.text(course)
    assert text.endswith("}\n")
    assert text.splitlines()[1] == ' "version": 1,'
    data = json.loads(text)
    assert data == {
        "version": 1, "title": "Homework Ä", "arm": arms.to_json(MINE), "topics": ["Jacobian"],
        "rules": {"digits": 0.5, "columns": 0.25, "causes": {"a": 0.75}}, "sheets": course.sheets,
    }  # fmt: skip
    assert store.load(folder) == course


def test_a_drawn_sheet_is_signed_over_all_that_was_drawn():
    entry = stored().sheets["ab"]
    assert entry.keys() == {"name", "values", "drawn", "signature"}
    assert entry["name"] == "Ada Ü"
    drawn_from = secrets.seed(SECRET, "ab", "Homework Ä 0")
    sheet = store.variants.sheet(MINE, drawn_from, ("Jacobian",))
    assert (entry["values"], entry["drawn"]) == (sheet.arm.values, sheet.drawn)
    content = {"values": entry["values"], "drawn": entry["drawn"]}
    assert entry["signature"] == secrets.signature(SECRET, "ab", content)
    assert entry != store.drawn_sheet(COURSE, "ab", "Ada Ü", SECRET, 1)
    for found in (stored().sheet("ab", SECRET), stored().unsigned("ab")):
        assert found.arm == MINE.with_values(**entry["values"])
        assert found.drawn == entry["drawn"]
    for key, value in (("values", {"h": 1, "a_2": 1}), ("drawn", {}), ("signature", "")):
        changed = replace(COURSE, sheets={"ab": {**entry, key: value}})
        with pytest.raises(ArmError) as told:
            changed.sheet("ab", SECRET)
        words = "the stored sheet of 'ab' was changed, or the secret is another; expected the one"
        assert str(told.value) == f"{words} that the course was made with"
    with pytest.raises(ArmError) as told:
        stored().sheet("cd", SECRET)
    assert str(told.value) == "student 'cd' is not in this course"
    with pytest.raises(ArmError, match=r"^student id is 'a/b'; expected 1 to 64 letters"):
        store.drawn_sheet(COURSE, "a/b", "A", SECRET)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (None, "cannot be read (No such file or directory); expected a course that `new` made"),
        ({"version": 2}, "is of version 2; expected 1"),
        ({"title": ...}, "is no course that `new` made: KeyError('title')"),
        ({"rules": {"digit": 1}}, "is no course that `new` made: TypeError("),
        ("{", "is no course that `new` made: JSONDecodeError("),
        (b'{"title": "\xe9"}', "is no course that `new` made: UnicodeDecodeError("),
        ("[]", "is no course that `new` made: TypeError("),
    ],
)
def test_a_course_that_cannot_be_read_is_told(tmp_path, change, words):
    path = tmp_path / "course.json"
    if change is not None:
        text = change
        if isinstance(change, dict):
            data = {**json.loads(store.text(stored())), **change}
            text = json.dumps({k: v for k, v in data.items() if v is not ...}, default=str)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ArmError) as told:
        store.load(tmp_path)
    assert str(told.value).startswith(f"{path} {words}")


# Secrets


def mac(*parts):
    """RFC 2104 by another road than the code's: hmac.digest over netstrings without commas."""
    text = b"".join(str(len(p.encode())).encode() + b":" + p.encode() for p in parts)
    return hmac.digest(SECRET, text, hashlib.sha256).hex()


def test_secrets_seeds_and_signatures(tmp_path):
    path = tmp_path / "s"
    for size in (15, 16):
        path.write_bytes(b" \n" + b"x" * size + b"\r\n")
        if size == 16:
            assert secrets.read_secret(path) == b"x" * 16
            continue
        with pytest.raises(ArmError) as told:
            secrets.read_secret(str(path))
        assert str(told.value) == f"the secret in {str(path)!r} has 15 bytes; expected 16 or more"
    with pytest.raises(ArmError) as told:
        secrets.read_secret(tmp_path / "none")
    first = f"secret file {str(tmp_path / 'none')!r} cannot be read (No such file or directory)"
    assert str(told.value).startswith(f"{first}; expected a file of 16 bytes or more, such as `")
    assert secrets.seed(SECRET, "Ü", "B") == mac("seed", "B", "Ü")
    content = {"b": [1.5], "a": "Ü"}
    text = '{"a": "\\u00dc", "b": [1.5]}'
    signed = secrets.signature(SECRET, "ab", content)
    assert signed == mac("sheet", "ab", text)
    assert secrets.is_signed(SECRET, "ab", {"a": "Ü", "b": [1.5]}, signed) is True
    for wrong in ((SECRET, "ac", content, signed), (SECRET, "ab", {}, signed),
                  (b"x" * 16, "ab", content, signed), (SECRET, "ab", content, None)):  # fmt: skip
        assert secrets.is_signed(*wrong) is False
    for student in ("", 3, None):
        with pytest.raises(ArmError) as told:
            secrets.seed(SECRET, student, "B")
        assert str(told.value) == f"student id is {student!r}; expected a word"


# Rosters


def test_a_roster_is_read_with_spaces_signs_and_other_columns(tmp_path):
    path = tmp_path / "r.csv"
    text = '\ufeffmail,name,id\r\nx, Ada Ü , ab12 \r\ny,"Lovelace,\r\nAda",c\r\n,,d.e_f@g-h\r\n'
    path.write_bytes(text.encode())
    students = (
        Student("ab12", "Ada Ü"),
        Student("c", "Lovelace,\r\nAda"),
        Student("d.e_f@g-h", ""),
    )
    assert read_roster(path) == read_roster(str(path)) == students


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("id,mail\nab,A\n", "roster line 2 has the columns id, mail; expected id and name"),
        ("id,name\nab,A\ncd\n", "roster line 3 has the columns id, name; expected id and name"),
        ("name\n\nA,b,c\n", "roster line 2 has the columns name; expected id and name"),
        ("id,name\nab,A\nx y,B\n", "roster line 3: id is 'x y'; expected 1 to 64 letters, digits"
         " and . _ @ -, a letter or digit at either end, and no name that Windows keeps for"
         " itself"),
        ("id,name\nab,A\ncd,C\n Ab ,B\n", "roster line 4: id 'Ab' stands in line 2 already"),
        ("id,name\n", "roster {} holds no student; expected lines under id,name"),
        ("id,name\nab,\udcff\n", "roster {} cannot be read: 'utf-8' codec can't decode byte 0xff"),
        (None, "roster {} cannot be read: [Errno 2] No such file or directory"),
    ],
)  # fmt: skip
def test_a_roster_that_cannot_be_used_is_told(tmp_path, text, words):
    path = tmp_path / "r.csv"
    if text is not None:
        path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(ArmError) as told:
        read_roster(path)
    assert str(told.value).startswith(words.format(repr(str(path))))


@pytest.mark.parametrize(
    ("student", "fits"),
    [("a", True), ("a" * 64, True), ("a.b_c@d-E9", True), ("con1", True), ("xcon.a", True),
     ("", False), ("a" * 65, False), (".a", False), ("a.", False), ("a b", False), ("é", False),
     ("CON", False), ("con.txt", False), ("Lpt9.a.b", False)],
)  # fmt: skip
def test_an_id_names_a_folder_on_every_system(student, fits):
    if fits:
        must_name_a_folder(student, "it")
        return
    with pytest.raises(ArmError, match=r"^it is "):
        must_name_a_folder(student, "it")


# What is handed in


def test_answers_are_kept_as_they_were_typed(tmp_path, monkeypatch):
    q_1 = sp.Symbol("q_1")
    typed = {
        "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": 2j, "n": np.float64(0.5), "m": sp.Matrix([q_1]),
        "l": [1, (2, np.array([3]))], "d": {1: np.int64(2), "x": {"y": None}}, "s": q_1 + 1,
        "arm": LIMITED, "falsy": 0,
    }  # fmt: skip
    kept = {
        "t": "Ä", "b": True, "i": 3, "f": 0.1, "z": "2j", "n": 0.5, "m": [["q_1"]],
        "l": [1, [2, [3]]], "d": {"1": 2, "x": {"y": "None"}}, "s": "q_1 + 1",
        "arm": [["a_1", "pi/2", "0.25", "pi"], ["0", "0", "h", "0"]], "falsy": 0,
    }  # fmt: skip
    for name, value in typed.items():
        assert as_typed(value) == kept[name]
    names = {f"answer_{name}": value for name, value in typed.items()}
    others = {"answer_none": None, "answer_dots": ..., "my_answer_x": 1, "answer": 2, "t": 3}
    others["answer_answer_x"] = "twice"
    everything = {**kept, "answer_x": "twice"}
    assert json.loads(collected({**names, **others})) == everything
    monkeypatch.chdir(tmp_path)
    hand_in({**names, **others})
    assert json.loads(Path("answers.json").read_text("utf-8")) == everything
    assert Path("answers.json").read_text("utf-8").endswith("}\n")
    hand_in({}, "other.json")
    assert Path("other.json").read_text("utf-8") == "{}\n"
    with pytest.raises(ArmError, match=r"^names is "):
        hand_in([])


def notebook(path, *lines, kind="code"):
    book = {"cells": [{"cell_type": kind, "source": list(lines)}]}
    path.write_text(json.dumps(book, ensure_ascii=False), encoding="utf-8")


def test_what_lies_in_a_folder_is_read_or_run_or_told(tmp_path, monkeypatch):
    ran = []

    def run(*given, **how):
        ran.append((given, how))
        return Ran({"p": 1}, "late") if len(ran) % 2 else Ran(None, "broken")

    monkeypatch.setattr(answers, "run", run)
    limits = Limits(1, 2, 3)

    def found():
        return read_hand_in(tmp_path, "process", limits, as_root=True)

    assert found() == HandIn({}, "nothing was handed in")
    for name in ("b.ipynb", "a.ipynb"):
        notebook(tmp_path / name, "answer_é = 1")
    assert found() == HandIn({}, "there are 2 notebooks (a.ipynb, b.ipynb); hand in one")
    notebook(tmp_path / "homework.ipynb", "answer_p = 1")
    assert found() == HandIn({"p": 1}, "late")
    assert found() == HandIn({}, "broken")
    assert ran == [((tmp_path / "homework.ipynb", "process", limits), {"as_root": True})] * 2
    for name in ("b.ipynb", "homework.ipynb"):
        (tmp_path / name).unlink()
    (tmp_path / "z.ipynb").symlink_to(tmp_path / "a.ipynb")
    assert found() == HandIn({"p": 1}, "late")
    read_hand_in(tmp_path, "process")
    assert ran[2:] == [
        ((tmp_path / "a.ipynb", "process", limits), {"as_root": True}),
        ((tmp_path / "a.ipynb", "process", None), {"as_root": False}),
    ]
    notebook(tmp_path / "a.ipynb", "answer_p = ...")
    assert found() == HandIn({}, "nothing was answered")
    (tmp_path / "answers.json").write_text('{"é": [1]}', encoding="utf-8")
    assert found() == HandIn({"é": [1]}, "")
    assert len(ran) == 4


@pytest.mark.parametrize(
    ("lines", "kind", "untouched"),
    [
        (["# p\n", "answer_p = ...\n", "answer_R=..."], "code", True),
        (["if 1:\n", "  answer_p  =  ...  "], "code", True),
        (["answer_p = ...\n", "answer_R = 1"], "code", False),
        (["answer_p = 1\n", "answer_R = ..."], "code", False),
        (["x = ...\n"], "code", False),
        (["answer_p = ..."], "markdown", False),
        (["answer_p = [...]"], "code", False),
    ],
)
def test_a_notebook_of_dots_alone_was_not_answered(tmp_path, lines, kind, untouched):
    notebook(tmp_path / "a.ipynb", *lines, kind=kind)
    assert answers._untouched(tmp_path / "a.ipynb") is untouched
    (tmp_path / "a.ipynb").write_text("{", encoding="utf-8")
    assert answers._untouched(tmp_path / "a.ipynb") is False


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b'{"a": 1}' + b" " * 999_992, None),
        ('{"a": 1}'.encode("utf-8-sig"), None),
        ('{"a": 1}'.encode("utf-16"), None),
        (b'{"a": 1}' + b" " * 999_993, "has more than 1,000,000 bytes"),
        (b"[1]", "holds no names"),
        (b"{", "Expecting property name enclosed in double quotes"),
        (b"\xff", "'utf-8' codec can't decode byte 0xff"),
        (b'{"a": ' + b"[" * 100_000, ""),
        ("folder", "is no ordinary file"),
        ("link", "is no ordinary file"),
        ("nowhere", "is no ordinary file"),
    ],
    ids=range(11),
)
def test_answers_that_cannot_be_read_are_told(tmp_path, content, words):
    path = tmp_path / "answers.json"
    if content == "folder":
        path.mkdir()
    elif isinstance(content, str):
        target = tmp_path / "x"
        target.write_text("{}", encoding="utf-8")
        path.symlink_to(target if content == "link" else tmp_path / "none")
    else:
        path.write_bytes(content)
    found = read_hand_in(tmp_path, "nothing")
    if words is None:
        assert found == HandIn({"a": 1}, "")
        return
    assert found.answers == {}
    assert found.trouble.startswith(f"answers.json could not be read: {words}")


# Sheets


def test_a_sheet_as_a_notebook_is_what_jupyter_reads(tmp_path):
    sheet = Sheet(MINE, {t: DRAWN[t] for t in ("forward kinematics", "DH table")})
    book = sheets.notebook(sheet, COURSE, "ab", "Ada Ü")
    nbformat.validate(book, version=4, version_minor=5)
    assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    assert book["metadata"] == {"kernelspec": kernel}
    ids = ["title", "arm", "setup", "question-1", "answer-p", "answer-R", "question-2"]
    assert [cell["id"] for cell in book["cells"]] == [*ids, "answer-table", "hand-in", "write"]
    kinds = {"title", "arm", "question-1", "question-2", "hand-in"}
    for cell in book["cells"]:
        assert cell["cell_type"] == ("markdown" if cell["id"] in kinds else "code")
        assert cell["metadata"] == {}
        if cell["cell_type"] == "code":
            assert (cell["outputs"], cell["execution_count"]) == ([], None)
    source = {cell["id"]: cell["source"] for cell in book["cells"]}
    first, second = sheet.questions
    assert source["title"].startswith("# Homework Ä\n\nAda Ü (ab)\n\nAnswer by the names that")
    assert "\n\nPut each answer in place of the dots." in source["title"]
    assert source["arm"] == f"## The arm\n\n{MINE._repr_markdown_()}"
    assert source["question-1"] == first.markdown
    picture = "\n\n![The joint axes at q = 0](attachment:axes.png)"
    assert source["question-2"] == second.markdown + picture
    (attached,) = (cell["attachments"] for cell in book["cells"] if "attachments" in cell)
    png = base64.b64decode(attached["axes.png"]["image/png"])
    assert png.startswith(b"\x89PNG")
    assert source["answer-p"] == "# the tip's position (m)\nanswer_p = ..."
    assert source["hand-in"].startswith("## Hand in\n\nThe last cell writes `answers.json`")
    space = {}
    exec(source["setup"], space)
    assert space["arm"] == MINE
    assert {"np", "sp", "checks", "kinematics", "motion", "statics", "symbolic"} <= space.keys()
    assert len(source["setup"].splitlines()) == 9 + len(MINE.rows) + 7
    handed = []
    code = source["write"].replace("from helpers.course import hand_in", "")
    exec(code, {"hand_in": handed.append, "answer_p": 1})
    assert handed[0]["answer_p"] == 1
    text = sheets.notebook_text(book)
    path = tmp_path / "a.ipynb"
    path.write_text(text, encoding="utf-8")
    assert nbformat.read(path, as_version=4).cells[4].source == source["answer-p"]
    assert sheets._code("a_b", "x")["id"] == "a-b"


def test_an_arm_is_written_into_the_notebook_a_row_a_line():
    text = sheets.arm_literal(Sheet(LIMITED, {}))
    assert eval(text) == arms.to_json(LIMITED)
    lines = text.splitlines()
    assert lines[:3] == ["{", f"    'name': {LIMITED.name!r},", "    'rows': ["]
    rows = [f"        {row!r}," for row in arms.to_json(LIMITED)["rows"]]
    bodies = [f"        {body!r}," for body in arms.to_json(LIMITED)["bodies"]]
    assert lines[3:10] == [*rows, "    ],", "    'bodies': [", *bodies, "    ],"]
    assert [line.split(":")[0] for line in lines[10:]] == [
        "    'values'", "    'home'", "    'source'", "}",
    ]  # fmt: skip


def test_the_numbers_of_a_sheet_are_kept_for_look():
    text = sheets.numbers_text(POSE)
    assert text.startswith('{\n "arm": {\n  "name"')
    assert text.endswith("}\n")
    assert json.loads(text) == {"arm": arms.to_json(MINE), "drawn": POSE.drawn}


def test_a_sheet_as_markdown_and_as_a_page():
    how = sheets._HOW
    head = f"# Homework Ä\n\nA<b> (ab)\n\n{how}\n\n## The arm\n\n{MINE._repr_markdown_()}\n\n"
    text = sheets.markdown(POSE, COURSE, "ab", "A<b>")
    assert text == head + POSE.questions[0].markdown
    drawn = "\n\n![The joint axes at q = 0, drawn in the base frame](axes.svg)"
    assert sheets.markdown(TABLE, COURSE, "ab", "A<b>") == (
        head + TABLE.questions[0].markdown + drawn
    )
    page = sheets.sheet_page(POSE, COURSE, "ab", "A<b>")
    assert page.startswith('<!doctype html><html lang="en"><meta charset="utf-8"><title>Homework Ä')
    assert "<title>Homework Ä, ab</title>" in page
    assert "<p>A&lt;b&gt; (ab)</p>" in page
    assert page.endswith("</body></html>\n")
    assert page.count("<math") == POSE.questions[0].text.count("$") // 2 + head.count("$") // 2
    assert "<table>" in page
    assert "axes.svg" not in page
    assert "base64" not in page
    assert f"<style>{sheets._STYLE}</style>" in page
    assert '<meta name="viewport" content="width=device-width">' in page
    page = sheets.sheet_page(TABLE, COURSE, "ab", "Ada")
    (data,) = re.findall(r'<img src="data:image/svg\+xml;base64,([^"]+)"', page)
    svg = base64.b64decode(data).decode()
    assert svg.rstrip().endswith("</svg>")
    assert "<dc:date>" not in svg
    assert '<title>a&amp;b "c" &lt;</title>' in sheets.page("x", None, 'a&b "c" <')
    assert "&lt;i&gt;" in sheets.page("<i>", None, "")


def drawing(monkeypatch, question, form="png"):
    """The axes and the way in which they are saved."""
    saved = []
    monkeypatch.setattr(
        Figure, "savefig", lambda self, file, **how: saved.append((self, file, how))
    )
    sheets.axes_picture(question, form)
    ((figure, _, how),) = saved
    assert how["format"] == form
    return figure, how


def test_the_drawing_shows_each_axis_its_number_and_the_tip(monkeypatch):
    question = TABLE.questions[0]
    figure, how = drawing(monkeypatch, question)
    assert how["metadata"] is None
    assert tuple(figure.get_size_inches()) == (5, 4.5)
    (ax,) = figure.axes
    # The table multiplied by hand: a point of each axis, its direction, the tip.
    points = [(0, 0, 0), (0.3, -0.05, 0.1), (0.2, -0.2, 0.3), (0.3, -0.2, 0.7)]
    ways = [(0, 0, 1), (0, -1, 0), (-1, 0, 0), (0, -1, 0)]
    tip = (0.3, -0.5, 1.2)
    low, high = (np.add(points, sign * 0.25 * np.array(ways)) for sign in (-1, 1))
    lines = [np.array(line.get_data_3d()).T for line in ax.lines]
    expected = [*np.stack([low, high], 1), [tip], *([[0, 0, 0], x] for x in 0.2 * np.eye(3))]
    for line, ends in zip(lines, expected, strict=True):
        assert line == pytest.approx(np.array(ends))
    styles = [(line.get_linestyle(), line.get_color(), line.get_marker()) for line in ax.lines]
    turns, slides = ("-", "black", "None"), ("--", "black", "None")
    assert styles[:4] == [turns, slides, turns, turns]
    assert styles[4][1:] == ("black", "o")
    assert styles[5:] == [("-", "0.6", "None")] * 3
    assert [line.get_linewidth() for line in ax.lines][:4] == [1.5] * 4
    assert [line.get_linewidth() for line in ax.lines][5:] == [1] * 3
    said = [(text.get_text(), text.get_position_3d()) for text in ax.texts]
    assert [text for text, _ in said] == ["1", "2", "3", "4", " tip", "x", "y", "z"]
    for (_, place), end in zip(said, [*high, tip, *(0.2 * np.eye(3))], strict=True):
        assert place == pytest.approx(end)
    assert [text.get_fontsize() for text in ax.texts][:5] == [12] * 4 + [11]
    assert {text.get_color() for text in ax.texts[5:]} == {"0.4"}
    labels = [ax.get_xlabel(), ax.get_ylabel(), ax.get_zlabel()]
    assert labels == ["x (m)", "y (m)", "z (m)"]
    assert ax.get_aspect() == "equal"
    assert drawing(monkeypatch, question, "svg")[1]["metadata"] == {"Date": None}


# Feedback


def test_feedback_says_marks_words_and_questions_and_runs_nothing_that_was_typed(monkeypatch):
    monkeypatch.setattr(feedback, "page", lambda *given: given)
    marks = (
        Mark("p", 1.0, "Right.", "Right."),
        Mark("R", 0.123456789, "*a* | `b` $c$", "<script>\n  two\n"),
    )
    text, picture, title = feedback.feedback_page(COURSE, POSE, "ab", "A  <b>\n_x_", marks, "o [1]")
    assert (picture, title) == (None, "Homework Ä: ab")
    p, R = POSE.parts["p"].what, POSE.parts["R"].what
    assert text.split("\n\n") == [
        "# Homework Ä: 1.12346 of 2",
        r"A \<b\> \_x\_ (ab)",
        r"Note: o \[1\].",
        "| part | credit | verdict |\n|:--|--:|:--|\n| `p` | 1 | Right\\. |\n"
        r"| `R` | 0.123457 | \*a\* \| \`b\` \$c\$ |",
        "## Forward kinematics",
        "### `p`: 1", p, "    Right.",
        "### `R`: 0.123457", R, "    <script>\n      two",
    ]  # fmt: skip
    text = feedback.feedback_page(COURSE, POSE, "ab", "A", marks, "")[0]
    assert "Note" not in text
    marked = "\\`*_{}[]()#+-.!|<>$"
    assert feedback._plain(f"aX{marked}") == "aX" + "".join(f"\\{c}" for c in marked)
    assert feedback._quoted("") == "    "
