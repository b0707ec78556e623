"""A formula as KaTeX sets it, the same to the eye and the ear, in a fraction of the bytes.

KaTeX writes a box for each atom of TeX, a table of ten elements for whatever stands above something
else, and in MathML how it would look. A chapter has hundreds of formulas; what says nothing there
is left out here.
"""

import re
from html import escape
from itertools import pairwise
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

# What has no rule in the style sheet.
UNSTYLED = {
    *("mord", "mbin", "mrel", "mopen", "mclose", "mpunct", "mop", "minner", "mtight", "mathrm"),
    *("mspace", "katex-sizing", "nobreak"),
}
SILENT = {  # of MathML that nobody looks at
    *("stretchy", "fence", "separator", "lspace", "rspace", "minsize", "maxsize", "rowspacing"),
    *("columnspacing", "columnalign", "scriptlevel", "displaystyle"),
}
ROWS = {"math", "mtd", "mstyle", "mrow"}  # whose children are one row in MathML
IN_A_ROW = {"math", "mrow", "mi", "mn", "mo", "mtext"}  # of letters and signs without an index
SMALL = 0.7  # the size of an index
LOWERED = f"{-0.15 / SMALL:.4f}"  # em of an index, as most are
ABOVE, BELOW = 0.79, 0.41  # em of the letters' line, that any line has room for
# Equal room on both sides of a sign.
AROUND = re.compile(
    r'<span style="margin-right:(0\.\d+)em;"></span>([^<]+)'
    r'<span style="margin-right:\1em;"></span>'
)
THIN = '<span style="margin-right:0.1667em;"></span>'
SIGNS = {"0.2222": "b", "0.2778": "bdi"}  # a sum's and a relation's, by their room in em
# A letter leans out of its box; its index goes back below it.
LEANS = re.compile(
    r'<i style="margin-right:([\d.]+)em;">([^<]+)</i><sub style="([^"]*?);?margin-left:-([\d.]+)em"'
)
# Half gaps around a matrix by where its cells stand: a bmatrix has none, an array of numbers has.
AROUND_CELLS = {"col-align-c": 0, "col-align-r": 2}
BRACKETS = {"M403": "bracket", "M347": "bracket right"}  # by how KaTeX begins to draw them


def lighter(markup: str, breaks: bool = False) -> str:
    """The markup of one formula, from `helpers.typeset.html`: what is heard, then what is seen, in
    parts where a line may break between them. Signs in a row are heard as they are seen."""
    tree = ElementTree.fromstring(markup)
    said, seen = tree.find(".//math"), tree.find(".//*[@class='katex-html']")
    signs = (AROUND.sub(_sign, _part(part)).replace(THIN, "<u></u>") for part in seen)
    parts = [LEANS.sub(_upright, part) for part in signs]
    if not breaks and {node.tag for node in said.iter()} <= IN_A_ROW:
        return "".join(parts)
    shown = parts if breaks else ["".join(parts)]
    hidden = (_tagged("span", {"aria-hidden": "true"}, part) for part in shown)
    return _heard(said, tree) + "".join(hidden)


def _part(part: Element) -> str:
    """A strut that reaches no further than a matrix beside it goes."""
    inside = _inside(part)
    strut, style = _tagged("span", part[0].attrib, ""), part[0].get("style", "").rstrip(";")
    return inside.replace(strut, "", 1) if inside.count(style) > 1 else inside


def _sign(found: re.Match) -> str:
    room, sign = found.groups()
    return _tagged(SIGNS[room], {}, sign) if room in SIGNS else found[0]


def _upright(found: re.Match) -> str:
    room, letter, style, back = found.groups()
    if abs(float(room) - SMALL * float(back)) > 1e-3:
        return found[0]
    return f"<i>{letter}</i><sub" + f' style="{style}"' * bool(style)


def _heard(node: Element, parent: Element) -> str:
    """MathML without what changes only its look, with a word as one word."""
    empty = node.tag == "mrow" and len(node) == 0
    if node.tag == "mspace" or (empty and parent.tag in ROWS):
        return ""
    if node.tag == "mrow" and len(node) > 1 and all(map(_is_upright, node)):
        return _tagged("mi", {}, "".join(child.text for child in node))
    inside = _text(node.text) + "".join(_heard(child, node) for child in node)
    told = {k: value for k, value in node.attrib.items() if k not in SILENT and value != "normal"}
    row = node.tag in ("mrow", "mstyle")
    if row and (len(node) == 1 or (len(parent) == 1 and parent.tag in ROWS)):
        return inside
    return _tagged("mrow" if row else node.tag, told, inside)


def _is_upright(letter: Element) -> bool:
    return letter.get("mathvariant") == "normal" and letter.tag == "mi" and letter.text.isascii()


def _written(node: Element, parent: Element) -> str:
    """The markup of an element, or of what is in it where it says nothing itself."""
    classes = [name for name in node.get("class", "").split() if name not in UNSTYLED]
    style = node.get("style", "")
    if style == "top:0em;" and "delimcenter" in classes:
        classes, style = [], ""
    if "katex-strut" in classes and _within_a_line(node):
        return ""
    for name, shorter in SHORTER.items():
        if name in classes and (made := shorter(node)):
            return made
    inside = _inside(node)
    if not style and not classes and _is_plain(node, parent, inside):
        return inside
    if classes == ["mathnormal"]:
        return _tagged("i", {"style": style}, inside)
    return _tagged(node.tag, node.attrib | {"class": " ".join(classes), "style": style}, inside)


