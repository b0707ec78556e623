"""Test answer sheets: their formulas, programs and numbers against the numeric view.

The sheets derive formulas with SymPy. The expected numbers come from `helpers.kinematics` and
`helpers.statics`.
"""

import json
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from answers import displays, make_html_sheet, make_markdown_sheet
from answers.__main__ import main, make_file_stem
from answers.command_line import read_arm
from answers.content import AnswerSheet
from helpers import kinematics, robots, statics
from helpers.arm import Arm, ArmError, Body, fixed, prismatic, revolute
from helpers.derive import Axis, derive
from helpers.formulas import print_latex
from helpers.robots import ELBOW, PANDA
from helpers.urdf import from_urdf
from tools import answers

TOLERANCE = 1e-10  # lengths are printed with twelve digits

SKEWED = derive(
    [
        Axis((0, 0, 0), (0, 0.2, 1)),
        Axis((0.1, 0.2, 0.3), (1, 0.3, 0.2)),
        Axis(None, (0.3, 1, 0.1), "prismatic"),
    ],
    (0.7, 0.2, 0.5),
    name="skewed",
).with_bodies([1.0, 2.0, 0.5], [[0.1, 0, 0.1], [0.2, 0.1, 0], [0.3, 0, 0]])
NUMBERED = Arm("numbers only", [revolute(a=0.25, theta="pi/3"), prismatic(alpha="pi/4", d=1 / 3)])
ARMS = {page.name: page.arms[-1] for page in answers.PAGES}
SHEETS = {
    name: AnswerSheet(arm) for name, arm in {**ARMS, "skewed": SKEWED, "numbers": NUMBERED}.items()
}
PARALLEL = ["z_{7} = z_{6}", "z_{4} = z_{3}"]  # parallel axes of the Panda and of the skewed arm
every_arm = pytest.mark.parametrize("sheet", SHEETS.values(), ids=SHEETS)


@cache
def draw_configuration(sheet):
    """Return a random pose of an arm, the same for all its answers."""
    return tuple(np.random.default_rng(7).uniform(-3, 3, sheet.arm.dof).tolist())


def compute_expected(sheet, what, q):
    """Compute an answer at q by the numeric functions."""
    arm, index = sheet.arm, int("0" + re.sub(r"\D", "", what))
    frames = kinematics.link_frames(arm, q)
    answers_by_letter = {
        "A": lambda: np.linalg.inv(frames[index - 1]) @ frames[index],
        "T": lambda: frames[index],
        "o": lambda: frames[index][:3, 3],
        "z": lambda: frames[index][:3, 2],
        "J": lambda: kinematics.jacobian(arm, q),
        "d": lambda: np.linalg.det(kinematics.jacobian(arm, q)[: arm.dof]),
        "P": lambda: statics.potential_energy(arm, q),
        "G": lambda: statics.gravity_torque(arm, q),
    }
    return answers_by_letter[what[0]]()


def check_answer(sheet, what, got, q):
    expected = compute_expected(sheet, what, q)
    largest = max(1.0, np.abs(expected).max())
    got = np.reshape(np.asarray(got, float), np.shape(expected))
    np.testing.assert_allclose(got, expected, rtol=0, atol=TOLERANCE * largest)


def replace_joint_values(text, arm, q):
    """Replace the joint values of a block."""
    for variable, value in zip(arm.variables, q, strict=True):
        text = re.sub(rf"(?m)^{variable} = [^;\n]+", f"{variable} = {value!r}", text)
    return text


@cache
def page(sheet):
    """Return the arm's sheet, which is made once."""
    return make_markdown_sheet(sheet.arm, "A sheet", "Of an arm.")


@cache
def read_program(language, sheet, item):
    """Return the block that the page copies for an answer."""
    data = re.search(r'\n<script type="application/json">(.+)</script>\n', page(sheet))[1]
    return json.loads(data)[item.name.replace("_", "-").lower()][language]


def run_program(text):
    exec(text, names := {})
    return names


# Programs


@every_arm
def test_numpy_blocks_match_numeric_view(sheet, capsys):
    for item in sheet.answers:
        names = run_program(
            replace_joint_values(
                read_program("NumPy", sheet, item), sheet.arm, draw_configuration(sheet)
            )
        )
        check_answer(sheet, item.name, names[item.name], draw_configuration(sheet))
        assert capsys.readouterr().out


