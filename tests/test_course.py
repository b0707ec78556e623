"""A course from roster to grades: what is drawn is kept, what is hostile costs its own part
only.
"""

import csv
import io
import json
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import nbformat
import numpy as np
import pytest
import yaml

from helpers.arm import Arm, ArmError, prismatic, revolute
from helpers.course import arms, autograders, commands, gradebook, sandbox, secrets, store
from helpers.course.answers import collected, hand_in, read_hand_in
from helpers.course.commands import main
from helpers.course.marking import Mark, mark_sheet, prove
from helpers.course.roster import Student, read_roster
from helpers.inverse import elbow
from helpers.robots import ARMS, ELBOW, PANDA, UR10E
from helpers.variants import Sheet

SECRET = b"a course secret that is long enough"
ROSTER = (Student("ab12", "Ada"), Student("cd34", "=HYPERLINK(1)"), Student("ef56", "Émile"))
MINE = Arm(
    "An arm the book does not have",
    (revolute(d="h", alpha="pi/2"), revolute(a="a_2"), prismatic(d=0.1, limits=(0, 0.4))),
    values={"h": 0.3, "a_2": 0.4},
)


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """A course of three about the elbow arm: one right, one with named slips, one empty."""
    folder = tmp_path_factory.mktemp("course") / "hw"
    made = commands.new(ROSTER, SECRET, ELBOW, folder, "Homework 1")
    key = json.dumps(right(made.sheet("ab12", SECRET)))
    (folder / "ab12" / "answers.json").write_text(key, encoding="utf-8")
    wrong = right(made.sheet("cd34", SECRET))
    wrong |= {"p": (1000 * np.array(wrong["p"])).tolist(), "R": np.transpose(wrong["R"]).tolist()}
    (folder / "cd34" / "answers.json").write_text(json.dumps(wrong), encoding="utf-8")
    return folder


def right(sheet: Sheet) -> dict:
    """Every part of a sheet answered rightly, numbers to four decimals."""
    found = {}
    for name, part in sheet.parts.items():
        if part.kind == "table":
            found[name] = [[str(e) for e in row.entries] for row in part.value.rows]
        elif part.kind == "column":
            found[name] = part.value
        else:
            found[name] = np.round(part.value, 4).tolist()
    return found


def graded(folder: Path, out: Path, **how) -> list[dict]:
    return commands.grade(folder, SECRET, out, apart="nothing", **how)


def test_right_work_gets_all_a_slip_is_named_and_nothing_gets_nothing(course, tmp_path):
    first, second, third = graded(course, tmp_path)
    parts = [key for key in first if key not in ("id", "name", "total", "note")]
    assert first["total"] == len(parts)
    assert (second["p"], second["R"], second["J"]) == (0, 0, 1)
    assert (third["total"], third["note"]) == (0, "nothing was answered")
    words = (tmp_path / "cd34" / "feedback.html").read_text(encoding="utf-8")
    assert "Right in millimetres; metres were asked." in words
    assert "transpose" in words
    lines = list(csv.DictReader(io.StringIO((tmp_path / "grades.csv").read_text("utf-8"))))
    assert [line["name"] for line in lines] == ["Ada", "'=HYPERLINK(1)", "Émile"]
    results = json.loads((tmp_path / "ab12" / "results.json").read_text("utf-8"))
    assert results["score"] == sum(test["max_score"] for test in results["tests"]) == len(parts)


