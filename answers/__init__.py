"""Write answer sheets with the matrices, Jacobian and torques of an arm.

A sheet is for reading and for copying into programs. `markdown` makes a page of the book, and
`document` makes an HTML file for any arm. ``python -m answers`` writes that file.
"""

from answers.page import document, markdown

__all__ = ["document", "markdown"]
