"""Answer sheets: every A_i, T_0i, o_i, z_i, J, det J, P and g(q) of an arm, to read and to copy
into a program.

`markdown` makes a page of the book, `document` one HTML file for an arm of your own, `block` one
answer as text that can be pasted; ``python -m helpers.sheets`` writes a file from the command line.
"""

from functools import lru_cache

from helpers.arm import Arm
from helpers.inputs import one_of
from helpers.sheets.content import Sheet
from helpers.sheets.page import LANGUAGES, document, markdown

__all__ = ["block", "document", "markdown"]


def block(arm: Arm, answer: str, language: str) -> str:
    """One answer as a text that runs as it is.

    Args:
        arm: any arm.
        answer: ``A_1`` .. ``A_n``, ``T_01`` .. ``T_0n``, ``o_0`` .. ``o_n``, ``z_0`` .. ``z_n``,
            ``J``, ``det_J`` (of three or six joints), and where the arm has masses ``P`` and ``G``,
            the gravity torques.
        language: ``LaTeX`` (with amsmath), ``SymPy`` (symbols), ``NumPy`` or ``MATLAB`` (numbers,
            at the home pose).

    Raises ArmError for anything else.
    """
    sheet = _sheet(arm)
    items = {item.name: item for item in sheet.items}
    return LANGUAGES[one_of(language, "language", LANGUAGES)](
        sheet, items[one_of(answer, "answer", items)]
    )


@lru_cache(maxsize=8)
def _sheet(arm: Arm) -> Sheet:
    return Sheet(arm)