def test_few_digits_cost_a_little_and_joint_values_beyond_the_limits_count_for_nothing(course):
    sheet = store.load(course).sheet("ab12", SECRET)
    answers = right(sheet)
    answers["J"] = np.round(answers["J"], 2).tolist()
    found = {mark.part: mark for mark in mark_sheet(sheet, answers, store.Rules(digits=0.8))}
    assert found["J"].credit == 0.8
    bent = ELBOW.with_rows((*ELBOW.rows[:2], revolute(a="a_3", limits=(0, 3))))
    sheet = commands.variants.sheet(bent, "a seed", ["inverse kinematics"])
    half = sheet.parts["q"].value
    assert len(half) == 2
    target = np.array(sheet.drawn["inverse kinematics"]["target"])[:, 0]
    every = elbow(sheet.arm.with_rows(ELBOW.rows), target)
    assert len(every.q) == 4
    assert mark_sheet(sheet, {"q": half.tolist()}, store.Rules())[0].credit == 1
    in_degrees = {"q": np.degrees(half).round(2).tolist()}
    (degrees,) = mark_sheet(sheet, in_degrees, store.Rules())
    assert (degrees.credit, degrees.causes) == (0, ("ik.degrees",))
    (priced,) = mark_sheet(sheet, in_degrees, store.Rules(causes={"ik.degrees": 0.8}))
    assert priced.credit == 0.8
    (beyond,) = mark_sheet(sheet, {"q": every.q.tolist()}, store.Rules())
    assert beyond.credit < 1
    (alone,) = mark_sheet(sheet, {"q": every.q[every.q[:, 2] < 0].tolist()}, store.Rules())
    assert alone.credit == 0


def test_a_column_is_six_formulas_each_by_itself_or_in_a_row_of_its_own(course):
    sheet = store.load(course).sheet("ab12", SECRET)
    six = right(sheet)["J_column"]
    for answer, credit in ((six, 1), ([[x] for x in six], 1), ([*six[:5], "7"], 0), (six[:5], 0)):
        marks = mark_sheet(sheet, {"J_column": answer}, store.Rules())
        (found,) = (mark for mark in marks if mark.part == "J_column")
        assert found.credit == credit
    assert found.words == "Expected a list of six formulas."


def test_what_has_not_changed_is_not_marked_again_and_what_has_is(course, tmp_path, monkeypatch):
    graded(course, tmp_path)
    calls = []
    monkeypatch.setattr(commands, "mark_sheet", lambda *a: calls.append(a) or mark_sheet(*a))
    graded(course, tmp_path)
    assert not calls
    path = course / "ab12" / "answers.json"
    before = path.read_text(encoding="utf-8")
    path.write_text(before.replace("{", '{"late": 1, ', 1), encoding="utf-8")
    graded(course, tmp_path)
    path.write_text(before, encoding="utf-8")
    assert len(calls) == 1


def test_several_jobs_give_the_same_marks(course, tmp_path):
    assert graded(course, tmp_path / "two", jobs=2) == graded(course, tmp_path / "one")


def test_a_sheet_is_signed_and_another_secret_finds_out(course):
    made = store.load(course)
    with pytest.raises(ArmError, match="was changed, or the secret is another"):
        made.sheet("ab12", b"another secret, long enough")
    text = (course / "course.json").read_text("utf-8")
    data = json.loads(text)
    data["sheets"]["ab12"]["values"]["d_1"] += 0.001
    (course / "course.json").write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(ArmError, match="'ab12' was changed"):
        store.load(course).sheet("ab12", SECRET)
    (course / "course.json").write_text(text, encoding="utf-8")
    with pytest.raises(ArmError, match="'zz' is not in this course"):
        made.sheet("zz", SECRET)


def test_seeds_differ_by_student_course_and_secret_and_are_hmacs():
    import hashlib
    import hmac

    text = b"4:seed10:Homework 14:ab12"
    assert (
        secrets.seed(SECRET, "ab12", "Homework 1")
        == hmac.digest(SECRET, text, hashlib.sha256).hex()
    )
    seeds = {
        secrets.seed(s, i, c) for s in (SECRET, b"x" * 16) for i in ("a", "ab") for c in ("b", "")
    }
    assert len(seeds) == 8


