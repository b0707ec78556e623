"""A formula as KaTeX sets it, the same to the eye and the ear, in half of the elements.

KaTeX writes a box for each atom of TeX, and a table of ten elements for whatever stands above
something else. A chapter has hundreds of formulas; what says nothing there is left out here.
"""

import re
from html import escape
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

# What has no rule in the style sheet.
UNSTYLED = {
    *("mord", "mbin", "mrel", "mopen", "mclose", "mpunct", "mop", "minner", "mtight", "mathrm"),
    *("katex-sizing", "nobreak"),
}
ROWS = {"math", "mtd", "mstyle", "mrow"}  # whose children are one row in MathML
SMALL = 0.7  # the size of an index
LOWERED = f"vertical-align:{-0.15 / SMALL:.4f}em"  # as most indices are
ABOVE, BELOW = 0.79, 0.41  # em of the letters' line, that any line has room for
# Equal room on both sides of a sign.
AROUND = re.compile(
    r'<span class="mspace" style="margin-right:(0\.\d+)em;"></span>([^<]+)'
    r'<span class="mspace" style="margin-right:\1em;"></span>'
)
SIGNS = {"0.2222": "binary", "0.2778": "relation"}  # by their room in em


def lighter(markup: str) -> str:
    """The markup of one formula, from `helpers.typeset.html`."""
    return AROUND.sub(_sign, _written(ElementTree.fromstring(markup), Element("p")))


def _sign(found: re.Match) -> str:
    room, sign = found.groups()
    return f'<span class="{SIGNS[room]}">{sign}</span>' if room in SIGNS else found[0]


def _written(node: Element, parent: Element) -> str:
    """The markup of an element, or of what is in it where it says nothing itself."""
    classes = [name for name in node.get("class", "").split() if name not in UNSTYLED]
    if "vlist-t" in classes:
        return _stack(node)
    if "katex-strut" in classes and _within_a_line(node):
        return ""
    script = _script(node) if "msupsub" in classes else ""
    inside = script or _inside(node)
    if script or (
        _is_idle(node, parent) if node.tag == "mrow" else _is_plain(node, parent, inside)
    ):
        return inside
    if classes == ["mathnormal"]:
        return _tagged("i", {"style": node.get("style", "")}, inside)
    return _tagged(node.tag, node.attrib | {"class": " ".join(classes)}, inside)


def _inside(node: Element) -> str:
    parts = [_text(node.text)]
    for child in node:
        parts += [_written(child, node), _text(child.tail)]
    return "".join(parts)


def _text(text: str | None) -> str:
    return escape(text or "", quote=False)


def _tagged(tag: str, attributes: dict[str, str], inside: str) -> str:
    said = "".join(f' {key}="{escape(value)}"' for key, value in attributes.items() if value)
    return f"<{tag}{said}>{inside}</{tag}>"


def _is_idle(row: Element, parent: Element) -> bool:
    """Whether a row of MathML holds together what is together anyway."""
    return len(row) == 1 or (len(parent) == 1 and parent.tag in ROWS)


def _is_plain(span: Element, parent: Element, inside: str) -> bool:
    """Whether the style sheet has no rule for a box: not even for one in a row of a stack, unless
    mere letters stand in it, or in a bracket that is put together."""
    if span.tag != "span" or span.get("style") or {*span.get("class", "").split()} - UNSTYLED:
        return False
    in_row = len(parent) > 0 and parent[0].get("class") == "pstrut"
    return not (in_row and "<span" in inside) and "delim-size4" not in parent.get("class", "")


def _em(node: Element, key: str) -> float:
    found = re.search(rf"(?:^|;){key}:(-?[\d.]+)em", node.get("style", ""))
    return float(found[1]) if found else 0.0


def _within_a_line(strut: Element) -> bool:
    low = -_em(strut, "vertical-align")
    return _em(strut, "height") - low <= ABOVE and low <= BELOW


def _stack(table: Element) -> str:
    """What KaTeX makes a table of, as one box: its rows, each placed from the box's top. Every row
    begins with a strut, on whose foot its letters stand; the style sheet makes it."""
    (rows, *_), *rest = table
    high, low = _em(rows, "height"), sum(_em(below[0], "height") for below in rest)
    strut = _em(rows[0][0], "height")
    style = f"height:{high + low:.6g}em"
    style += f";vertical-align:{-low:.6g}em" * bool(low) + f";--strut:{strut:.6g}em" * (strut != 3)
    return _tagged("span", {"class": "vlist", "style": style}, "".join(_row(r, high) for r in rows))


def _row(row: Element, high: float) -> str:
    strut, *boxes = row
    top = _em(row, "top")
    inside = _text(strut.tail) + "".join(_written(box, row) + _text(box.tail) for box in boxes)
    style = row.get("style", "").replace(f"top:{top:g}em", f"top:{top + high:.6g}em")
    return _tagged("span", {"class": row.get("class", ""), "style": style}, inside)


def _script(pair: Element) -> str:
    """An index or an exponent alone as one element: how far its line stands from the letter's, in
    its own em. Of both, and within small letters, a stack stays."""
    row, *others = pair[0][0][0]
    strut, *boxes = row
    inside = "".join(_inside(box) for box in boxes)
    usual = all("reset-size6 size3" in box.get("class", "") for box in boxes)
    if others or not usual or re.search("<sub|vlist|size", inside):
        return ""
    style = f"vertical-align:{-(_em(row, 'top') + _em(strut, 'height')) / SMALL:.4f}em"
    if left := _em(row, "margin-left"):
        style += f";margin-left:{left / SMALL:.4f}em"
    return _tagged("sub", {"style": "" if style == LOWERED else style}, inside)
