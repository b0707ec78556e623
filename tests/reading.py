"""The judge's reader under Node.js: what it makes of a text on the way to numbers."""

from helpers.checks.tables import format_table
from helpers.inputs import ArmError
from tests.node import ask_node


def asked(job, **given):
    found = ask_node("judge_reading.mjs", {"job": job, **given})
    if "refused" in found:
        raise ArmError(found["refused"])
    return found["answer"]


def formula(text, what="the formula", **known):
    """The names in a formula and its value with these; None for the names alone."""
    return asked("formula", text=text, what=what, known=known)


def tables(held, *, values=(), kinds=(), **options):
    """The readings of a table, the likeliest first, each with what it was meant as."""
    pairs = [list(pair) for pair in dict(values).items()]
    return asked("tables", text=format_table(held), options=options, values=pairs, kinds=kinds)


def rows(table):
    """A table's rows as meant: kind, a, alpha, d, theta."""
    names = ("kind", "a", "alpha", "d", "theta")
    return [tuple(row[name] for name in names) for row in table["meant"]["rows"]]
