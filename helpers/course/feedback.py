"""What a student reads: the marks, the checkers' sentences, and the question beside them."""

from collections.abc import Sequence

from helpers.course.marking import Mark
from helpers.course.sheets import page
from helpers.course.store import Course
from helpers.variants import Sheet


def feedback_page(
    course: Course, sheet: Sheet, student: str, name: str, marks: Sequence[Mark], trouble: str
) -> str:
    """One page of HTML: total, a table of parts, and for each part the words; no solution is
    printed.
    """
    total = sum(mark.credit for mark in marks)
    lines = [f"# {course.title}: {total:g} of {len(marks)}", f"{_plain(name)} ({student})"]
    if trouble:
        lines.append(f"Note: {_plain(trouble)}.")
    lines.append("| part | credit | verdict |\n|:--|--:|:--|")
    lines[-1] += "".join(f"\n| `{m.part}` | {m.credit:g} | {_plain(m.headline)} |" for m in marks)
    by_part = {mark.part: mark for mark in marks}
    for question in sheet.questions:
        lines.append(f"## {question.title}")
        for part in question.parts:
            mark = by_part[part.name]
            lines.append(
                f"### `{part.name}`: {mark.credit:g}\n\n{part.what}\n\n{_quoted(mark.words)}"
            )
    return page("\n\n".join(lines), None, f"{course.title}: {student}")


def _plain(text: str) -> str:
    """Words of a student's or a roster's making without Markdown's marks."""
    return "".join(f"\\{c}" if c in "\\`*_{}[]()#+-.!|<>$" else c for c in " ".join(text.split()))


def _quoted(words: str) -> str:
    return "\n".join(f"    {line}" for line in words.splitlines()) or "    "
