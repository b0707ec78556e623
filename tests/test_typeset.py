"""Formulas set by KaTeX: what listeners hear is the formula, and what is none is told in words."""

import re
import threading

import pytest

from helpers import typeset
from helpers.inputs import ArmError
from tools.formulas import lighter


def heard(markup):
    return re.findall(r"<(m[ion]|mfrac|msub|mtr)>([^<]*)", markup)


@pytest.mark.parametrize("way", [typeset.html, typeset.mathml])
def test_a_formula_is_heard_as_it_is_written_and_its_source_does_not_come_along(way):
    made = way(r"\frac{1}{2} q_3")
    said = [("mfrac", ""), ("mn", "1"), ("mn", "2"), ("msub", ""), ("mi", "q"), ("mn", "3")]
    assert heard(made) == said
    assert "annotation" not in made
    assert "frac{" not in made


def test_in_html_letters_are_seen_and_mathml_is_heard():
    made = typeset.html("a_1")
    assert made.count("<math") == made.count('aria-hidden="true"') == 1
    assert typeset.mathml("a_1").startswith("<math>")
    assert "katex" not in typeset.mathml("a_1")


def test_a_display_has_a_line_of_its_own_and_rows():
    made = typeset.html(r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix}", display=True)
    assert made.startswith('<span class="katex-display">')
    assert made.count("<mtr>") == 2
    assert '<math display="block">' in typeset.mathml("x", display=True)


@pytest.mark.parametrize("tex", [r"\nosuch", "a_", r"\frac{1}", "a < b é", "x\0"])
def test_what_is_no_formula_is_told_in_words(tex):
    with pytest.raises(ArmError, match=r"is no formula: .*; expected TeX"):
        typeset.html(tex)


def test_any_thread_may_ask():
    made = []
    thread = threading.Thread(target=lambda: made.append(typeset.html("q")))
    thread.start()
    thread.join()
    assert made == [typeset.html("q")]


@pytest.mark.parametrize(
    ("tex", "lines"),
    [("a_1", [(0.15, "1")]), ("q^2", [(-0.363, "2")]), ("z_{i-1}", [(0.15, "i−1")])],
)
def test_an_index_and_an_exponent_are_one_element_at_the_height_that_katex_gives(tex, lines):
    """In em of the letter: TeX lowers an index by 0.15 (Appendix G of The TeXbook, sub1) and raises
    an exponent of a line by 0.363 (sup2), at 0.7 of the size."""
    made = lighter(typeset.html(tex))
    found = re.findall(r'<sub(?: style="vertical-align:([-\d.]+)em[^"]*")?>(.*?)</sub>', made)
    usual = -0.2143  # of the style sheet
    said = [(-0.7 * float(low or usual), re.sub("<.*?>", "", text)) for low, text in found]
    assert [text for _, text in said] == [text for _, text in lines]
    assert [low for low, _ in said] == pytest.approx([low for low, _ in lines], abs=1e-4)
    assert "vlist" not in made


@pytest.mark.parametrize(("of", "kind"), [("{matrix}", ""), ("{array}{rr}", " col-align-r")])
def test_rows_stand_where_katex_puts_them_between_brackets(of, kind):
    """Three rows of a matrix are 1.2 em apart (TeX's baselineskip at arraystretch 1), the first
    0.84 em below its top (0.7 of it); brackets and rows reach as far as KaTeX's own strut."""
    end = of.partition("}")[0]
    full = typeset.html(rf"\left[\begin{of} 1 & 2 \\ 3 & 4 \\ 5 & 6 \end{end}}}\right]")
    made = lighter(full)
    assert "--strut:3em;--lift:-2.16em;grid-template-rows:1.2em 1.2em 0" in made
    reach = r"height:([\d.]+)em;vertical-align:(-[\d.]+)em"
    assert re.findall(reach, made) == re.findall(reach, full)[:1] * 3
    classes = re.findall(r'class="(bracket.*?|cells.*?)"', made)
    assert classes == ["bracket", f"cells{kind}", "bracket right"]
    assert re.sub("<.*?>", "", made) == "[123456]135246"


def test_a_word_is_heard_as_one_and_an_index_stands_below_a_letter_that_leans():
    """TeX adds no italic correction before an index (Appendix G, rule 18f)."""
    made = lighter(typeset.html(r"\mathrm{Rot}_z T_i"))
    assert heard(made)[:2] == [("msub", ""), ("mi", "Rot")]
    assert "<i>T</i><sub><i>i</i></sub>" in made


def test_signs_in_a_row_are_heard_as_they_are_seen():
    assert lighter(typeset.html(r"d = -a")) == "<i>d</i><bdi>=</bdi>−<i>a</i>"
    assert [lighter(typeset.html(tex)).count("<math") for tex in ("q_1", r"\sqrt{q}")] == [1, 1]


def test_what_a_formula_shows_and_says_stays():
    for tex in (r"\hat z_1^2", r"\frac{\partial x}{\partial q_{i-1}} < \sqrt{2}", r"{}^0T_i = A_1"):
        full = typeset.html(tex)
        less = lighter(full)
        letters = [re.sub(r"<[^>]*>|\u200b", "", markup) for markup in (full, less)]
        assert letters[0] == letters[1]
        assert less.count("<") < 0.7 * full.count("<")
