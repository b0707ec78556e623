"""A pasted text as rows of cells: NumPy, SymPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet
cells.
"""

import re

from helpers.inputs import ArmError, shown
from helpers.reading.around import alone, bare_latex, beside
from helpers.reading.around import bare as without_surroundings
from helpers.reading.formula import FUNCTIONS, is_number, number, parse, plain

Cells = list[list[str]]
LONGEST = 5_000_000  # characters of a paste: a trace of 20 000 steps

_WRAPPER = re.compile(
    r"^\s*(?:[\w.]+\s*(?:\(\w+\))?\s*=\s*)?(?:[\w.]*(?:Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym)\s*\(\s*)+"
)
_TAIL = re.compile(r"\)?(?:,\s*(?:dtype\s*=\s*[\w.']+|\d+)\s*)?\)+\s*[;.,]?\s*$")
_TURNED = re.compile(
    r"\s*(?:[\w.]+\s*=\s*)?(?:\w+\.)?(deg2rad|radians|rad2deg|degrees)\s*(?=\(\s*(?:[\w.]*array\()?\s*\[)"
)
_ENDED = re.compile(r"(?<=[\])}])\s*[.,;]+$")
_TAKEN = re.compile(r"\s*\)*\s*(?:[-+*/^']|\.[*/^'T])")  # what changes the matrix before it
_CONTINUED = re.compile(r"\s*[-+*/^]\s|.*[-+*/^]\s*$")
_ENVIRONMENT = re.compile(
    r"\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?"
)
_FACTOR = re.compile(r"[-+*/^.0-9e \t]+(?=\[)")
_SCALE = re.compile(r"^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$", re.M)
_MATLAB_BLOCK = re.compile(
    r"^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$", re.M | re.I
)
_STARRED = re.compile(r"(?:^|[\s\[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$")
_SLIDING = re.compile(r"(?:^|[\s\[(+-])d_?\{?(?:\d+|i)?\}?\^?\*$")
_RULE = re.compile(r"^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$")
_GAP = re.compile("(?<=[^ \u00a0\t\n])[ \u00a0]{2,}(?=[^ \u00a0\t\n])")
_TIGHT = re.compile(r"(?<![0-9.,])[0-9]+,[0-9]+(?![0-9.,])")
_DECIMAL = re.compile(r"\s*[-+−]?(?![1-9][0-9]{0,2},[0-9]{3}\s*$)[0-9]+,[0-9]+\s*")
_THOUSANDS = re.compile(r"[-+−]?[0-9]{1,3}(?:,[0-9]{3})+\.[0-9]+")
_DOTTED_THOUSANDS = re.compile(r"[-+−]?[0-9]{1,3}(?:\.[0-9]{3})+,[0-9]+")
_EITHER = re.compile(r"[-+−]?[1-9][0-9]{0,2},[0-9]{3}")  # a decimal comma, or one of thousands
_DEGREES = re.compile(r"°|deg(?:rees?)?(?![A-Za-z0-9_]|\s*\()")
_RADIANS = re.compile(r"rad(?:ian)?s?(?![A-Za-z0-9_]|\s*\()")
_NO_HEAD = re.compile(r"[≈~]? ?[-+]?[.,0-9][-+.,%0-9 eEdD]*|[-+]?[0-9]{2,}.*")
_NUMBERED = re.compile(r"\s*(?:(?:joint|link|row)\s*)?([0-9]+)[:)]\s+", re.I)
_BULLET = re.compile(r"\s*[-–—]\s")
_IN_DEGREES = re.compile(r".*[0-9.]\s*(?:°|º|deg(?:rees?)?)")
_TURN = 6.3  # a number beyond is no angle in radians
_QUOTED = re.compile(r'"[^"\n]*,[^"\n]*"')
_JUXTAPOSED = re.compile(r"[0-9.]\s+[.0-9]")


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
    if len(rows) == 1:
        _each_in_degrees(*rows)
    return rows


def _each_in_degrees(row: list[str]) -> None:
    """Raise ArmError where the last of many angles alone has a sign that may be meant for all."""
    *others, last = row
    meant = _IN_DEGREES.fullmatch(last) and all(map(is_number, others))
    if meant and any(abs(float(x)) > _TURN for x in others):
        raise ArmError(f"only {shown(last)} is in degrees; expected the sign beside each angle")


