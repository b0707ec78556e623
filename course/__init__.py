"""Make and mark a course whose students each get their own numbers.

`python -m course --help` lists the commands; the instructors' page of the book shows each.
"""
