"""Test formulas converted to MathML, and messages for invalid TeX."""

import re
import threading
from pathlib import Path

import pytest
from fontTools.ttLib import TTFont

from answers import typeset
from helpers.inputs import ArmError

FACE = Path(__file__).parents[1] / "book" / "assets" / "vendor" / "stix" / "stix-two-math.woff2"


def list_symbols(markup):
    return re.findall(r"<(m[ion]|mfrac|msub|mtr)\b[^>]*>([^<]*)", markup)


def test_mathml_holds_formula_without_tex():
    made = typeset.convert_to_mathml(r"\frac{1}{2} q_3")
    said = [("mfrac", ""), ("mn", "1"), ("mn", "2"), ("msub", ""), ("mi", "q"), ("mn", "3")]
    assert list_symbols(made) == said
    assert "annotation" not in made
    assert "frac{" not in made


def test_display_formula_has_matrix_rows():
    made = typeset.convert_to_mathml(r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}", display=True)
    assert made.startswith('<math display="block"')
    assert made.count("<mtr>") == 2


@pytest.mark.parametrize("tex", [r"\nosuch", "a_", r"\frac{1}", "a_1_2", r"\left( a"])
def test_invalid_tex_is_rejected(tex):
    for convert in (typeset.convert_to_mathml, typeset.convert_parts):
        with pytest.raises(ArmError, match=r"is no formula: .*; expected TeX"):
            convert(tex)


def test_mathml_works_in_any_thread():
    made = []
    thread = threading.Thread(target=lambda: made.append(typeset.convert_to_mathml("q")))
    thread.start()
    thread.join()
    assert made == [typeset.convert_to_mathml("q")]


def test_parts_break_after_relations_and_sums():
    parts = typeset.convert_parts("d = a_1 + b")
    assert [re.sub("<.*?>", "", part) for part in parts] == ["d=", "a1+", "b"]
    assert all(part.startswith("<math>") and part.endswith("</math>") for part in parts)
    assert len(typeset.convert_parts(r"\sqrt{a + b}")) == 1
    assert len(typeset.convert_parts(r"t = \tan^{-1}\!\left(\frac{s}{r}\right)")) == 2, (
        "tan keeps its bracket"
    )


def test_operator_has_no_space_in_index():
    signs = re.findall("<mo[^>]*>", typeset.convert_to_mathml("z_{i-1} - 1"))
    assert [sign.count('space="0"') for sign in signs] == [2, 0]


@pytest.mark.parametrize(("inside", "grows"), [("a_1", False), (r"\frac{1}{2}", True)])
def test_bracket_stretches_only_around_tall_content(inside, grows):
    made = typeset.convert_to_mathml(rf"\left( {inside} \right)")
    assert re.findall('stretchy="(.*?)"', made) == ["true" if grows else "false"] * 2


def test_function_name_has_space_only_before_it():
    made = typeset.convert_to_mathml(r"a_1 \cos{\left(q \right)} + \sin \theta_2 \cos q")
    shown = re.sub("<mspace[^>]*>", "_", made)
    assert re.sub("<.*?>|\N{FUNCTION APPLICATION}", "", shown) == "a1_cos(q)+sin_θ2_cos_q"


def test_math_font_has_usable_subscript_metrics():
    """The font must have a MATH table, and its subscripts must be lower than any descender."""
    face = TTFont(FACE)
    constants = face["MATH"].table.MathConstants
    below = max(-face["glyf"][face.getBestCmap()[ord(letter)]].yMin for letter in "𝑞𝑝𝑔𝑦𝑓")
    drop = constants.SubscriptBaselineDropMin.Value
    assert below + drop <= constants.SubscriptShiftDown.Value
