"""Every formula that an answer sheet prints, in each of its languages, against the numeric view.

The formulas come from SymPy's polynomials, the numbers they are held against from
`helpers.kinematics` and `helpers.statics`.
"""

import importlib.util
import math
import re
import shutil
import string
import subprocess
import sys
from dataclasses import replace
from functools import cache
from html import unescape
from html.parser import HTMLParser
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from helpers import kinematics, statics
from helpers.arm import Arm, ArmError, Body, prismatic, revolute
from helpers.command_line import read_arm
from helpers.derive import Axis, derive
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.sheets import block, document, formulas, markdown, page
from helpers.sheets.__main__ import main, slug
from helpers.sheets.content import Item, Sheet
from helpers.sheets.page import answer, sections
from helpers.sheets.programs import as_latex, as_matlab, latex_title
from helpers.urdf import from_urdf

ROOT = Path(__file__).parents[1]
TOLERANCE = 1e-10  # letters are printed with twelve digits

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
SHEETS = {
    sheet.arm.name: sheet
    for sheet in (
        Sheet(PANDA),
        Sheet(replace(PANDA.lock(3), name="Panda, joint 3 locked")),
        Sheet(UR10E_HOMEWORK),
        Sheet(UR10E),
        Sheet(STANFORD),
        Sheet(ELBOW),
        Sheet(replace(ELBOW.with_values(d=0.1), name="elbow with an offset")),
        Sheet(SKEWED),
        Sheet(NUMBERED),
    )
}
every_arm = pytest.mark.parametrize("sheet", SHEETS.values(), ids=SHEETS)


@cache
def pose(sheet):
    """A random pose, the same for all answers of an arm."""
    name, dof = sheet.arm.name, sheet.arm.dof
    return tuple(map(float, np.random.default_rng(len(name)).uniform(-3, 3, dof)))


def true(sheet, what, q):
    """What the numeric view says of an answer at q."""
    arm, letter, index = sheet.arm, what[0], int("0" + re.sub(r"\D", "", what))
    frames = kinematics.link_frames(arm, q)
    match letter:
        case "A":
            return np.linalg.inv(frames[index - 1]) @ frames[index]
        case "T":
            return frames[index]
        case "o":
            return frames[index][:3, 3]
        case "z":
            return frames[index][:3, 2]
        case "J":
            return kinematics.jacobian(arm, q)
        case "d":
            return np.linalg.det(kinematics.jacobian(arm, q)[: arm.dof])
        case "P":
            return statics.potential_energy(arm, q)
        case "G":
            return statics.gravity_torque(arm, q)


def check(sheet, what, got, q):
    expected = true(sheet, what, q)
    largest = max(1.0, np.abs(expected).max())
    got = np.reshape(np.asarray(got, float), np.shape(expected))
    np.testing.assert_allclose(got, expected, rtol=0, atol=TOLERANCE * largest)


def moved(text, arm, q):
    """A block with other joint values put in, where it gives them."""
    for variable, value in zip(arm.variables, q, strict=True):
        text = re.sub(rf"(?m)^{variable} = [^;\n]+", f"{variable} = {value!r}", text)
    return text


@cache
def in_page(sheet, item):
    """An answer as it stands in the page; it takes longer to make than to read."""
    return answer(sheet, item)


@cache
def given(language, sheet, item):
    """The block that the page has to copy for an answer."""
    found = re.search(rf'(?s)<template data-language="{language}">(.*?)<', in_page(sheet, item))
    return unescape(found[1])


def run(text):
    names = {}
    exec(compile(text, "pasted", "exec"), names)
    return names


# Programs


@every_arm
def test_numpy_blocks_run_as_they_are(sheet, capsys):
    for item in sheet.items:
        names = run(given("NumPy", sheet, item))
        check(sheet, item.name, names[item.name], sheet.home)
        assert capsys.readouterr().out


@every_arm
def test_numpy_blocks_at_another_pose(sheet, capsys):
    for item in sheet.items:
        names = run(moved(given("NumPy", sheet, item), sheet.arm, pose(sheet)))
        check(sheet, item.name, names[item.name], pose(sheet))