def test_a_growing_roster_keeps_sheets_and_begun_notebooks(course, tmp_path):
    folder = tmp_path / "hw"
    commands.new(ROSTER[:1], SECRET, ELBOW, folder)
    (folder / "ab12" / "homework.ipynb").write_text("begun", encoding="utf-8")
    before = store.load(folder).sheets["ab12"]
    commands.new(ROSTER, SECRET, ELBOW, folder)
    assert store.load(folder).sheets["ab12"] == before
    assert (folder / "ab12" / "homework.ipynb").read_text(encoding="utf-8") == "begun"
    with pytest.raises(ArmError, match="choose another folder"):
        commands.new(ROSTER, SECRET, UR10E, folder)


def test_the_notebook_is_valid_and_runs_to_an_untouched_answers_file(course, tmp_path):
    book = nbformat.read(course / "ef56" / "homework.ipynb", as_version=4)
    nbformat.validate(book)
    code = [cell.source for cell in book.cells if cell.cell_type == "code"]
    names = re.findall(r"^answer_(\w+) = \.\.\.$", "\n".join(code), re.M)
    assert names == list(store.load(course).sheet("ef56", SECRET).parts)
    script = tmp_path / "run.py"
    text = "\n".join(code).replace("answer_p = ...", "answer_p = [1, '2', np.pi]")
    script.write_text(text, encoding="utf-8")
    subprocess.run([sys.executable, script], cwd=tmp_path, check=True)
    written = (tmp_path / "answers.json").read_text(encoding="utf-8")
    assert json.loads(written) == {"p": [1, "2", np.pi]}


def test_pages_need_nothing_from_elsewhere_and_show_names_as_text(course):
    page = (course / "cd34" / "homework.html").read_text("utf-8")
    assert "<math" in page
    assert "data:image/svg+xml" in page
    assert not re.search(r'(src|href)="(?!data:)', page)
    assert "$" not in re.sub(r"<[^>]*>", "", page)


@pytest.mark.parametrize("arm", [*ARMS, PANDA.lock(3), MINE], ids=lambda arm: arm.name)
def test_an_arm_survives_json(arm):
    assert arms.from_json(json.loads(json.dumps(arms.to_json(arm)))) == arm


@pytest.mark.parametrize(
    "answers",
    [
        '{"p": ' + "[" * 9000 + "]" * 9000 + "}",
        '{"p": "' + "(" * 1900 + '"}',
        '{"p": "9**9**9**9", "R": "__import__(\'os\').system(\'true\')", "J": {"a": [NaN]}}',
        '{"p": [1e999, null, true], "q": [[{}]], "table": [["a"]], "J_column": ["q_1)", 1, 2, 3]}',
        "[1, 2]",
        "{",
        "\x00",
    ],
)
def test_a_hostile_answers_file_costs_its_own_parts(course, tmp_path, answers):
    path = course / "ef56" / "answers.json"
    path.write_text(answers, encoding="utf-8")
    rows = graded(course, tmp_path)
    path.unlink()
    assert rows[0]["total"] == len(rows[0]) - 4
    assert rows[2]["total"] == 0


def notebook(folder: Path, *cells: str) -> Path:
    """A notebook of code cells in a folder of its own."""
    folder.mkdir(parents=True, exist_ok=True)
    found = [
        {
            "cell_type": "code",
            "execution_count": None,
            "metadata": {},
            "outputs": [],
            "source": cell,
        }
        for cell in cells
    ]
    path = folder / "my homework.ipynb"
    path.write_text(
        json.dumps({"cells": found, "metadata": {}, "nbformat": 4, "nbformat_minor": 4}),
        encoding="utf-8",
    )
    return folder


needs_bubblewrap = pytest.mark.skipif(
    sandbox.best_apart() != "bubblewrap", reason="bubblewrap is not installed or does not work here"
)
LIMITS = sandbox.Limits(notebook=120, cell=8)  # a busy machine takes 3 s over an import


