"""Formulas set by KaTeX: what listeners hear is the formula, and what is none is told in words."""

import re
import threading

import pytest

from helpers import typeset
from helpers.inputs import ArmError


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
    made = typeset.html(tex)
    found = re.findall(
        r'katex-script" style="vertical-align:([-\d.]+)em[^"]*">(.*?)</span></span>', made
    )
    said = [(-0.7 * float(low), re.sub("<.*?>", "", text)) for low, text in found]
    assert [text for _, text in said] == [text for _, text in lines]
    assert [low for low, _ in said] == pytest.approx([low for low, _ in lines], abs=1e-4)
    assert "vlist" not in made