def _inside(node: Element) -> str:
    parts = [_text(node.text)]
    for child in node:
        parts += [_written(child, node), _text(child.tail)]
    return "".join(parts)


def _text(text: str | None) -> str:
    return escape(text or "", quote=False)


def _tagged(tag: str, attributes: dict[str, str], inside: str) -> str:
    """Its style comes first, where `tools/pages.py` finds it."""
    said = sorted(attributes.items(), key=lambda pair: pair[0] != "style")
    words = "".join(f' {key}="{escape(value)}"' for key, value in said if value)
    return f"<{tag}{words}>{inside}</{tag}>"


def _is_plain(box: Element, parent: Element, inside: str) -> bool:
    """Whether a box may go that the style sheet has no rule for: not in a row of a stack, unless
    mere letters stand in it, nor in a bracket that is put together."""
    in_row = len(parent) > 0 and parent[0].get("class") == "pstrut"
    joined = "delim-size4" in parent.get("class", "")
    return box.tag == "span" and not joined and not (in_row and "<span" in inside)


def _em(node: Element, key: str) -> float:
    found = re.search(rf"(?:^|;){key}:(-?[\d.]+)em", node.get("style", ""))
    return float(found[1]) if found else 0.0


def _within_a_line(strut: Element) -> bool:
    low = -_em(strut, "vertical-align")
    return _em(strut, "height") - low <= ABOVE and low <= BELOW


def _rows(table: Element) -> tuple[float, float, float, Element]:
    """Of what KaTeX makes a table of: how far it reaches above and below the line, how high is the
    strut with which each row begins, on whose foot its letters stand, and the rows."""
    (rows, *_), *rest = table
    low = sum(_em(below[0], "height") for below in rest)
    return _em(rows, "height"), low, _em(rows[0][0], "height"), rows


def _reach(high: float, low: float) -> str:
    return f"height:{high + low:.6g}em" + f";vertical-align:{-low:.6g}em" * bool(low)


def _stack(table: Element) -> str:
    """A table as one box: its rows, each placed from the box's top."""
    high, low, strut, rows = _rows(table)
    style = _reach(high, low) + f";--strut:{strut:.6g}em" * (strut != 3)
    return _tagged("span", {"class": "vlist", "style": style}, "".join(_row(r, high) for r in rows))


def _row(row: Element, high: float) -> str:
    strut, *boxes = row
    top = _em(row, "top")
    inside = _text(strut.tail) + "".join(_written(box, row) + _text(box.tail) for box in boxes)
    style = row.get("style", "").replace(f"top:{top:g}em", f"top:{top + high:.6g}em")
    return _tagged("span", {"class": row.get("class", ""), "style": style}, inside)


def _grid(table: Element) -> str:
    """A matrix as one grid, column by column; of columns that are not 1 em apart, or neither all in
    the middle nor all on the right, each stays a stack."""
    gaps = [_em(gap, "width") for gap in table if gap.get("class") == "arraycolsep"]
    kinds = {part.get("class") for part in table} - {"arraycolsep"}
    if len(kinds) != 1 or not kinds <= AROUND_CELLS.keys():
        return ""
    (kind,) = kinds
    columns = [column[0] for column in table if column.get("class") == kind]
    if gaps != [0.5] * (2 * len(columns) - 2 + AROUND_CELLS[kind]):
        return ""
    high, low, *_ = _rows(columns[0])
    strut = max(_rows(column)[2] for column in columns)
    rows = [row for column in columns for row in _rows(column)[3]]
    lines = [_em(row, "top") + _em(row[0], "height") for row in _rows(columns[0])[3]]
    heights = [f"{below - above:.6g}em" for above, below in pairwise(lines)]
    style = f"{_reach(high, low)};--strut:{strut:.6g}em;--lift:{high + lines[0] - strut:.6g}em"
    style += f";grid-template-rows:{' '.join([*heights, '0'])}"
    cells = "".join(_tagged("span", {}, "".join(map(_inside, row[1:]))) for row in rows)
    name = "cells" if kind == "col-align-c" else f"cells {kind}"
    return _tagged("span", {"class": name, "style": style}, cells)


def _bracket(delimiter: Element) -> str:
    """A square bracket of any height, which the style sheet draws."""
    drawn = [path.get("d").split()[0] for path in delimiter.iter("path")]
    name = BRACKETS.get("".join(drawn))
    if not name:
        return ""
    high, low, *_ = _rows(delimiter[0])
    return _tagged("svg", {"class": name, "style": _reach(high, low)}, "<rect/>")


def _script(pair: Element) -> str:
    """An index or an exponent alone as one element: how far its line stands from the letter's, in
    its own em. Of both, and within small letters, a stack stays."""
    row, *others = pair[0][0][0]
    strut, *boxes = row
    inside = "".join(_inside(box) for box in boxes)
    usual = all("reset-size6 size3" in box.get("class", "") for box in boxes)
    if others or not usual or re.search("<sub|vlist|cells|size", inside):
        return ""
    low = f"{-(_em(row, 'top') + _em(strut, 'height')) / SMALL:.4f}"
    left = _em(row, "margin-left") / SMALL
    style = [f"vertical-align:{low}em"] * (low != LOWERED) + [f"margin-left:{left:.4f}em"] * (
        left != 0
    )
    return _tagged("sub", {"style": ";".join(style)}, inside)


SHORTER = {"msupsub": _script, "mtable": _grid, "mult": _bracket, "vlist-t": _stack}
