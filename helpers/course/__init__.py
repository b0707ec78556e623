"""A course from one command: sheets with numbers of their own, keys, and marks with reasons.

`python -m helpers.course --help` lists the commands; the instructor's page of the book shows each.
"""

from helpers.course.answers import hand_in

__all__ = ["hand_in"]