def _rows(text: str) -> Cells:
    if "\\begin{" in text or "\\\\" in text:
        return _latex(text)
    if text.count("|") == 2 and "\n" in text and text[0] == text[-1] == "|":
        text = text[1:-1].strip()  # the bars of a matrix
    if text.count("|") >= 2 and not re.match(r"[^|]*\[[^\]|]*\|", text):
        return _markdown(text)
    if turned := _TURNED.match(text):
        inner = text[turned.end() :].rstrip(" ;.,")
        if _closes_at_end(inner):
            return [[f"{turned[1]}({cell})" for cell in row] for row in _rows(inner[1:-1].strip())]
    bare = _TAIL.sub("", _WRAPPER.sub("", text)) if _WRAPPER.match(text) else text
    bare = (
        re.sub(r"^\s*[\w.]+\s*(?:\(\w+\))?\s*=\s*(?=[\[({\n\d-]|$)", "", bare)
        .strip()
        .rstrip(";")
        .strip()
    )
    bare = _opened(_ENDED.sub("", bare))
    if bare[:1] == "[":
        _untouched(bare)
    if bare[:1] in "[({" and not _begins_a_cell(bare):
        return _bracketed(bare)
    if before := _FACTOR.match(bare):
        alone(before[0], re.sub(r"[ \t]", "", before[0]))
    return _lines(bare)