@needs_bubblewrap
def test_a_notebook_run_apart_sees_nothing_and_an_endless_or_failing_cell_costs_itself(tmp_path):
    (tmp_path / "secret.txt").write_text("key", encoding="utf-8")
    look = (
        "import os, pathlib, time\n"
        f"answer_files = os.path.exists({str(tmp_path)!r})\n"
        "answer_names = [n for n in os.environ if 'SECRET' in n]\n"
        "answer_net = len(os.listdir('/sys/class/net')) if os.path.exists('/sys') else 0\n"
        "try:\n    pathlib.Path('/usr/mark').write_text('x')\nexcept OSError as error:\n"
        "    answer_write = type(error).__name__"
    )
    cells = ["answer_p = [1, 2]", look, "1 / 0", "time.sleep(1e6)", "answer_J = 4"]
    found = read_hand_in(notebook(tmp_path / "s", *cells), "bubblewrap", LIMITS)
    seen = {"files": False, "names": [], "net": 0, "write": "OSError"}
    assert dict(found.answers) == {"p": [1, 2], **seen, "J": 4}
    assert found.trouble == "2 of its cells raised an error"


@needs_bubblewrap
def test_a_kernel_that_dies_gives_no_answers_and_words(tmp_path):
    cells = "answer_p = 1", "import os\nos._exit(0)"
    found = read_hand_in(notebook(tmp_path, *cells), "bubblewrap", LIMITS)
    assert not found.answers
    assert "running it gave no result" in found.trouble


def cells(*printed, error=False):
    failing = [{"outputs": [{"output_type": "error"}]}] if error else []
    first, *more = [*printed, ""]
    outputs = [{"name": "stdout", "text": text} for text in (first, more)]
    outputs.insert(1, {"name": "stderr", "text": "x"})
    return json.dumps({"cells": [*failing, *failing, {"outputs": outputs}]}).encode()


@pytest.mark.parametrize(
    ("executed", "ran"),
    [
        (cells("1\n", f"{sandbox._MARK} ", '{"p": 1}'), ({"p": 1}, "")),
        (cells(f'{sandbox._MARK}{{"p": 1}}', error=True), ({"p": 1}, "2 of its cells raised an")),
        (cells(f"{sandbox._MARK}[1]"), (None, "its answers could not be read")),
        (cells(f"{sandbox._MARK}{{"), (None, "its answers could not be read")),
        (cells("1"), (None, "its kernel stopped before the end")),
        (b"{", (None, "running it gave no result")),
        (b'{"cells": []}', (None, "running it gave no result")),
    ],
)
def test_the_answers_stand_in_the_last_cell(executed, ran):
    found = sandbox._read(executed)
    assert found.answers == ran[0]
    assert found.trouble.startswith(ran[1])
    assert bool(found.trouble) == bool(ran[1])


def test_progress_is_counted_on_a_terminal_alone(monkeypatch, capsys):
    assert list(commands._progress("ab", "sheets")) == ["a", "b"]
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    assert list(commands._progress(iter("abc"), "students", 3)) == ["a", "b", "c"]
    ten, dot = "#" * 10, "." * 10
    bars = (f"{ten}{dot}{dot}] 1", f"{ten}{ten}{dot}] 2", f"{ten}{ten}{ten}] 3")
    told = "".join(f"\r[{bar} of 3 students" for bar in bars) + "\n"
    assert capsys.readouterr().err == told


def test_what_other_systems_run_is_well_formed(course, tmp_path):
    workflow = yaml.safe_load(autograders.CLASSROOM)
    (job,) = workflow["jobs"].values()
    assert [step["run"].split()[2] for step in job["steps"] if "run" in step] == [
        "pip",
        "helpers.course",
    ]
    assert workflow[True] == ["push", "workflow_dispatch"]  # YAML 1.1 reads `on` as a truth
    autograders.gradescope_zip(store.load(course), tmp_path / "a.zip")
    with zipfile.ZipFile(tmp_path / "a.zip") as file:
        for script in ("setup.sh", "run_autograder"):
            done = subprocess.run(["bash", "-n"], input=file.read(script), check=False)
            assert done.returncode == 0, script


