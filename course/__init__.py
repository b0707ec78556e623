"""A course from one command: sheets with numbers of their own, keys, and marks with reasons.

`python -m course --help` lists the commands; the instructors' page of the book shows each.
"""
