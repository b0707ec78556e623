"""Write answer sheets: every A_i, T_0i, o_i, z_i, J, det J, P and g(q) of an arm.

A sheet is for reading and for copying into programs. `markdown` makes a page of the book,
`document` one HTML file for any arm;
``python -m answers`` writes a file from the command line.
"""

from answers.page import document, markdown

__all__ = ["document", "markdown"]
