"""Answer sheets: every A_i, T_0i, o_i, z_i, J, det J, P and g(q) of an arm, to read and to copy
into a program.

`markdown` makes a page of the book, `document` one HTML file for an arm of your own;
``python -m answers`` writes a file from the command line.
"""

from answers.page import document, markdown

__all__ = ["document", "markdown"]