@every_arm
def test_sympy_blocks(sheet):
    for item in sheet.items:
        names = run(given("SymPy", sheet, item))
        letters = [sp.Symbol(name) for name in (*sheet.values, *sheet.arm.variables)]
        value = sp.Matrix([names[item.name]]) if item.is_number else names[item.name]
        got = sp.lambdify(letters, value)(*sheet.values.values(), *pose(sheet))
        check(sheet, item.name, got, pose(sheet))


def test_matlab_blocks_run_under_octave(tmp_path):
    """All of them, as they are and at another pose, in one run; MATLAB itself reads the same."""
    octave = shutil.which("octave-cli") or shutil.which("octave")
    if not octave:
        pytest.skip("GNU Octave is not installed here")
    cases = [
        (sheet, item, q)
        for sheet in SHEETS.values()
        for item in sheet.items
        for q in (sheet.home, pose(sheet))
    ]
    lines = ["1;"]
    for sheet, item, q in cases:
        block = given("MATLAB", sheet, item)
        block = block if q is sheet.home else moved(block, sheet.arm, q)
        shown = f"value = reshape({item.name}.', 1, []);"
        lines += ["clear all", block, shown, 'printf("= %s\\n", sprintf("%.17g ", value));']
    script = tmp_path / "blocks.m"
    script.write_text("\n".join(lines), encoding="utf-8")
    told = subprocess.run([octave, "--no-gui", "--quiet", script], capture_output=True, text=True)
    assert told.returncode == 0, told.stderr[-2000:]
    results = re.findall(r"(?m)^= ([-\d].*)$", told.stdout)
    for (sheet, item, q), line in zip(cases, results, strict=True):
        check(sheet, item.name, [float(x) for x in line.split()], q)


def test_no_line_of_a_program_is_long():
    answers = [(sheet, item) for sheet in SHEETS.values() for item in sheet.items]
    for sheet, item in answers:
        for language in ("SymPy", "NumPy", "MATLAB"):
            assert max(map(len, given(language, sheet, item).splitlines())) <= 160, (
                sheet.arm.name,
                item.name,
            )


# Formulas to read


def formula(text, powers):
    """The value-giving Python of a formula in HTML or LaTeX: what stands side by side is
    multiplied.
    """
    text = text.replace("−", "-").replace("π", "pi").replace("√", "sqrt")
    text = re.sub(powers, r"**\1", text)
    tokens = re.findall(r"\*\*\d+|(?:cos|sin|sqrt)(?=\()|[A-Za-z]\w*|\d+(?:\.\d+)?|[-+/()]", text)
    joined = ""
    for before, token in zip(["", *tokens], tokens, strict=False):
        ends = re.match(r"\w|\)|\*\*", before[:2]) and before not in ("cos", "sin", "sqrt")
        joined += f"*{token}" if ends and re.match(r"\w|\(", token) else token
    return joined


@cache
def readable(sheet, q):
    """A number for every letter of a formula, the short names as they are read off the page."""
    names = {**sheet.values, **dict(zip(sheet.arm.variables, q, strict=True))}
    names |= {n.name: complex(f.subs(names)).real for f, n in sheet.short_names.items()}
    names |= {"cos": math.cos, "sin": math.sin, "sqrt": math.sqrt, "pi": math.pi}
    return {re.sub(r"[{}+]", "", key).replace("-", "m"): value for key, value in names.items()}


class Entries(HTMLParser):
    """The formulas of an answer's page, without its name and its numbers, as plain text with the
    indices marked.
    """

    def __init__(self, html):
        super().__init__()
        self.entries, self.tags, self.text = [], [], ""
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs).get("class", "")))
        self.text += {"sub": "_<", "sup": "^<"}.get(tag, "")
        if tag in ("td", "p"):
            self.text = ""

    def handle_endtag(self, tag):
        inside = [name for _, name in self.tags]
        self.tags.pop()
        self.text += ">" if tag in ("sub", "sup") else ""
        if tag == "td" and "matrix" in inside:
            self.entries.append(self.text)
        if tag == "p" and "entries" in inside:
            self.entries.append(self.text.split("=", 1)[1])

    def handle_data(self, data):
        if "template" not in [tag for tag, _ in self.tags]:
            self.text += data


