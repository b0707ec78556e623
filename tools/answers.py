"""A Sphinx extension that writes the answer sheets of the book's arms, book/answers/*.md.

It writes them before Sphinx looks for pages, and only if a file that they are made from has
changed.
"""

from dataclasses import replace
from hashlib import sha256
from math import pi
from pathlib import Path
from typing import NamedTuple

import sympy as sp
from sphinx.application import Sphinx

from answers import make_markdown_sheet
from helpers.arm import Arm
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK

ROOT = Path(__file__).parents[1]

INSTRUCTIONS = """
:::{container} screen
Every answer is folded under its question: try first, then open it. The buttons copy an answer as a
block that needs no editing: LaTeX for a document with `amsmath`, Python for SymPy (everything a
symbol) or NumPy (numbers), and MATLAB, which GNU Octave reads too.
:::

The formulas and the numbers of this page are computed, and tested against each other. To see
whether your own answer is another way of writing the same, give it to
[the checkers](../check_your_homework.ipynb).
"""


DESCRIPTION = (
    "every link matrix, frame, Jacobian and torque in symbols and numbers,"
    " to copy as LaTeX, Python or MATLAB."
)


class SheetPage(NamedTuple):
    """An answer sheet of the book.

    `arms` share its formulas and differ in their numbers.
    """

    name: str
    heading: str
    introduction: str
    arms: tuple[Arm, ...]


BENT = (0, -pi / 3, pi / 3, -pi / 2, -pi / 2, 0)

PAGES = (
    SheetPage(
        "panda",
        "Panda",
        "The Panda with its pen and all seven joints. Homework and real arm share every formula;"
        " they differ in the number for $a_3$, and with it in where the"
        " centres of mass of links 3 and 4 lie in their frames, so numbers are given for both."
        " [Panda, joint 3 locked at 0](panda_joint_3_locked.md) is the arm that draws the circle."
        " Its inverse kinematics:"
        " [a numeric solver](../05_inverse_kinematics.ipynb#sec-numeric-inverse).",
        (PANDA_HOMEWORK, PANDA),
    ),
    SheetPage(
        "panda_joint_3_locked",
        "Panda, joint 3 locked at 0",
        "The Panda as the homework uses it: joint 3 stays at 0, row 3 is fixed, and the Jacobian"
        " is square. Axes 2 and 4 are"
        " parallel now, so their angles join: $q_2 - q_4$. Its inverse kinematics:"
        " [one equation in one unknown](../05_inverse_kinematics.ipynb#sec-locked-panda).",
        (PANDA_HOMEWORK.lock(3), PANDA.lock(3)),
    ),
    SheetPage(
        "ur10e_homework",
        "UR10e, the homework's table",
        "The arm of the homework, whose lengths are those of a UR10. The homework gives it no"
        " masses, so gravity is"
        " worked out for [the maker's UR10e](ur10e.md). Its inverse kinematics:"
        " [eight branches](../further/ur10e_by_hand.ipynb#sec-ur-inverse).",
        (UR10E_HOMEWORK,),
    ),
    SheetPage(
        "ur10e",
        "UR10e, the maker's table",
        "The arm as its maker describes it, with the homework's pen. Numbers are given at a bent"
        " configuration, for at home the arm"
        " stands upright and weighs on no joint. Its inverse kinematics:"
        " [eight branches](../further/ur10e_by_hand.ipynb#sec-ur-inverse).",
        (replace(UR10E, home=BENT),),
    ),
    SheetPage(
        "stanford",
        "Stanford arm",
        "Two turns, a slide and a wrist. Joint 3 slides, so its column of the Jacobian is"
        " $z_2$ over 0. The"
        " homework gives it no masses, so there is no gravity here. Its inverse kinematics, in one"
        " block of formulas: [chapter 5](../05_inverse_kinematics.ipynb#sec-decoupling).",
        (STANFORD,),
    ),
    SheetPage(
        "elbow",
        "Elbow arm",
        "The arm of three joints without an offset at its shoulder."
        " [Elbow arm with an offset](elbow_with_offset.md) has one. Its inverse kinematics, in one"
        " block of formulas: [chapter 5](../05_inverse_kinematics.ipynb#sec-elbow-inverse).",
        (ELBOW,),
    ),
    SheetPage(
        "elbow_with_offset",
        "Elbow arm with an offset",
        "The arm of three joints whose shoulder stands out by $d$. With $d = 0$ it is"
        " the [elbow arm](elbow.md). Its inverse kinematics:"
        " [chapter 5](../05_inverse_kinematics.ipynb#sec-elbow-offset).",
        (replace(ELBOW.with_values(d=0.1), name="Elbow arm with an offset"),),
    ),
)


def page_markdown(page: SheetPage) -> str:
    """Return the Markdown text of a page."""
    arm, *more_arms = page.arms
    introduction = f"{page.introduction}\n{INSTRUCTIONS.rstrip()}"
    description = f"{page.heading}: {DESCRIPTION}"
    return make_markdown_sheet(arm, page.heading, introduction, tuple(more_arms), description)


def write_pages(folder: Path, fingerprint: str) -> None:
    """Write the changed pages, unless the last fingerprint is the same."""
    fingerprint_file = folder / ".made"
    paths = {page: folder / f"{page.name}.md" for page in PAGES}
    are_complete = all(path.exists() for path in (fingerprint_file, *paths.values()))
    if are_complete and fingerprint_file.read_text("utf-8") == fingerprint:
        return
    folder.mkdir(exist_ok=True)
    for page, path in paths.items():
        text = page_markdown(page)
        # Do not write unchanged pages, because Sphinx would read them again.
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
    fingerprint_file.write_text(fingerprint, "utf-8")


def list_sources() -> list[Path]:
    """Return the files from which the pages are made, including style and script of a sheet."""
    modules = (path for room in ("helpers", "answers") for path in (ROOT / room).rglob("*.py"))
    return [Path(__file__), *sorted(modules), *sorted((ROOT / "answers/static").iterdir())]


def compute_fingerprint() -> str:
    """Return a hash of all sources and of SymPy's version."""
    parts = [sp.__version__.encode(), *(path.read_bytes() for path in list_sources())]
    return sha256(b"".join(parts)).hexdigest()


def write_before_build(app: Sphinx) -> None:
    write_pages(Path(app.srcdir, "answers"), compute_fingerprint())


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("builder-inited", write_before_build)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
