"""Run the whole corpus and write its tables into the book: ``python -m tests.corpus.confusion``."""

from collections import Counter, defaultdict
from pathlib import Path

from tests.corpus.judge import HERE, load, outcome, report

PAGE = HERE.parents[1] / "book" / "judging.md"
TOPICS = ("jacobian", "table", "torques", "branches", "pose", "trace")
MISTAKEN = ("named", "other", "nothing", "accepted", "same arm")
GOOD = ("right", "rounded", "so far", "false alarm")
START, END = "<!-- counted -->", "<!-- end -->"


def counted(folder=HERE):
    """Every case of the corpus with its outcome: (topic, kind, digits, cause, outcome)."""
    for topic in TOPICS:
        found = load(topic, folder)
        for case in found["cases"]:
            verdict = report(case, found["arms"])
            yield (
                topic,
                case["kind"],
                case["digits"],
                case.get("cause"),
                outcome(case, found["arms"], verdict),
            )


def line(cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def by_topic(cases):
    """Rows (topic, what, how many, share of each outcome)."""
    groups = defaultdict(Counter)
    for topic, kind, digits, cause, how in cases:
        if kind == "noise":
            continue
        what = "pairs" if cause and " + " in cause else "single mistakes" if cause else "right work"
        what += ", up to 3 decimals" if cause and digits <= 3 else ", 4 and more" if cause else ""
        groups[topic, what][how] += 1
    yield line(
        ["", "work handed in", "cases", "named", "another named", "wrong, no cause", "accepted"]
    )
    yield line([":--", ":--", *["--:"] * 5])
    for (topic, what), found in sorted(
        groups.items(), key=lambda g: (TOPICS.index(g[0][0]), g[0][1])
    ):
        if what == "right work":
            continue
        count = found.total() - found["same arm"]
        yield line([topic, what, count, *(found[how] for how in MISTAKEN[:4])])


def right_work(cases):
    groups = defaultdict(Counter)
    for topic, kind, _, cause, how in cases:
        if not cause and kind != "noise":
            groups[topic][how] += 1
    yield line(["", "cases", "right", "last digit", "so far", "called wrong"])
    yield line([":--", *["--:"] * 5])
    for topic in TOPICS:
        found = groups[topic]
        yield line([topic, found.total(), *(found[how] for how in GOOD)])


def by_cause(cases):
    groups = defaultdict(Counter)
    for _, _, _, cause, how in cases:
        if cause and " + " not in cause:
            groups[cause.split(":")[0]][how] += 1
    yield line(["cause", "cases", *MISTAKEN])
    yield line([":--", *["--:"] * 6])
    for name, found in sorted(groups.items()):
        yield line([f"`{name}`", found.total(), *(found[how] or "" for how in MISTAKEN)])


def main():
    cases = list(counted())
    parts = ["### Right work", "", *right_work(cases), ""]
    parts += ["### Mistakes", "", *by_topic(cases), ""]
    parts += ["```{admonition} Each mistake by name", ":class: dropdown", ""]
    parts += [*by_cause(cases), "```"]
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(START)
    page = f"{before}{START}\n" + "\n".join(parts) + f"\n{END}{rest.split(END)[1]}"
    Path(PAGE).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
