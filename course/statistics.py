"""Count the marks of a course by part and by mistake, and draw the counts as bars."""

import re
from collections import Counter
from collections.abc import Mapping
from io import StringIO
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from course import store
from course.grading import read_marks
from course.marking import NOT_ANSWERED
from course.sheets import list_part_names
from helpers.inputs import ArmError
from helpers.plotting.style import BLUE, GREY, ORANGE, RED

PICTURE = "statistics.svg"
_MISTAKE = re.compile(r"mistake gives: (.*?)(?:; or: .*|\.?)$", re.M)
_OUTCOMES = {"right": BLUE, "partly": ORANGE, "wrong": RED, "not answered": GREY}


def write_statistics(folder: Path, out: Path) -> str:
    """Write statistics.svg into the results.

    Returns the counts by part and by mistake as text.
    """
    course = store.load_course(folder)
    marks = [mark for marks in read_marks(folder, out, course).values() for mark in marks]
    if not marks:
        raise ArmError(f"{out} holds no marks; expected the results of grade")
    names = list_part_names(course.exercises)
    by_part = {name: [mark for mark in marks if mark["part"] == name] for name in names}
    counts = {name: Counter(map(_find_outcome, group)) for name, group in by_part.items()}
    store.write_text(out / PICTURE, _draw_outcomes(counts))
    lines = [f"{'part':12}  mean  " + "  ".join(_OUTCOMES)]
    for name, group in by_part.items():
        mean = sum(mark["credit"] for mark in group) / len(group)
        numbers = (f"{counts[name][outcome]:{len(outcome)}}" for outcome in _OUTCOMES)
        lines.append(f"{name:12}  {mean:4.2f}  {'  '.join(numbers)}")
    mistakes = Counter((m["part"], x[1]) for m in marks if (x := _MISTAKE.search(m["message"])))
    lines += ["", "times  part          mistake"]
    lines += [f"{n:5}  {part:12}  {text}" for (part, text), n in mistakes.most_common()]
    return "\n".join(lines)


def _find_outcome(mark: Mapping[str, Any]) -> str:
    if mark["credit"] == 1:
        return "right"
    if mark["credit"]:
        return "partly"
    return "not answered" if mark["message"].endswith(NOT_ANSWERED) else "wrong"


def _draw_outcomes(counts: Mapping[str, Counter[str]]) -> str:
    """Draw a bar for each part as SVG."""
    figure = Figure(figsize=(7, 1.2 + 0.3 * len(counts)), layout="constrained")
    axes = figure.add_subplot(xlabel="students")
    left = [0] * len(counts)
    for outcome, colour in _OUTCOMES.items():
        widths = [count[outcome] for count in counts.values()]
        axes.barh([*counts], widths, left=left, color=colour, edgecolor="white", label=outcome)
        left = [x + width for x, width in zip(left, widths, strict=True)]
    axes.invert_yaxis()
    axes.spines[["top", "right"]].set_visible(False)
    figure.legend(loc="outside upper center", ncols=len(_OUTCOMES), frameon=False)
    file = StringIO()
    figure.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()