@every_arm
def test_numpy_blocks_hold_the_home_pose(sheet):
    """All blocks begin with the same joint values, so a single one is run."""
    home = np.array(sheet.arm.home)
    first, *others = (read_program("NumPy", sheet, item) for item in sheet.answers)
    check_answer(sheet, sheet.answers[0].name, run_program(first)[sheet.answers[0].name], home)
    for text in others:
        for variable, value in re.findall(r"(?m)^(q_\d+) = ([^\n#]+)", text):
            expected = home[sheet.arm.variables.index(variable)]
            assert eval(value, {"np": np}) == pytest.approx(expected, abs=1e-12)


@every_arm
def test_sympy_blocks_match_numeric_view(sheet):
    for item in sheet.answers:
        names = run_program(read_program("SymPy", sheet, item))
        letters = [sp.Symbol(name) for name in (*sheet.symbol_values, *sheet.arm.variables)]
        value = sp.Matrix([names[item.name]]) if item.is_number else names[item.name]
        got = sp.lambdify(letters, value)(*sheet.symbol_values.values(), *draw_configuration(sheet))
        check_answer(sheet, item.name, got, draw_configuration(sheet))


@every_arm
def test_matlab_blocks_match_numeric_view(sheet):
    """Each block is translated into Python, since MATLAB is rarely installed."""
    for item in sheet.answers:
        text = re.sub(r"\s*\.\.\.\n\s*", " ", read_program("MATLAB", sheet, item))
        assert not re.search(r"[^;\[]$", text, re.M)
        text = text.replace(".*", "*").replace(".^", "**").replace("^", "**")
        text = re.sub(r"(?s)= \[\n(.*)\n\];", r"= [[\1]]", text).replace(";\n    ", "], [")
        names = {"cos": np.cos, "sin": np.sin, "pi": np.pi}
        exec(
            replace_joint_values(text.replace(";]]", "]]"), sheet.arm, draw_configuration(sheet)),
            names,
        )
        check_answer(sheet, item.name, names[item.name], draw_configuration(sheet))


@every_arm
def test_program_lines_have_at_most_110_characters(sheet):
    for item in sheet.answers:
        for language in ("SymPy", "NumPy", "MATLAB"):
            assert max(map(len, read_program(language, sheet, item).splitlines())) <= 110, item.name


# Formulas to read


def read_entries(item, shown, elsewhere):
    """Return the TeX of an answer's entries as a reader finds them on the page.

    Continued lines are joined. A name in the matrix is replaced by its formula, which is in a line
    below the matrix or in `elsewhere`.
    """
    written = {}
    for display in shown:
        lines = re.sub(r" \\\\\n&\\quad ", " ", display).split(" \\\\\n")
        for line in lines:
            line = re.sub(r"\\(?:begin|end)\{aligned\}\n?|\n$", "", line)
            label, formula = re.split(r" &?= ", line, maxsplit=1)
            written[label] = formula.strip()
    whole = written.get(displays.format_name(item), "")
    if "matrix" not in whole:
        return [*map(strip_brackets, written.values())]
    inner = re.sub(r"\\left\[\\begin\{\w+\}(?:\{c+\})?|\\end\{\w+\}\\right\]", "", whole)
    found = [text.strip() for text in re.split(r"&|\\\\", inner)]
    return [strip_brackets((written | elsewhere).get(text, text)) for text in found]


def strip_brackets(tex):
    return re.sub(r"\\left|\\right| ", "", tex)


@every_arm
def test_displayed_formulas_are_complete(sheet):
    """Long parts of T_0i and J are under Axes and Origins, but the copied text must be complete."""
    vectors = {
        f"({displays.format_name(vector)})_{{{axis}}}": print_latex(x)
        for vector in (*sheet.axes, *sheet.origins)
        for axis, x in zip("xyz", vector.value, strict=True)
    }
    for item in sheet.answers:
        shown, whole = (
            displays.format_symbols(sheet, item),
            [strip_brackets(print_latex(x)) for x in item.value],
        )
        assert read_entries(item, shown, vectors) == whole or shown[0] in PARALLEL
        missing = [display for display in shown if f"$$\n{display}\n$$" not in page(sheet)]
        assert not missing, f"the page of {sheet.arm.name} lacks these formulas"
        copied = re.findall(r"(?s)\\\[\n(.*?)\n\\\]", read_program("LaTeX", sheet, item))
        assert read_entries(item, copied, {}) == whole


