"""A pasted text as rows of cells: NumPy, SymPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet
cells.
"""

import re

from helpers.inputs import ArmError
from helpers.reading.around import alone, bare_latex
from helpers.reading.around import bare as without_surroundings
from helpers.reading.formula import is_number, number, plain

Cells = list[list[str]]
LONGEST = 5_000_000  # characters of a paste: a trace of 20 000 steps

_WRAPPER = re.compile(
    r"^\s*(?:[\w.]+\s*(?:\(\w+\))?\s*=\s*)?(?:[\w.]*(?:Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym)\s*\(\s*)+"
)
_TAIL = re.compile(r"\)?(?:,\s*(?:dtype\s*=\s*[\w.']+|\d+)\s*)?\)+\s*;?\s*$")
_ENVIRONMENT = re.compile(
    r"\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?"
)
_FACTOR = re.compile(r"[-+*/^.0-9e \t]+(?=\[)")
_SCALE = re.compile(r"^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$", re.M)
_MATLAB_BLOCK = re.compile(
    r"^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$", re.M | re.I
)
_STARRED = re.compile(r"(?:^|[\s\[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$")
_RULE = re.compile(r"^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$")


def cells(text: str) -> Cells:
    """The rows of cells in a text, each cell as typed; raises ArmError where it is far too long or
    empty.
    """
    if len(text) > LONGEST:
        raise ArmError(f"the text has {len(text)} characters; expected at most {LONGEST}")
    rows = _rows(without_surroundings(text).strip().strip("`$").strip())
    rows = [[cell.strip() for cell in row] for row in rows if any(cell.strip() for cell in row)]
    if not rows:
        raise ArmError("the text is empty; expected rows of numbers or formulas")
    return rows


def _rows(text: str) -> Cells:
    if "\\begin{" in text or "\\\\" in text:
        return _latex(text)
    if text.count("|") >= 2 and not re.match(r"[^|]*\[[^\]|]*\|", text):
        return _markdown(text)
    bare = _TAIL.sub("", _WRAPPER.sub("", text)) if _WRAPPER.match(text) else text
    bare = (
        re.sub(r"^\s*[\w.]+\s*(?:\(\w+\))?\s*=\s*(?=[\[({\n\d-]|$)", "", bare)
        .strip()
        .rstrip(";")
        .strip()
    )
    if bare[:1] in "[({":
        return _bracketed(bare)
    if before := _FACTOR.match(bare):
        alone(before[0], re.sub(r"[ \t]", "", before[0]))
    return _lines(bare)


def _latex(text: str) -> Cells:
    text = bare_latex(text)
    text = re.sub(r"\\left\s*[\[(.|]\s*(?=\\begin)", " ", text)
    text = re.sub(
        r"\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])",
        " ",
        _ENVIRONMENT.sub(" ", text),
    )
    text = re.sub(r"^\s*[A-Za-z_]\w*(?:\([^()]*\))?\s*=", "", text)
    text = (
        re.sub(r"\\\\\s*\[[^\]]*\]", r"\\\\", text)
        .replace("$", " ")
        .replace("\\[", " ")
        .replace("\\]", " ")
    )
    return [row.split("&") for row in re.split(r"\\\\|\\cr(?![A-Za-z])", text)]


def _markdown(text: str) -> Cells:
    lines = [line.strip() for line in text.splitlines() if "|" in line]
    lines = [line for line in lines if not re.fullmatch(r"[\s:|+=_-]*[-=_][\s:|+=_-]*", line)]
    return [re.sub(r"^\||\|$", "", line).replace("$", " ").split("|") for line in lines]


# Brackets


def _bracketed(text: str) -> Cells:
    """Nested lists, tuples or MATLAB's one bracket with semicolons."""
    items = _items(text)
    if all(map(_is_list, items)):
        inner = [_items(item) for item in items]
        if any(any(map(_is_list, row)) for row in inner):
            flat = [
                [
                    _items(cell)[0] if _is_list(cell) and len(_items(cell)) == 1 else cell
                    for cell in row
                ]
                for row in inner
            ]
            if not any(any(map(_is_list, row)) for row in flat):
                return flat
            return [row for item in items for row in _bracketed(item)]
        return inner
    body = text.strip()[1:-1]
    if _is_list(text) and "[" not in body:
        return [_split(row) for row in re.split(r"[;\n]", re.sub(r"\.\.\.[^\n]*\n", " ", body))]
    return [items]


def _is_list(text: str) -> bool:
    """Whether a text is one bracket from end to end that holds a list; round ones only where a
    comma stands in them.
    """
    text = text.strip()
    if text[:1] not in ("[", "(", "{") or not _closes_at_end(text):
        return False
    return text[0] != "(" or _top_comma(text[1:-1])