def test_nothing_is_run_without_leave(tmp_path, monkeypatch):
    folder = notebook(tmp_path, "answer_p = 1")
    assert "not run without leave" in read_hand_in(folder, "nothing").trouble
    monkeypatch.setattr(sandbox.os, "geteuid", lambda: 0)
    assert "the superuser runs no notebook" in read_hand_in(folder, "process").trouble


def test_what_lies_in_a_folder_is_told(tmp_path):
    assert read_hand_in(tmp_path, "nothing").trouble == "nothing was handed in"
    (tmp_path / "a.ipynb").write_text("{", encoding="utf-8")
    (tmp_path / "b.ipynb").write_text("{", encoding="utf-8")
    assert "there are 2 notebooks (a.ipynb, b.ipynb)" in read_hand_in(tmp_path, "nothing").trouble
    (tmp_path / "answers.json").symlink_to("/etc/hostname")
    assert "is no ordinary file" in read_hand_in(tmp_path, "nothing").trouble


def test_answers_keep_what_was_typed(tmp_path):
    import sympy as sp

    names = {"answer_J": np.array([[0.5, 0.25]]), "answer_f": sp.Matrix([sp.sin(sp.Symbol("q_1"))])}
    names |= {"answer_arm": MINE, "answer_none": None, "answer_dots": ..., "other": 1}
    hand_in(names, tmp_path / "answers.json")
    found = json.loads((tmp_path / "answers.json").read_text(encoding="utf-8"))
    assert found["J"] == [[0.5, 0.25]]
    assert found["f"] == [["sin(q_1)"]]
    assert found["arm"][0] == ["0", "pi/2", "h", "0"]
    assert set(json.loads(collected(names))) == {"J", "f", "arm"}


CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (77),Other (78)\r\n"
    '"    Points Possible",,,,,10,5\r\n"Lovelace, Ada",1,x,ab12,A,,3\r\nNobody,2,y,zz,A,4,\r\n'
)


def test_canvas_and_moodle_exports_are_filled_and_nothing_else_is_touched():
    filled = list(
        csv.reader(io.StringIO(gradebook.fill_canvas(CANVAS, {"ab12": 6.5}, "Homework 1")))
    )
    before = list(csv.reader(io.StringIO(CANVAS)))
    assert filled[2][5] == "6.5"
    filled[2][5] = ""
    assert filled == before
    head = 'Identifier,"Full name","Email address",Grade,"Maximum Grade","Last modified (grade)"'
    moodle = (
        f"{head}\r\nParticipant 1,Ada,ab12@a.example,,20.00,-\r\nParticipant 2,B,b@x,,20.00,-\r\n"
    )
    rows = list(csv.reader(io.StringIO(gradebook.fill_moodle(moodle, {"ab12": 6.5}, 13))))
    assert [row[3] for row in rows[1:]] == ["10.00", ""]
    with pytest.raises(ArmError, match="0 columns called 'Homework 2'; expected one"):
        gradebook.fill_canvas(CANVAS, {}, "Homework 2")
    with pytest.raises(ArmError, match="expected Identifier"):
        gradebook.fill_moodle("Name,Grade\r\n", {}, 1)


@pytest.mark.parametrize("name", ["=1+1", "+1", "-1", "@x", "\tx", "|x", "%x"])
def test_no_cell_is_a_formula(name):
    text = gradebook.table([gradebook.grade_row("a", name, [Mark("p", 1, "", "")], "")])
    assert next(csv.DictReader(io.StringIO(text)))["name"] == f"'{name}"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("id,name\n../x,A\n", r"line 2: id is '\.\./x'"),
        ("id,name\nab,A\nAB,B\n", "line 3: id 'AB' stands in line 2 already"),
        ("id,name\nnul.x,A\n", "Windows keeps"),
        ("student,name\nab,A\n", "has the columns student, name; expected id and name"),
        ("id,name\n", "holds no student"),
    ],
)
def test_a_roster_that_cannot_be_used_is_told_by_its_line(tmp_path, text, words):
    path = tmp_path / "roster.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ArmError, match=words):
        read_roster(path)