def indices(text):
    """A letter and its index in one name: c_<2−3> becomes c_2m3."""
    name = lambda m: "_" + m[1].replace("−", "m").replace("-", "m").replace("+", "")  # noqa: E731
    text = re.sub(r"_<([^>]*)>", name, text)
    greek = {"α": "alpha", "φ": "phi"}
    return re.sub("[αφ]", lambda m: greek[m[0]], text)


@every_arm
def test_what_the_page_shows(sheet):
    for item in sheet.items:
        entries = Entries(in_page(sheet, item)).entries
        names = readable(sheet, pose(sheet))
        values = [eval(formula(indices(text), r"\^<(\d+)>"), {}, names) for text in entries]
        check(sheet, item.name, values, pose(sheet))


@every_arm
def test_latex_blocks(sheet):
    for item in sheet.items:
        block = given("LaTeX", sheet, item)
        assert block.count("{") == block.count("}")
        assert block.isascii()
        body = "\n".join(line for line in block.splitlines() if not line.startswith("%"))
        body = re.sub(r"\\tfrac\{(\d+)\}\{(\d+)\}", r"(\1/\2)", body)
        body = re.sub(r"\\sqrt\{(\d+)\}", r"sqrt(\1)", body)
        body = re.sub(r"_\{\\mathrm\{(\w+)\}\}", r"_<\1>", body)
        body = re.sub(r"_\{([^{}]*)\}", r"_<\1>", body)
        body = re.sub(r"\\(alpha|phi|cos|sin|pi|sqrt)\b", r"\1", body)
        if "bmatrix" in body:
            inner = body.split(r"\begin{bmatrix}")[1].split(r"\end{bmatrix}")[0]
            entries = re.split(r"&|\\\\", inner)
        else:
            inner = body.split(r"\begin{align*}")[1].split(r"\end{align*}")[0]
            joined = re.sub(r"\\\\\s*&\\quad", " ", inner)
            entries = [line.split("&=")[1] for line in joined.split("\\\\")]
        names = readable(sheet, pose(sheet))
        values = [eval(formula(indices(text), r"\^\{(\d+)\}"), {}, names) for text in entries]
        check(sheet, item.name, values, pose(sheet))
        for short, function in sheet.used(item)[2]:
            assert function.subs(dict(zip(sheet.arm.variables, pose(sheet), strict=True))).is_number
            assert short.name.replace("{", "").replace("}", "") in re.sub(r"[{}]", "", block)


def test_latex_compiles_and_fits_the_page(tmp_path):
    """Every block of the book's arms in one document, with amsmath and nothing else; no line is too
    wide.
    """
    latex = shutil.which("pdflatex")
    if not latex:
        pytest.skip("LaTeX is not installed here")
    sheets = [SHEETS[name] for name in SHEETS if name not in ("skewed", "numbers only")]
    blocks = "\n\n".join(given("LaTeX", sheet, item) for sheet in sheets for item in sheet.items)
    head = r"\documentclass[a4paper]{article}\usepackage{amsmath}\begin{document}"
    text = "\n".join([head, blocks, r"\end{document}"])
    (tmp_path / "answers.tex").write_text(text, encoding="utf-8")
    call = [latex, "-interaction=nonstopmode", "-halt-on-error", "answers.tex"]
    assert subprocess.run(call, cwd=tmp_path, capture_output=True).returncode == 0
    log = (tmp_path / "answers.log").read_text(encoding="utf-8", errors="replace")
    assert "Output written" in log
    assert "Overfull" not in log


@every_arm
def test_the_numbers_on_the_page(sheet):
    """Rounded to four digits, at the home pose."""
    for item in sheet.items:
        html = in_page(sheet, item).split("In numbers")[1].split("<template")[0].replace("−", "-")
        if item.is_number:
            numbers = [float(html.split("=")[-1].split("<")[0])]
        else:
            numbers = [float(cell) for cell in re.findall(r"<td>([^<]*)</td>", html)]
        expected = np.ravel(true(sheet, item.name, sheet.home))
        np.testing.assert_allclose(numbers, expected, rtol=0, atol=5.1e-5)


# Pages


