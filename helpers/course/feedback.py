"""What a student reads: the marks, the checkers' sentences, and the question beside them."""

from collections.abc import Sequence

from helpers.course.marking import Mark
from helpers.course.sheets import page
from helpers.variants import Sheet


def feedback_page(title: str, who: str, sheet: Sheet, marks: Sequence[Mark], trouble: str) -> str:
    """One page of HTML: total, a table of parts, and for each part the words; no solution is
    printed.
    """
    total = sum(mark.credit for mark in marks)
    lines = [f"# {title}: {total:g} of {len(marks)}", _plain(who)]
    if trouble:
        lines.append(f"Note: {_plain(trouble)}.")
    rows = "".join(f"\n| `{m.part}` | {m.credit:g} | {_plain(m.headline)} |" for m in marks)
    lines.append(f"| part | credit | verdict |\n|:--|--:|:--|{rows}")
    by_part = {mark.part: mark for mark in marks}
    for question in sheet.questions:
        lines.append(f"## {question.title}")
        for part in question.parts:
            mark = by_part[part.name]
            said = "\n".join(f"    {line}" for line in mark.words.splitlines()) or "    "
            lines.append(f"### `{part.name}`: {mark.credit:g}\n\n{part.what}\n\n{said}")
    return page("\n\n".join(lines), f"{title}: {who}")


def _plain(text: str) -> str:
    """Words of a student's or a roster's making without Markdown's marks."""
    return "".join(f"\\{c}" if c in "\\`*_{}[]()#+-.!|<>$" else c for c in " ".join(text.split()))