def test_gradescope_marks_in_a_folder_laid_out_like_its_own(course, tmp_path):
    autograders.gradescope_zip(store.load(course), tmp_path / "autograder.zip")
    with zipfile.ZipFile(tmp_path / "autograder.zip") as file:
        assert {"setup.sh", "run_autograder", "course.json"} <= set(file.namelist())
        assert file.getinfo("run_autograder").external_attr >> 16 & 0o111
        assert SECRET not in b"".join(file.read(name) for name in file.namelist())
        file.extractall(tmp_path / "source")
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission" / "answers.json").write_bytes(
        (course / "ab12" / "answers.json").read_bytes()
    )
    about = {"users": [{"email": "AB12@school.example", "name": "Ada L", "id": 9}]}
    (tmp_path / "submission_metadata.json").write_text(json.dumps(about), encoding="utf-8")
    subprocess.run(
        [sys.executable, "-m", "helpers.course.autograders", str(tmp_path)],
        cwd=tmp_path / "source" / "package", check=True,
    )  # fmt: skip
    results = json.loads((tmp_path / "results" / "results.json").read_text(encoding="utf-8"))
    assert results["score"] == len(results["tests"]) > 5
    assert {test["status"] for test in results["tests"]} == {"passed"}
    (tmp_path / "submission_metadata.json").write_text(
        '{"users": [{"email": "x@y"}]}', encoding="utf-8"
    )
    assert "belongs to your name" in autograders.run_gradescope(tmp_path)["output"]


def test_nbgraders_cells_carry_what_it_reads_and_give_the_credit(course):
    sheet = store.load(course).sheet("ab12", SECRET)
    book = autograders.nbgrader_notebook(store.load(course), sheet)
    nbformat.validate(nbformat.from_dict(book))
    tests = [cell for cell in book["cells"] if cell["id"].startswith("test-")]
    assert len(tests) == len(sheet.parts)
    names = {"answer_" + name: value for name, value in right(sheet).items()}
    for cell in tests:
        about = cell["metadata"]["nbgrader"]
        assert (about["grade"], about["locked"], about["points"]) == (True, True, 1)
        *lines, last = cell["source"].replace("### END HIDDEN TESTS", "").strip().splitlines()
        space = dict(names)
        exec("\n".join(lines), space)
        assert eval(last, space) == 1
    part = next(cell for cell in book["cells"] if "answer_p: " in cell["source"])
    assert part["metadata"]["nbgrader"] == {
        "grade": False, "solution": True, "task": False, "locked": False, "schema_version": 3,
        "grade_id": part["id"],
    }  # fmt: skip
    first, *lines = part["source"].splitlines()
    assert first.startswith("# answer_p: ")
    assert lines == ["### BEGIN SOLUTION", "answer_p = None", "### END SOLUTION"]


NEEDED = {
    "new": "--roster r.csv --secret s --arm Panda --out hw",
    "key": "--secret s --id ab12",
    "grade": "hw --secret s --out o",
    "gradescope": "hw --secret s --out o",
    "nbgrader": "hw --secret s --id ab12 --out o",
    "look": "hw",
    "classroom": "--out o",
}


