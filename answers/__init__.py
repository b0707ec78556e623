"""Write answer sheets with the matrices, Jacobian and torques of an arm.

A sheet is for reading and for copying into programs. `make_markdown_sheet`
makes a page of the book, `make_html_sheet` an HTML file for any arm. ``python -m answers`` writes
that file.
"""

from answers.page import make_html_sheet, make_markdown_sheet

__all__ = ["make_html_sheet", "make_markdown_sheet"]
