"""Convert TeX to MathML by Temml (temml.min.js), which runs in QuickJS."""

import json
import threading
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from helpers.inputs import ArmError, require_type

_SCRIPT = Path(__file__).with_name("temml.min.js")
# The result is JSON, so that QuickJS cannot cut or recode its text.
_SET = """(tex, displayMode, wrap) =>
    JSON.stringify(temml.renderToString(tex, { displayMode, wrap, throwOnError: true }))"""
_INDEXED = {"msub", "msup", "msubsup"}
_TALL = {"mfrac", "mtable", "munder", "mover", "munderover", "msqrt"}
_engines = threading.local()  # each thread needs its own context


def convert_to_mathml(tex: str, display: bool = False) -> str:
    """Convert a formula to MathML.

    Raises ArmError if Temml cannot parse the TeX.
    """
    return _to_text(_convert_tex(tex, display, "none"))


def convert_parts(tex: str) -> list[str]:
    """Convert a formula to MathML elements, after each of which a line may break.

    Browsers break no line inside an element.

    Raises ArmError as `convert_to_mathml` does.
    """
    formula = _convert_tex(tex, False, "tex")
    if len(formula) < 2 or any(part.tag != "mrow" for part in formula):
        return [_to_text(formula)]
    rows: list[Element] = []
    for part in formula:
        if not rows or not "".join(rows[-1].itertext()).endswith("\N{FUNCTION APPLICATION}"):
            rows.append(Element("math"))
        rows[-1].append(part)  # keep the argument of a function with its name
    return [_to_text(row) for row in rows]


def _convert_tex(tex: str, display: bool, wrap: str) -> Element:
    import quickjs

    require_type(tex, str, "tex")
    if not hasattr(_engines, "set"):
        context = quickjs.Context()
        context.eval(_SCRIPT.read_text(encoding="utf-8"))
        _engines.set = context.eval(_SET)
    try:
        markup = json.loads(_engines.set(tex, display, wrap))
    except quickjs.JSException as problem:
        first = str(problem).partition("\n")[0]
        raise ArmError(f"{tex} is no formula: {first}; expected TeX that Temml knows") from None
    formula = ElementTree.fromstring(markup.replace("&nbsp;", "\N{NO-BREAK SPACE}"))
    for cell in formula.iter("mtd"):
        cell.attrib.pop("style", None)  # its space in points, which style sheets cannot reduce
    for letter in formula.iter("mi"):
        if letter.text == "θ":
            letter.set("mathvariant", "normal")  # the page's italic θ has another font
    _remove_index_spaces(formula)
    _keep_brackets_low(formula)
    _space_function_names(formula)
    for cell in formula.iterfind(".//mtd[@class='tml-left']"):
        for sign in cell.iterfind("mrow/mo[1][@form='prefix']"):
            sign.set("form", "infix")  # a row that continues a sum
    return formula


def _remove_index_spaces(formula: Element) -> None:
    """Remove the space around operators in an index, as TeX does."""
    for base in formula.iter():
        if base.tag in _INDEXED:
            for index in base[1:]:
                for sign in index.iter("mo"):
                    sign.attrib |= {"lspace": "0", "rspace": "0"}


def _keep_brackets_low(formula: Element) -> None:
    """Stop brackets from growing around low content whose only tall part is an index."""
    for row in formula.iter("mrow"):
        if _TALL.isdisjoint(part.tag for part in row.iter()):
            for sign in row.findall("mo[@fence]"):
                sign.set("stretchy", "false")


def _space_function_names(formula: Element) -> None:
    """Put a thin space before a function's name and none before its bracket, as TeX does."""
    for row in formula.iter():
        for before, name, after in zip([None, *row], list(row), [*row[1:], None], strict=False):
            if name.findtext("mo") != "\N{FUNCTION APPLICATION}":
                continue
            bracket = after is not None and after.find("mo[@fence]") is not None
            if bracket and name[-1].tag == "mspace":
                name.remove(name[-1])
            if before is not None and not {before.tag, name[0].tag} & {"mo", "mspace"}:
                name.insert(0, Element("mspace", width="0.1667em"))


def _to_text(formula: Element) -> str:
    return ElementTree.tostring(formula, "unicode")