def _deeper(sign: str) -> int:
    return (sign in "[({") - (sign in "])}")


def _closes_at_end(text: str) -> bool:
    depth = 0
    for k, sign in enumerate(text):
        depth += _deeper(sign)
        if not depth:
            return k == len(text) - 1
    return False


def _top_comma(text: str) -> bool:
    depth = 0
    for sign in text:
        depth += _deeper(sign)
        if sign == "," and not depth:
            return True
    return False


def _items(text: str) -> list[str]:
    """What a bracket holds, or a text without one, split where it is meant to be."""
    text = text.strip().rstrip(",")
    return _split(text[1:-1] if _is_list(text) else text)


def _split(text: str) -> list[str]:
    """Split at commas outside brackets, or at blanks where there are none, as MATLAB and NumPy
    do.
    """
    if all(map(is_number, pieces := text.split())):
        return pieces
    pieces, depth, piece = [], 0, ""
    comma = _top_comma(text)
    for k, sign in enumerate(text):
        depth += _deeper(sign)
        ends = sign == "," if comma else sign.isspace()
        if ends and not depth and (comma or not _joins(text, k)):
            pieces.append(piece)
            piece = ""
        else:
            piece += sign
        if not comma and not depth and sign == "]":
            pieces.append(piece)
            piece = ""
    pieces.append(piece)
    return [piece.strip().strip("'\"") for piece in pieces if piece.strip()]


def _joins(text: str, k: int) -> bool:
    """Whether the blank at k stands beside a sign that joins its neighbours: ``a - b`` is one cell,
    ``a -b`` are two, and so are a joint's variable that is marked by a star and what follows it. A
    star at the end marks a joint's variable, or is one.
    """
    before, after = text[:k].rstrip(), text[k:].strip()
    if after == "*":
        return _STARRED.search(f"{before}*") is not None
    if before[-1:] == "*" and after and after[0] not in "*/^)=" and _STARRED.search(before):
        return False
    if not before or not after or before[-1] in "+-*/^=(" or after[0] in "*/^)=":
        return True
    return (
        (after[0] in "+-" and len(after) > 1 and after[1].isspace())
        or after[:3] == "deg"
        or after[0] == "°"
    )


# Lines


def _lines(text: str) -> Cells:
    scale = _SCALE.search(text)
    text = _SCALE.sub("", text)
    tables = [rows for block in _MATLAB_BLOCK.split(text) if (rows := _block(block))]
    if len(counts := sorted({len(table) for table in tables})) > 1:
        given = ", ".join(map(str, counts))
        raise ArmError(f"the blocks of columns have {given} rows; expected as many in each")
    rows = [[cell for part in parts for cell in part] for parts in zip(*tables, strict=True)]
    if scale:
        rows = [[f"{cell}*{scale[1]}" if number(cell) else cell for cell in row] for row in rows]
    return rows


def _block(text: str) -> Cells:
    lines = [line for line in text.splitlines() if line.strip() and not _RULE.match(line)]
    lines = [line for line in lines if not re.fullmatch(r"\s*\w+\s*=\s*", line)]
    separator = next(
        (s for s in ("\t", ";") if any(s in line.strip().rstrip(";") for line in lines)), ""
    )
    if separator:
        return [
            [_pointed(cell) for cell in line.strip("\r\n ").rstrip(separator).split(separator)]
            for line in lines
        ]
    if any(_top_comma(line) for line in lines):
        return _by_commas(lines)
    return [_split(re.sub(r"^\s*[\[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$", "", line)) for line in lines]


def _by_commas(lines: list[str]) -> Cells:
    """Commas part cells, unless they are decimal ones: then blanks do."""
    by_blank = [_split(line.replace(",", ".")) for line in lines]
    decimal = all(re.fullmatch(r"\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}", line) for line in lines)
    return by_blank if decimal else [_split(line.rstrip(",")) for line in lines]


def _pointed(cell: str) -> str:
    """A cell with a decimal comma written with a point, and without a spreadsheet's quotes or
    sign of equality.
    """
    if (inner := cell.strip())[:1] == inner[-1:] == '"':
        cell = inner[1:-1]
    cell = re.sub(r"^[ \t]*=", "", cell)
    return (
        re.sub(r"(?<=\d),(?=\d)", ".", cell) if cell.count(",") == 1 and "(" not in cell else cell
    )


def numeric(rows: Cells) -> bool:
    """Whether every cell is a number without symbols."""
    return all(number(cell) is not None for row in rows for cell in row)


def without_header(rows: Cells) -> Cells:
    """The rows without the first if it is a header: one of names where numbers follow."""
    first, *rest = rows
    words = filter(None, map(plain, first))
    return rest if rest and all(number(w) is None for w in words) and numeric(rest) else rows