@pytest.mark.parametrize(
    ("line", "read"),
    [
        ("new", {"lock": [], "title": "Homework", "topic": None, "digits": 0.9, "columns": 1.0,
                 "cause": [], "roster": "r.csv", "secret": "s", "arm": "Panda",
                 "out": Path("hw")}),
        ("new --lock 3 --lock 5 --title T --digits 0.5 --columns 0 --cause a=1 --cause b=0"
         " --topic Jacobian", {"lock": [3, 5], "title": "T", "digits": 0.5, "columns": 0.0,
                               "cause": ["a=1", "b=0"], "topic": ["Jacobian"]}),
        ("key", {"secret": "s", "id": "ab12", "course": Path("hw")}),
        ("key --course c", {"course": Path("c")}),
        ("grade", {"course": Path("hw"), "secret": "s", "out": Path("o"), "jobs": 1, "seconds": 120,
                   "unprotected": False, "as_root": False, "canvas": None, "moodle": None}),
        ("grade --jobs 2 --seconds 5 --unprotected --as-root --canvas c --moodle m",
         {"jobs": 2, "seconds": 5, "unprotected": True, "as_root": True, "canvas": Path("c"),
          "moodle": Path("m")}),
        ("gradescope", {"course": Path("hw"), "secret": "s", "out": Path("o")}),
        ("nbgrader", {"course": Path("hw"), "secret": "s", "id": "ab12", "out": Path("o")}),
        ("look", {"folder": Path("hw")}),
        ("classroom", {"out": Path("o")}),
    ],
)  # fmt: skip
def test_the_command_line_is_read(line, read):
    command, *more = line.split()
    found = vars(commands._parser().parse_args([command, *NEEDED[command].split(), *more]))
    assert {name: found[name] for name in read} == read
    assert found["run"] is getattr(commands, f"_{command}")


@pytest.mark.parametrize("command", NEEDED)
def test_each_command_asks_for_what_it_needs_and_explains_it(command, capsys):
    words = NEEDED[command].split()
    needed = [k for k, word in enumerate(words) if word.startswith("--")]
    for without in (words[:k] + words[k + 2 :] for k in needed):
        with pytest.raises(SystemExit, match="2"):
            commands._parser().parse_args([command, *without])
    with pytest.raises(SystemExit, match="0"):
        commands._parser().parse_args([command, "--help"])
    told = capsys.readouterr().out.partition("\n\n")[2]
    assert not re.findall(r"^  \S+( [A-Z=]+)?\n(?! {10})", told, re.M)
    assert not {"None", "XX"} & {*re.findall(r"None|XX", told)}


def test_the_words_of_the_command_line(course, tmp_path, capsys):
    (tmp_path / "secret.txt").write_bytes(SECRET + b"\n")
    (tmp_path / "roster.csv").write_text("id,name\nab12,Ada\n", encoding="utf-8")
    (tmp_path / "arm.py").write_text("from tests.test_course import MINE\n", encoding="utf-8")
    common = ["--secret", str(tmp_path / "secret.txt")]
    new = ["new", "--roster", str(tmp_path / "roster.csv"), *common, "--out", str(tmp_path / "hw")]
    assert main([*new, "--arm", f"{tmp_path}/arm.py:MINE"]) == 0
    assert main(["key", *common, "--id", "ab12", "--course", str(tmp_path / "hw")]) == 0
    assert "**Key: Inverse kinematics**" in capsys.readouterr().out
    assert main(["grade", str(tmp_path / "hw"), *common, "--out", str(tmp_path / "out")]) == 0
    assert main(["look", str(course / "ab12")]) == 0
    assert "p: 1" in capsys.readouterr().out
    assert main([*new, "--arm", "Pandabear"]) == 2
    assert "no arm is called 'Pandabear'; expected one of Panda," in capsys.readouterr().err
    assert main(["key", "--secret", str(tmp_path / "none"), "--id", "ab12"]) == 2
    assert "cannot be read" in capsys.readouterr().err


ASKED = [PANDA, PANDA.lock(3), UR10E, ELBOW, MINE]


@pytest.mark.parametrize("arm", ASKED, ids=lambda arm: f"{arm.name}, {arm.dof} joints")
def test_right_work_on_a_sheet_that_goes_out_gets_all(arm, tmp_path):
    sheet = commands.new(ROSTER[:1], SECRET, arm, tmp_path).sheet("ab12", SECRET)
    prove(sheet)
    assert all(mark.credit == 1 for mark in mark_sheet(sheet, right(sheet), store.Rules()))