@every_arm
def test_matrices_are_displayed_as_matrices(sheet):
    """Long entries are replaced by names in a matrix. A long vector has one line per entry."""
    for item in sheet.answers:
        first, *below = displays.format_symbols(sheet, item)
        lines = item.value.cols == 1 and ("aligned" in first or first in PARALLEL)
        assert ("matrix" in first) != lines
        assert not re.search(r"t_{.[34]}|J_{[456]", "".join(below)), "under Axes and Origins"
        seen = re.sub(r"\\[a-z]+|[\s{}_^&]", "", first.split("\\\\")[0])
        assert len(seen) <= 75 or item.is_number


def test_latex_block_explains_abbreviations():
    sheet = SHEETS["ur10e_homework"]
    legend = "% $c_{1} = \\cos{(q_{1})}$\n% $s_{1} = \\sin{(q_{1})}$\n\\["
    assert read_program("LaTeX", sheet, sheet.axes[3]).startswith(legend)


@every_arm
def test_page_numbers_match_numeric_view(sheet):
    """The page shows four decimals at the home configuration."""
    for item in sheet.answers:
        shown = displays.format_numbers(item, item.home_values)
        assert f"In numbers:\n\n$$\n{shown}\n$$" in page(sheet)
        numbers = [float(text) for text in re.findall(r"-?[\d.]+", shown.split(" = ")[1])]
        expected = np.ravel(compute_expected(sheet, item.name, np.array(sheet.arm.home)))
        np.testing.assert_allclose(numbers, expected, rtol=0, atol=5.1e-5)


# Pages


