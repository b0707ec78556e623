"""Formulas as a page shows them: TeX, set by KaTeX (katex.min.js), which QuickJS runs."""

import json
import re
import threading
from pathlib import Path

from helpers.inputs import ArmError, must_be

_SCRIPT = Path(__file__).with_name("katex.min.js")
_START = "var self = globalThis, window, document;"  # what KaTeX looks for in a browser
# Text comes back as JSON, which no bridge between the languages can cut or recode.
_SET = """(tex, displayMode, output) =>
    JSON.stringify(katex.renderToString(tex, { displayMode, output, strict: "error" }))"""
# The TeX once more, which no browser shows.
_SOURCE = re.compile(r'<annotation[^>]*>[^<]*</annotation>|</?semantics>| xmlns="[^"]*"')
# A cell's style that a cell has by itself.
_CELL = re.compile(
    r'<mtd><mstyle scriptlevel="0" displaystyle="false">((?:(?!</?mtd).)*)</mstyle></mtd>'
)
_CROWDED = re.compile(r"\\begin\{\w*matrix\}(?:(?!\\end\{).)*\\frac", re.S)  # rows would touch
_engines = threading.local()  # a context belongs to one thread


def html(tex: str, display: bool = False) -> str:
    """A formula in HTML, which needs KaTeX's style sheet and letters, with MathML for those who
    listen.

    Raises ArmError where KaTeX does not know what the TeX says.
    """
    return _set(tex, display, "htmlAndMathml")


def mathml(tex: str, display: bool = False) -> str:
    """A formula in MathML, for a page that has no letters of its own.

    Raises ArmError where KaTeX does not know what the TeX says.
    """
    return _set(tex, display, "mathml").removeprefix('<span class="katex">').removesuffix("</span>")


def _set(tex: str, display: bool, output: str) -> str:
    import quickjs

    must_be(tex, str, "tex")
    if not hasattr(_engines, "set"):
        context = quickjs.Context()
        context.eval(_START + _SCRIPT.read_text(encoding="utf-8"))
        _engines.set = context.eval(_SET)
    rows = r"\def\arraystretch{1.5}" if _CROWDED.search(tex) else ""
    try:
        markup = _SOURCE.sub("", json.loads(_engines.set(rows + tex, display, output)))
        return _CELL.sub(r"<mtd>\1</mtd>", markup)
    except quickjs.JSException as problem:
        first = str(problem).partition("\n")[0]
        raise ArmError(f"{tex} is no formula: {first}; expected TeX that KaTeX knows") from None