def _latex(text: str) -> Cells:
    text = bare_latex(text)
    text = re.sub(r"\\left\s*[\[(.|]\s*(?=\\begin)", " ", text)
    text = re.sub(
        r"\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\c(?:line|midrule)(?:\([^()]*\))?\{[^{}]*\}"
        r"|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])",
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
    return [
        [_decimal(cell) for cell in row.split("&")]
        for row in re.split(r"\\\\|\\cr(?![A-Za-z])", text)
    ]


def _markdown(text: str) -> Cells:
    lines = [line.strip() for line in text.splitlines() if "|" in line]
    lines = [line for line in lines if not re.fullmatch(r"[\s:|+=_-]*[-=_][\s:|+=_-]*", line)]
    rows = [re.sub(r"^\||\|$", "", line).replace("$", " ").split("|") for line in lines]
    if all(len(row) == 1 and _of_numbers(row[0]) for row in rows):  # bars on each line
        return [_split(row[0]) for row in rows]
    return [[_decimal(cell) for cell in row] for row in rows]


def _of_numbers(line: str) -> bool:
    return all(is_number(plain(word)) for word in line.split())


def _decimal(cell: str) -> str:
    """A number with a decimal comma with a point; as it is where the comma may part thousands."""
    return cell.replace(",", ".") if _DECIMAL.fullmatch(cell) else cell


# Brackets


def _opened(text: str) -> str:
    """Rows on lines in one pair of round brackets, or each in its own, and a list in one, without
    them; any other text as it is.
    """
    inner = text[1:-1].strip()
    if text[:1] == "(" and _closes_at_end(text):
        if inner[:1] == "[" and _closes_at_end(inner):
            return inner
        return inner if _are_rows(inner.splitlines()) else text
    lines = [line.strip() for line in text.splitlines()]
    if all(line[:1] == "(" and _closes_at_end(line) for line in lines):
        lines = [line[1:-1].strip() for line in lines]
        return "\n".join(lines) if lines and " " in lines[0] and _are_rows(lines) else text
    return text


def _begins_a_cell(text: str) -> bool:
    """Whether the round bracket that a text begins with is a part of its first entry."""
    end = _end(text)
    inner = text[1 : max(end, 1)]
    return text[:1] == "(" and end < len(text) - 1 and not re.search(r"[,;\n]", inner)


def _are_rows(lines: list[str]) -> bool:
    """Whether lines of entries without commas are the rows of a matrix, not a formula's."""
    lines = [line for line in lines if line.strip()]
    if any("," in line or ";" in line or _CONTINUED.match(line) for line in lines):
        return False
    rows = [_split(line) for line in lines]
    if len({len(row) for row in rows}) != 1 or len(rows) == len(rows[0]) == 1:
        return False
    return all(map(_of_numbers, lines)) or (len(rows) > 1 and len(rows[0]) > 1)


def _untouched(text: str) -> None:
    """Raise ArmError where something is done to a list after it is closed."""
    end = _end(text)
    if re.search(r"[0-9][\s,;\]]", text[:end]) and _TAKEN.match(text[end + 1 :]):
        raise beside(text[end + 1 :].lstrip(" )"))


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


def _end(text: str) -> int:
    """Where the bracket that a text begins with is closed, -1 where it is not."""
    depth = 0
    for k, sign in enumerate(text):
        depth += _deeper(sign)
        if not depth:
            return k
    return -1


def _closes_at_end(text: str) -> bool:
    return text != "" and _end(text) == len(text) - 1


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
    if not pieces[-1].strip():
        pieces.pop()
    return [piece.strip().strip("'\"") for piece in pieces if comma or piece.strip()]


def _joins(text: str, k: int) -> bool:
    """Whether the blank at k stands beside a sign that joins its neighbours: ``a - b`` is one cell,
    ``a -b`` are two, and so are a joint's variable that is marked by a star and what follows it. A
    star at the end marks a joint's variable, or is one. A ``d`` marked so may as well be a factor,
    but not of a number behind it.
    """
    before, after = text[:k].rstrip(), text[k:].strip()
    if after == "*":
        return _STARRED.search(f"{before}*") is not None
    if before[-1:] == "*" and after and after[0] not in "*/^)=":
        slides = _SLIDING.search(before) and number(after.split()[0]) is not None
        if slides or _STARRED.search(before):
            return False
    if not before or not after or before[-1] in "+-*/^=(" or after[0] in "*/^)=":
        return True
    return (
        (after[0] in "+-" and len(after) > 1 and after[1].isspace())
        or _DEGREES.match(after) is not None
        or (before[-1] in "0123456789.)" and _RADIANS.match(after) is not None)
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
    lines = _unnumbered([line for line in lines if not re.fullmatch(r"\s*\w+\s*=\s*", line)])
    separator = next(
        (s for s in ("\t", ";") if any(s in line.strip().rstrip(";") for line in lines)), ""
    )
    if separator:
        return _pointed_rows(
            [line.strip("\r\n ").rstrip(separator).split(separator) for line in lines]
        )
    lines = [re.sub(r"\s*;\s*$", "", _QUOTED.sub(_of_quotes, line)) for line in lines]
    if any(_top_comma(line) for line in lines):
        return _by_commas(lines)
    lines = [re.sub(r"^\s*[\[|⎡⎢⎣⎛⎜⎝]+|[\]|⎤⎥⎦⎞⎟⎠]+\s*$", "", line) for line in lines]
    rows = [_split(line) for line in lines]
    uneven = len({len(row) for row in rows}) > 1
    torn = any(cell.lstrip("+-") in FUNCTIONS for row in rows for cell in row)
    return (_by_gaps(lines) if uneven or torn else []) or rows


def _unnumbered(lines: list[str]) -> list[str]:
    """Lines without the numbers ``1)``, ``1:`` or ``Joint 1:`` before them; raises ArmError where a
    dash before each may be a minus sign.
    """
    if len(lines) > 1 and all(map(_BULLET.match, lines)):
        given = shown(lines[0].strip())
        raise ArmError(f"each line begins like {given}; expected rows without a dash before them")
    numbers = [_NUMBERED.match(line) for line in lines]
    if all(m is not None and int(m[1]) == i for i, m in enumerate(numbers, 1)):
        return [_NUMBERED.sub("", line, count=1) for line in lines]
    return lines


def _of_quotes(match: re.Match[str]) -> str:
    """A number in quotes with a point for its decimal comma."""
    inner = match[0][1:-1].strip()
    if _EITHER.fullmatch(inner):
        raise _either(inner, shown(inner))
    pointed = _pointed(inner)
    return pointed if is_number(pointed) else match[0]


def _by_gaps(lines: list[str]) -> Cells:
    """Cells that stand two blanks apart or more, which single ones do not part, where each line has
    as many; none where not.
    """
    rows = [apart(line.strip()).split("\t") for line in lines]
    return rows if len({len(row) for row in rows}) == 1 and len(rows[0]) > 1 else []


def apart(text: str) -> str:
    """A text with a tab for each run of blanks within a line."""
    return _GAP.sub("\t", text)


def _by_commas(lines: list[str]) -> Cells:
    """Commas part cells, unless they are decimal ones: then blanks do. Raises ArmError where both
    may be meant.
    """
    by_blank = [_split(line.replace(",", ".")) for line in lines]
    if all(re.fullmatch(r"\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}", line) for line in lines):
        return by_blank
    if all(len(_TIGHT.findall(line)) == line.count(",") for line in lines):
        if by_gaps := _by_gaps([line.replace(",", ".") for line in lines]):
            return by_gaps
        even = len({len(row) for row in by_blank}) == 1
        if all(len(row) > 1 for row in by_blank):
            if even and any(_JUXTAPOSED.search(line) for line in lines):
                return by_blank
            given = shown(next(line for line in lines if "," in line).strip())
            raise ArmError(f"a line is {given}; expected decimal points, or commas between entries")
    return [_split(line.rstrip(",")) for line in lines]


def _pointed_rows(rows: Cells) -> Cells:
    """Cells with points for decimal commas; raises ArmError where a comma may part thousands."""
    found = [[_pointed(cell) for cell in row] for row in rows]
    texts = [cell.strip().strip('"') for row in rows for cell in row]
    either = next(filter(_EITHER.fullmatch, texts), None)
    pointed = next((x for x in texts if re.search(r"[0-9]\.[0-9]", x)), "")
    if either and pointed and not _DOTTED_THOUSANDS.fullmatch(pointed):
        raise _either(either, f"{shown(either)} beside {shown(pointed)}")
    return found


def _either(cell: str, given: str) -> ArmError:
    """What is said of a comma that may be a decimal one or part thousands."""
    decimal, whole = cell.replace(",", "."), cell.replace(",", "")
    return ArmError(f"a cell is {given}; expected {decimal} or {whole}")


def _pointed(cell: str) -> str:
    """A cell with a decimal comma written with a point, and without a spreadsheet's quotes or
    sign of equality.
    """
    if (inner := cell.strip())[:1] == inner[-1:] == '"':
        cell = inner[1:-1]
    cell = re.sub(r"^[ \t]*=", "", cell)
    if re.fullmatch(r"\s*[-+−]?,[0-9]+\s*", cell):
        return cell.replace(",", ".")
    if _THOUSANDS.fullmatch(cell.strip()):
        return cell.replace(",", "")
    if _DOTTED_THOUSANDS.fullmatch(cell.strip()):
        return cell.replace(".", "").replace(",", ".")
    return (
        re.sub(r"(?<=\d),(?=\d)", ".", cell) if cell.count(",") == 1 and "(" not in cell else cell
    )


def numeric(rows: Cells) -> bool:
    """Whether every cell is a number without symbols."""
    return all(number(cell) is not None for row in rows for cell in row)


def without_header(rows: Cells) -> Cells:
    """The rows without the first if it is a header: one of names where numbers follow."""
    first, *rest = rows
    words = [*filter(None, map(plain, first))]
    if not rest or any(map(_is_entry, words)):
        return rows
    unnamed = [row[1:] for row in rest]
    if not first[0] and len(words) == len(first) - 1 and _label_rows(rest) and numeric(unnamed):
        return unnamed
    return rest if numeric(rest) else rows


def _is_entry(word: str) -> bool:
    """Whether a word is a number, looks like one, or is a formula that no column is named by."""
    if number(word) is not None or _NO_HEAD.fullmatch(word) or word.lstrip("+-") in FUNCTIONS:
        return True
    try:
        parts: list = [parse(word)]
    except ArmError:
        return False
    if parts[0][0] == "neg":
        return True
    for part in parts:  # grows by its own parts
        parts += [inner for inner in part if isinstance(inner, tuple)]
    return any(part[0] == "call" for part in parts)


def _label_rows(rows: Cells) -> bool:
    """Whether the first cells are different names, or count the rows."""
    labels = [row[0] for row in rows]
    counted = [str(i) for i in range(len(rows) + 1)]
    named = len(set(labels)) == len(labels) and all(x and number(x) is None for x in labels)
    return named or labels in (counted[:-1], counted[1:])
