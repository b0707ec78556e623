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
# What has no rule in the style sheet, around mere signs: it would be a third of a page's elements.
_BARE = re.compile(
    r'<span class="(?:m(?:ord|bin|rel|open|close|punct|op|tight|athrm)[ "])+>([^<]*)</span>'
)
# An index or an exponent, for which KaTeX makes a table of ten elements: how far its line stands
# below the letter's (the height of a strut, less how far it is raised), and what it says.
_ITEM = r"(?:[^<]|<span[^>]*>[^<]*</span>)*"
_SCRIPT_TABLE = re.compile(
    r'<span class="msupsub"><span class="vlist-t[^"]*"><span class="vlist-r">'
    r'<span class="vlist"[^>]*><span style="top:-([\d.]+)em;(?:margin-left:(-?[\d.]+)em;)?'
    r'margin-right:0.05em;"><span class="pstrut" style="height:([\d.]+)em;"></span>'
    r'<span class="katex-sizing reset-size6 size3 mtight">'
    rf"({_ITEM}|<span[^>]*>{_ITEM}</span>)</span></span></span>"
    r'(?:<span class="vlist-s">.</span></span><span class="vlist-r">'
    r'<span class="vlist"[^>]*><span></span></span>)?</span></span></span>'
)
_SCRIPT_SIZE = 0.7
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
        return _lighter(_SOURCE.sub("", json.loads(_engines.set(rows + tex, display, output))))
    except quickjs.JSException as problem:
        first = str(problem).partition("\n")[0]
        raise ArmError(f"{tex} is no formula: {first}; expected TeX that KaTeX knows") from None


def _lighter(html: str) -> str:
    """The same to the eye and the ear, in a third of the elements."""
    html = _CELL.sub(r"<mtd>\1</mtd>", html)
    bare = 1
    while bare:
        html, bare = _BARE.subn(r"\1", html)
    return _SCRIPT_TABLE.sub(_script, html)


def _script(table: re.Match) -> str:
    raised, left, strut, text = table.groups()
    place = [f"vertical-align:{(float(raised) - float(strut)) / _SCRIPT_SIZE:.4f}em"]
    if left and float(left):
        place.append(f"margin-left:{float(left) / _SCRIPT_SIZE:.4f}em")
    return f'<span class="katex-script" style="{";".join(place)}">{text}</span>'
