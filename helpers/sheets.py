"""Old name of `answers`, kept for one more edition.

``python -m helpers.sheets`` runs ``python -m answers``.
"""

import warnings

from answers import make_html_sheet as document
from answers import make_markdown_sheet as markdown

__all__ = ["document", "markdown"]

_IS_COMMAND = __name__ == "__main__"
# Python shows a DeprecationWarning only where it points at the program that was started.
warnings.warn(
    "helpers.sheets is now called answers, and will go in the next edition: say"
    f" {'python -m answers' if _IS_COMMAND else 'from answers import make_html_sheet'}",
    DeprecationWarning,
    stacklevel=1 if _IS_COMMAND else 2,
)

if _IS_COMMAND:
    from answers.__main__ import main

    main()