def test_every_sheet_is_in_the_contents():
    toc = (answers.ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
    listed = set(re.findall(r"answers/(\w+)", toc))
    assert {page.name for page in answers.PAGES} == listed, (
        "add a line answers/NAME to book/_toc.yml"
    )


def test_every_arm_has_a_sheet():
    shown = {arm.name for page in answers.PAGES for arm in page.arms}
    assert {arm.name for arm in robots.ARMS} <= shown, (
        "add a SheetPage to PAGES of tools/answers.py"
    )


def test_sheets_are_rewritten_only_after_changes(tmp_path, monkeypatch):
    monkeypatch.setattr(answers, "page_markdown", lambda page: page.introduction)
    first, second = (tmp_path / f"{page.name}.md" for page in answers.PAGES[:2])
    answers.write_pages(tmp_path, "one")
    assert {path.stem for path in tmp_path.glob("*.md")} == {page.name for page in answers.PAGES}
    first.write_text("edited", "utf-8")
    answers.write_pages(tmp_path, "one")
    assert first.read_text("utf-8") == "edited"
    second.unlink()
    answers.write_pages(tmp_path, "one")
    first.write_text("edited", "utf-8")
    before = second.stat().st_mtime_ns
    answers.write_pages(tmp_path, "two")
    assert first.read_text("utf-8") == answers.PAGES[0].introduction
    assert second.stat().st_mtime_ns == before, "what is the same is left alone"
    assert {*(answers.ROOT / "answers/static").iterdir()} <= {*answers.list_sources()}


def test_sheet_page_has_title_and_answers():
    text = answers.page_markdown(answers.PAGES[5])
    assert text.startswith('---\nmyst:\n  html_meta:\n    description: "Elbow arm: every link ')
    assert "\n---\n\n# Elbow arm\n\nThe arm of three joints" in text
    assert text.count('<details class="answer"') == len(SHEETS["elbow"].answers)
    assert "<details open" not in text
    assert "What is 0, here $d$, is left out" in text
    assert "$c_{23} = \\cos{(q_{2} + q_{3})}$" in text


def test_other_arm_is_shown_where_numbers_differ():
    """The page shows numbers of both arms if they differ. At home, link 3 points along its -y."""
    text = make_markdown_sheet(
        ELBOW, "E", "L", (replace(ELBOW.with_values(a_3=0.35), name="longer"),)
    )
    shown = text.split('id="a-3"')[1].split("</details>")[0]
    assert "In numbers, Elbow arm:\n\n$$\nA_{3}" in shown
    assert "In numbers, longer:\n\n$$\nA_{3}" in shown
    assert "-0.35" in shown
    assert "In numbers:" in text.split('id="a-2"')[1].split("</details>")[0]


def test_document_is_one_self_contained_file():
    html = make_html_sheet(replace(NUMBERED, name="<b>bold & brave</b>"))
    assert "<b>bold" not in html
    assert "&lt;b&gt;bold &amp; brave" in html
    for path in (Path(displays.__file__).parent / "static").iterdir():
        assert path.read_text(encoding="utf-8") in html
    assert not re.search(r"""(?:src|href)=["']""", html)
    assert "$" not in re.sub(r"(?s)<script.*?</script>", "", html)
    assert html.count("<math") > html.count('<details class="answer"') > 8
    assert re.findall("<h2>(.*?)</h2>", html) == [
        "Table", "Link matrices", "Frames seen from the base", "Origins", "Axes", "Jacobian",
    ]  # fmt: skip


def test_determinant_states_its_factors():
    assert "It falls into 2 factors that depend" in page(SHEETS["elbow"])
    assert "It falls into 3 factors that depend" in page(SHEETS["ur10e"])
    assert "it does not fall into factors" in page(SHEETS["panda_joint_3_locked"])
    assert "This one is 0 everywhere." in make_markdown_sheet(
        Arm("flat", [revolute(a=1)] * 3), "F", "L"
    )


def test_zero_masses_are_listed():
    arm = Arm("light", [revolute(a=1)], bodies=[Body(0, (0, 0, 0))])
    assert "| 1 | 0 | 0 | 0 | 0 |" in make_markdown_sheet(arm, "L", "L")


# The command line


def test_command_writes_a_file(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    main(["elbow arm"])
    assert capsys.readouterr().out == "elbow_arm_answers.html\n"
    assert [make_file_stem(name) for name in ("UR10e (homework)", "…")] == ["ur10e_homework", "arm"]
    assert "Elbow arm" in (tmp_path / "elbow_arm_answers.html").read_text(encoding="utf-8")


def test_command_takes_base_tip_and_out(tmp_path, capsys):
    kinds = zip("abcd", ["continuous"] * 3 + ["fixed"], "bcde", strict=True)
    joints = "".join(
        f'<joint name="{a}" type="{kind}"><parent link="{a}"/><child link="{b}"/>'
        '<origin xyz="1 0 0"/></joint>'
        for a, kind, b in kinds
    )
    links = "".join(f'<link name="{name}"/>' for name in "abcde")
    (tmp_path / "one.urdf").write_text(f'<robot name="öne">{links}{joints}</robot>', "utf-8")
    out, file = tmp_path / "sheet.html", str(tmp_path / "one.urdf")
    main([file, "--base", "b", "--tip", "d", "--out", str(out)])
    assert capsys.readouterr().out == f"{out}\n"
    assert out.read_text(encoding="utf-8") == make_html_sheet(from_urdf(file, "b", "d"))
    assert from_urdf(file, "b", "d") not in (from_urdf(file, "b"), from_urdf(file, None, "d"))


def test_command_puts_arm_on_base_with_tool(tmp_path):
    out = tmp_path / "sheet.html"
    main(
        [
            "two links",
            "--base-pose=0,0,0.75,0,0,0",
            "--tool-pose=0,0,-0.125,0,pi/2,0",
            f"--out={out}",
        ]
    )
    text = out.read_text(encoding="utf-8")
    assert "0.75" in text
    assert "0.125" in text


def test_command_reads_arm_from_file_or_explains(tmp_path):
    path = tmp_path / "arm.py"
    path.write_text("from helpers.robots import UR10E\nOTHER = 3\n", encoding="utf-8")
    assert read_arm(f"{path}:UR10E").name == "UR10e"
    for words, said in (
        (f"{path}:OTHER", f"OTHER of {path} is 3; expected an Arm"),
        ("no.py:A", "no.py is not there; expected a Python file, as in my_arm.py:ARM"),
        ("Puma", "no arm is called 'Puma'; expected one of"),
    ):
        with pytest.raises(SystemExit, match=re.escape(said)):
            main([words])


# Refused arms and symbols


@pytest.mark.parametrize(
    "letter", ["np", "J", "end", "c_1", "T_03", "x_c2", "q_9", "g", "A_1", "Matrix"]
)
def test_reserved_symbol_is_rejected(letter):
    with pytest.raises(ArmError, match=f"has a letter called {letter}, which a program"):
        AnswerSheet(Arm("mine", [revolute(a=letter)], {letter: 1.0}))


def test_arm_without_joints_is_rejected():
    with pytest.raises(ArmError, match="arm is 'Panda'; expected an Arm"):
        AnswerSheet("Panda")
    with pytest.raises(ArmError, match="post has no joints; a sheet needs an arm that moves"):
        make_html_sheet(Arm("post", [fixed(a=1)]))


def test_other_arm_needs_the_same_rows():
    with pytest.raises(ArmError, match="Panda has other rows than Elbow arm; expected other value"):
        make_markdown_sheet(ELBOW, "Elbow", "An arm.", (PANDA,))