def pages():
    spec = importlib.util.spec_from_file_location("answers", ROOT / "tools" / "answers.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["answers"] = module
    spec.loader.exec_module(module)
    return module


ANSWERS = pages()


@pytest.mark.parametrize("page", ANSWERS.PAGES, ids=lambda page: page.name)
def test_the_book_has_what_the_generator_writes(page):
    path, text = ANSWERS.written_page(page)
    assert path.read_text(encoding="utf-8") == text, "run `make answers`"


def test_every_page_is_in_the_book():
    toc = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
    here = {path.stem for path in (ROOT / "book" / "answers").glob("*.md")}
    assert here == {page.name for page in ANSWERS.PAGES} == set(re.findall(r"answers/(\w+)", toc))


def test_answers_are_folded():
    text = markdown(ELBOW, "Elbow", "An arm.")
    assert text.count('<details class="answer"') == len(SHEETS["Elbow arm"].items)
    assert "<details open" not in text


def test_other_lengths_stand_beside():
    """Numbers of both arms where they differ; at home link 3 points down its frame's y axis."""
    text = "".join(s.body for s in sections(ELBOW, (ELBOW.with_values(a_3=0.35),)))
    shown = text.split('id="a-3"')[1].split("</details>")[0]
    assert ">−0.3<" in shown
    assert ">−0.35<" in shown


def test_one_file_for_an_arm_of_your_own():
    html = document(NUMBERED)
    css, js = (Path(page.__file__).parent / "static" / f"answers.{x}" for x in ("css", "js"))
    head, rest = html.split(f"<style>\n{css.read_text(encoding='utf-8')}</style></head>\n")
    assert head == (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>numbers only: answers'
        '</title>\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    )
    start = '<body class="sheet"><main>\n<h1>numbers only: answers</h1>\n<p class="answer-tools">'
    assert rest.startswith(start)
    assert rest.endswith(f"<script>\n{js.read_text(encoding='utf-8')}</script></body></html>\n")
    assert not re.search(r"""(?:src|href)=["']""", html)
    assert "Copy all as" in html
    parts = "".join(f"<h2>{s.heading}</h2>\n{s.question}{s.body}" for s in sections(NUMBERED))
    assert f"</p>\n{parts}</main>\n<script>" in html
    headings = [
        "Table",
        "Link matrices",
        "Frames seen from the base",
        "Origins",
        "Axes",
        "Jacobian",
    ]
    assert re.findall("<h2>(.*?)</h2>", html) == headings


def test_a_name_is_escaped():
    html = document(Arm("<b>bold & brave</b>", [revolute(a="l")], {"l": 1.0}))
    assert "<b>bold" not in html
    assert "&lt;b&gt;bold &amp; brave" in html


# The command line


def test_the_command_writes_a_file(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    main(["elbow arm"])
    assert capsys.readouterr().out == "elbow_arm_answers.html\n"
    assert "Elbow arm" in (tmp_path / "elbow_arm_answers.html").read_text(encoding="utf-8")


def test_a_files_name_is_made_of_words():
    names = ["UR10e (homework)", " Panda, joint 3 ", "Ä-1", "…"]
    assert [slug(name) for name in names] == ["ur10e_homework", "panda_joint_3", "ä_1", "arm"]


def test_an_arm_out_of_a_python_file(tmp_path):
    path = tmp_path / "mine.py"
    path.write_text(
        "from helpers.robots import ELBOW\nMINE = ELBOW\nTHEIRS = 3\n", encoding="utf-8"
    )
    assert read_arm(f"{path}:MINE") == ELBOW
    with pytest.raises(ArmError, match=r"THEIRS of .* is 3; expected an Arm"):
        read_arm(f"{path}:THEIRS")
    with pytest.raises(ArmError, match=r"none\.py is not there; expected a Python file"):
        read_arm("none.py:ARM")


def test_an_arm_out_of_a_robot_description(tmp_path):
    path = tmp_path / "one.urdf"
    path.write_text(
        '<robot name="one"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
        '<parent link="a"/><child link="b"/></joint></robot>',
        encoding="utf-8",
    )
    assert read_arm(str(path)).name == "one"


def test_the_command_takes_two_links_and_a_files_name(tmp_path, capsys):
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
    assert out.read_text(encoding="utf-8") == document(from_urdf(file, "b", "d"))
    assert from_urdf(file, "b", "d") not in (from_urdf(file, "b"), from_urdf(file, None, "d"))


def test_the_command_says_what_is_wrong(capsys):
    with pytest.raises(SystemExit, match="no arm is called 'Puma'; expected one of"):
        main(["Puma"])


def test_one_block_by_its_name():
    sheet = SHEETS["Elbow arm"]
    assert block(ELBOW, "det_J", "MATLAB") == as_matlab(sheet, sheet.determinant)


# What is refused


@pytest.mark.parametrize("letter", ["np", "J", "end", "c_1", "T_03", "x_c2", "q_9", "g", "A_1"])
def test_letters_that_a_program_needs_itself(letter):
    with pytest.raises(ArmError, match=f"has a letter called {letter}, which a program"):
        Sheet(Arm("mine", [revolute(a=letter)], {letter: 1.0}))


def test_letters_that_matlab_does_not_know():
    with pytest.raises(ArmError, match="has a letter called ä_1"):
        Sheet(Arm("mine", [revolute(a="ä_1")], {"ä_1": 1.0}))


def test_no_arm_is_refused():
    with pytest.raises(ArmError, match="arm is 'Panda'; expected an Arm"):
        Sheet("Panda")


def test_only_other_values_may_stand_beside():
    with pytest.raises(ArmError, match="Panda has other rows than Elbow arm; expected other value"):
        sections(ELBOW, (PANDA,))


def test_short_names_that_would_say_two_things_are_not_used():
    """With twelve joints c_12 could be cos(q_12) or cos(q_1 + q_2)."""
    rows = [revolute(a="a"), revolute(a="a"), *[revolute(alpha="pi/2")] * 9, revolute()]
    rows[1] = revolute(a="a", alpha="pi/2")
    names = [n.name for n in Sheet(Arm("twelve", rows, {"a": 1.0})).short_names.values()]
    assert len(names) == len(set(names))


def test_a_table_has_letters_that_sympy_means_otherwise_and_exact_numbers():
    rows = [revolute(a="beta", alpha="pi/2", d=0.1), prismatic(a="S", d="-2*N/3", theta=1.25)]
    html = page.table(Arm("letters", rows, {"beta": 1.0, "S": 2.0, "N": 3.0}))
    assert re.findall(r"<td>(.*?)</td>", html) == [
        "1", "<i>β</i>", "π/2", "0.1", "<i>q</i><sub>1</sub>",
        "2", "<i>S</i>", "0", "−2/3\u2009<i>N</i> + <i>q</i><sub>2</sub>", "1.25",
    ]  # fmt: skip


def letters(count):
    return sp.Mul(*map(sp.Symbol, string.ascii_letters[:count]))


@pytest.mark.parametrize(
    ("counts", "whole"),
    [((26, 26), True), ((26, 27), False), ((1,) * 10, True), ((1,) * 11, False)],
)
def test_a_matrix_of_56_signs_and_ten_columns_stays_one_in_latex(counts, whole):
    """Two signs a column are what stands between."""
    value = sp.ImmutableMatrix([[letters(count) for count in counts], [1] * len(counts)])
    text = as_latex(Sheet(ELBOW), Item("A_1", value, np.zeros(value.shape)))
    assert ("bmatrix" in text) == whole
    assert ("align" in text) != whole


@pytest.mark.parametrize(("count", "whole"), [(17, True), (18, False)])
def test_a_matrix_of_19_em_stays_one_on_a_phone(count, whole):
    """A letter and the space before it are 0.55 em each, a column 0.8 em more."""
    value = sp.ImmutableMatrix([letters(count), 1])
    html = answer(Sheet(ELBOW), Item("o_1", value, np.zeros(value.shape)))
    assert ('<div class="matrix"><span>' in html) == whole
    assert ("entries" in html) != whole


def test_a_long_sum_is_broken_between_its_terms():
    """Terms of five letters and a sign, of which eight have room in 50 signs of a line."""
    terms = [sp.Mul(*(sp.Symbol(x) for x in group)) for group in combinations("abcdefg", 5)]
    text = as_latex(Sheet(ELBOW), Item("P", sp.ImmutableMatrix([[sum(terms)]]), np.eye(1)))
    shown = text.split(" &= ")[1].split("\\end")[0].replace("quad", "").split("\\\\")
    assert [len(re.findall("[a-g]", line)) / 5 for line in shown] == [8, 8, 5]


def test_answers_are_called_as_books_call_them():
    called = {"A_1": "A_{1}", "T_03": "{}^{0}T_{3}", "o_0": "o_{0}", "z_2": "z_{2}", "J": "J",
              "det_J": r"\det J", "P": "P", "G": "g(q)"}  # fmt: skip
    item = SHEETS["Elbow arm"].jacobian
    assert {name: latex_title(replace(item, name=name)) for name in called} == called


def test_a_page_has_a_description_where_one_is_given():
    assert markdown(ELBOW, "Elbow", "An arm.").startswith("# Elbow\n\nAn arm.\n\n```{raw} html\n")
    head = '---\nmyst:\n  html_meta:\n    description: "Of \\"it\\""\n---\n\n# Elbow\n\nAn arm.\n'
    assert markdown(ELBOW, "Elbow", "An arm.", description='Of "it"').startswith(head)


def test_the_command_helps(capsys):
    with pytest.raises(SystemExit, match="0"):
        main(["--help"])
    told = " ".join(capsys.readouterr().out.split())
    for line in [
        "usage: python -m helpers.sheets [-h] [--base BASE] [--tip TIP] [--out OUT] arm",
        "arm a name of the catalogue, a robot description (arm.urdf), or my_arm.py:NAME",
        "--base BASE a robot description's first link",
        "--tip TIP a robot description's last link",
        "--out OUT the file to write; named after the arm unless given",
        "Write the answer sheet of any arm into one HTML file.",
    ]:
        assert line in told


def test_masses_of_zero_leave_an_empty_row():
    arm = Arm("light", [revolute(a=1)], bodies=[Body(0, (0, 0, 0))])
    assert "<td>0</td>" in document(arm)


@pytest.mark.parametrize(
    ("formula", "html", "latex", "numpy", "matlab"),
    [
        ("3*pi/4", "3 π/4", r"3 \pi/4", "3*np.pi/4", "3*pi/4"),
        ("-pi/2", "−π/2", r"-\pi/2", "-np.pi/2", "-pi/2"),
        ("a*(b - 2)**2", "<i>a</i> (<i>b</i> − 2)<sup>2</sup>", "a (b - 2)^{2}", "a*(b - 2)**2",
         "a*(b - 2)^2"),
        ("-a/3", "−1/3 <i>a</i>", r"-\tfrac{1}{3} a", "-1/3*a", "-1/3*a"),
        ("5*a_2/2", "2.5 <i>a</i><sub>2</sub>", "2.5 a_{2}", "2.5*a_2", "2.5*a_2"),
        ("d_3*sin(q - 2)", "<i>d</i><sub>3</sub> sin(<i>q</i> − 2)",
         r"d_{3} \sin(q - 2)", "d_3*np.sin(q - 2)", "d_3*sin(q - 2)"),
        ("sqrt(2)*alpha_k**2", "√(2) <i>α</i><sub>k</sub><sup>2</sup>",
         r"\sqrt{2} \alpha_{\mathrm{k}}^{2}", "np.sqrt(2)*alpha_k**2", "sqrt(2)*alpha_k^2"),
        ("-1", "−1", "-1", "-1", "-1"),
        ("1 - a", "1 − <i>a</i>", "1 - a", "1 - a", "1 - a"),
    ],
)  # fmt: skip
def test_a_formula_in_each_language(formula, html, latex, numpy, matlab):
    expression = sp.sympify(formula)
    written = [formulas.written(expression, getattr(formulas, x)) for x in LANGUAGES]
    assert [x.replace("\u2009", " ") for x in written] == [
        html, latex, numpy.replace("np.", "sp.").replace("1/3", "sp.Rational(1, 3)"), numpy, matlab
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("formula", "words"),
    [
        ("1/a", "the formula 1/a is no product of powers; expected sums and products"),
        ("a**b", "the formula a**b is no product of powers; expected sums and products"),
        (
            "tan(a)",
            "the formula tan(a) is no cosine, sine, letter or number; expected one of these",
        ),
    ],
)
def test_a_formula_of_other_kinds_is_refused(formula, words):
    with pytest.raises(ArmError, match=f"^{re.escape(words)}$"):
        formulas.written(sp.sympify(formula), formulas.HTML)


LANGUAGES = ("HTML", "LATEX", "SYMPY", "NUMPY", "MATLAB")
