"""Show a typed answer with each number marked by its use."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

from helpers.inputs import ArmError

_MOST_MARKS = 200  # at most this many numbers are shown, so that a notebook's output is below 30 kB
_MOST_UNREAD_LINES = 5  # at most this many lines are quoted in a message
_MOST_CHARACTERS = 100  # at most this many characters of a line are quoted

# HTML element and style of each mark. The colours are legible on white and on black. The elements
# differ too, for viewers that remove styles.
_ELEMENTS = {
    "entry": ("u", "text-decoration:underline 2px #2e9d72"),
    "wrong": ("b", "outline:2px solid #e0443e"),
    "label": ("span", "opacity:.75;border-bottom:1px dotted"),
    "given": ("u", "text-decoration:underline 2px #3f8fe0"),
    "context": ("s", "opacity:.75"),
    "unread": ("mark", "background:#ffd24d;color:#000;outline:2px dashed #b36b00"),
}
_TEXT_STYLE = "font-family:monospace;white-space:pre-wrap;line-height:1.6"


@dataclass(frozen=True)
class TextPiece:
    """A number of a text with its mark, or the characters between two numbers.

    Attributes:
        text: the piece as typed.
        kind: "entry", "wrong" (a wrong entry), "label", "given" by the question, "context" (a
            number that was set aside) or "unread"; empty between numbers.
        description: what the number was taken for.
    """

    text: str
    kind: str = ""
    description: str = ""


Line = list[TextPiece]


@dataclass(frozen=True)
class MarkedText:
    """A typed answer with marks on its numbers, shown in colour in a notebook.

    Attributes:
        pieces: the whole text, cut at the numbers.
        names: the name of each kind of mark, for the legend.
    """

    pieces: tuple[TextPiece, ...]
    names: Mapping[str, str]

    @property
    def has_notable_marks(self) -> bool:
        """Return whether a number was wrong, set aside or not read."""
        return any(map(_is_notable, self.pieces))

    def format_html(self) -> str:
        """Return the text and its legend as HTML, or "" if there are too many numbers to show."""
        lines = _select_lines(_split_lines(self.pieces))
        if not lines:
            return ""
        kinds = {piece.kind for line in lines for piece in line}
        legend = [
            f"{_format_mark(TextPiece('0.5', kind))} {name}"
            for kind, name in self.names.items()
            if kind in kinds
        ]
        text = "\n".join("".join(map(_format_mark, line)) for line in lines)
        return f'<pre style="{_TEXT_STYLE}">{text}</pre>\n<small>{" &emsp; ".join(legend)}</small>'

    def _repr_markdown_(self) -> str:
        return self.format_html()

    def __str__(self) -> str:
        """Return the lines with numbers that were not read, these in «» quotes."""
        lines = list(enumerate(_split_lines(self.pieces), 1))
        unread = [(n, line) for n, line in lines if any(p.kind == "unread" for p in line)]
        quoted = [f"line {n}: {_quote_line(line)}" for n, line in unread[:_MOST_UNREAD_LINES]]
        more = len(unread) - len(quoted)
        return "\n".join([*quoted, *([f"and {more} more lines"] if more else [])])

    __repr__ = __str__


class UnreadNumberError(ArmError):
    """Report that a number of a typed answer cannot be read, so that nothing is graded.

    Attributes:
        marked_text: the answer with its numbers marked; ``display(error.marked_text)`` shows it.
    """

    def __init__(self, message: str, marked_text: MarkedText) -> None:
        super().__init__(message)
        self.marked_text = marked_text
        self.add_note(str(marked_text))


def make_marked_text(marked: Mapping[str, Any]) -> MarkedText:
    """Return the judge's marks on a text."""
    return MarkedText(tuple(TextPiece(*piece) for piece in marked["pieces"]), marked["names"])


def _is_notable(piece: TextPiece) -> bool:
    return piece.kind in ("wrong", "context", "unread")


def _split_lines(pieces: Sequence[TextPiece]) -> list[Line]:
    """Return the pieces of each line of the text."""
    lines: list[Line] = [[]]
    for piece in pieces:
        first, *others = [piece.text] if piece.kind else piece.text.split("\n")
        lines[-1].append(TextPiece(first, piece.kind, piece.description))
        lines += [[TextPiece(text)] for text in others]
    return lines


def _select_lines(lines: list[Line]) -> list[Line]:
    """Return all lines, or the first notable lines of a text with many numbers."""
    if _count_marks(lines) <= _MOST_MARKS:
        return lines
    notable = [line for line in lines if any(map(_is_notable, line))]
    return list(_take_lines(notable))


def _take_lines(lines: list[Line]) -> Iterator[Line]:
    """Yield lines while their numbers are few enough, then an ellipsis."""
    count = 0
    for line in lines:
        count += _count_marks([line])
        if count > _MOST_MARKS:
            break
        yield line
    if count:
        yield [TextPiece("…")]


def _count_marks(lines: list[Line]) -> int:
    return sum(bool(piece.kind) for line in lines for piece in line)


def _format_mark(piece: TextPiece) -> str:
    text = _escape_markup(piece.text)
    if not piece.kind:
        return text
    title = f' title="{_escape_markup(piece.description)}"' if piece.description else ""
    element, style = _ELEMENTS[piece.kind]
    return f'<{element} style="{style}"{title}>{text}</{element}>'


def _escape_markup(text: str) -> str:
    """Escape characters that HTML, Markdown or MathJax would read as markup."""
    return escape(text).replace("$", "&#36;").replace("\\", "&#92;")


def _quote_line(line: Line) -> str:
    """Return a line from its first unread number on if it is long, with these numbers in «»."""
    text = "".join(f"«{p.text}»" if p.kind == "unread" else p.text for p in line).strip()
    if len(text) <= _MOST_CHARACTERS:
        return text
    start = max(0, text.index("«") - _MOST_CHARACTERS // 2)
    end = start + _MOST_CHARACTERS
    return f"{'…' if start else ''}{text[start:end]}{'…' if end < len(text) else ''}"
