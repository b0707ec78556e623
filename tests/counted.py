"""Count what the checkers make of hand-ins: `python -m tests.hand_ins`, whose four figures it
prints; with `--write` the tables of the book's page on how the checkers judge."""

import argparse
import math
from collections import Counter
from pathlib import Path

from tests.hand_ins import PARTS, HandIn, hand_ins, verdict

PAGE = Path(__file__).parents[1] / "book" / "judging.md"
START, END = "<!-- counted -->", "<!-- end -->"
TOPICS = ("table", "jacobian", "torques", "branches", "pose", "run")
GOOD = ("right", "last digit", "so far", "left out", "called wrong", "refused")
MISTAKEN = ("named", "not named", "no cause", "false cause", "passed", "refused")
SHOWN = {"called wrong", "false cause", "not named", "passed", "refused", "left out"}


def interval(count: int, of: int) -> str:
    """A share in percent with Wilson's interval of 95 %."""
    if not of:
        return "-"
    z, p = 1.96, count / of
    middle, half = p + z * z / 2 / of, z * math.sqrt(p * (1 - p) / of + (z / 2 / of) ** 2)
    low, high = ((middle + s * half) / (1 + z * z / of) for s in (-1, 1))
    return f"{count} of {of}: {100 * p:.2f} % ({100 * max(0, low):.2f} to {100 * high:.2f} %)"


def figures(cases: list[tuple]) -> list[str]:
    """The figures that the checkers promise, of (topic, kind, causes, word)."""
    right = [word for _, kind, _, word in cases if kind == "right"]
    wrong = [(kind, word) for _, kind, _, word in cases if kind != "right"]
    mistaken = len(wrong)
    said = [
        ("right work called wrong", interval(right.count("called wrong"), len(right))),
        ("wrong called right", interval(sum(w == "passed" for _, w in wrong), mistaken)),
        ("false cause", interval(sum(w == "false cause" for _, w in wrong), mistaken)),
        ("refused", interval(sum(case[-1] == "refused" for case in cases), len(cases))),
        ("right, but said to leave out a number", interval(right.count("left out"), len(right))),
    ]
    for kind in ("single", "pair"):
        words = [w for k, w in wrong if k == kind]
        said.append((f"{kind} mistakes named", interval(words.count("named"), len(words))))
    for topic in TOPICS:
        words = [w for t, kind, _, w in cases if (t, kind) == (topic, "single")]
        said.append((f"of {topic} named", interval(words.count("named"), len(words))))
    return [f"{name + ':':40} {found}" for name, found in said]


def line(cells) -> str:
    return "| " + " | ".join(map(str, cells)) + " |"


def grouped(cases, by, words, heads):
    """A table of how often each word was said, by what `by` makes of a case (None: none)."""
    groups: dict = {}
    for case in cases:
        for key in by(case):
            groups.setdefault(key, Counter())[case[-1]] += 1
    yield line([*heads, "cases", *words])
    yield line([":--"] * len(heads) + ["--:"] * (len(words) + 1))
    for key, found in groups.items():
        yield line([*key, found.total(), *(found[word] or "" for word in words)])


def by_topic(case):
    yield (case[0],)


def by_kind(case):
    yield case[0], {"single": "one mistake", "pair": "two at once", "noise": "by chance"}[case[1]]


def by_cause(case):
    for name in sorted({cause.split(":")[0] for cause in case[2]}):
        yield (f"`{name}`",)


def written(cases) -> str:
    def order(case):
        return TOPICS.index(case[0]), case[1] != "single", case[1]

    cases = sorted(cases, key=order)
    right = [case for case in cases if case[1] == "right"]
    wrong = [case for case in cases if case[1] != "right"]
    single = sorted((c for c in wrong if c[1] == "single"), key=lambda c: sorted(c[2]))
    parts = ["### Right work", "", *grouped(right, by_topic, GOOD, [""]), ""]
    parts += ["### Mistakes", "", *grouped(wrong, by_kind, MISTAKEN, ["", ""]), ""]
    parts += ["```{admonition} Each mistake by name", ":class: dropdown", ""]
    parts += [*grouped(single, by_cause, MISTAKEN, ["cause"]), "```"]
    return "\n".join(parts)


def show(h: HandIn, word: str, report) -> None:
    print("-" * 80, word, h.topic, h.dressed, sorted(h.causes or ()), h.text[:3000], "=>", report,
          sep="\n", flush=True)  # fmt: skip


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, nargs="+", default=[1])
    parser.add_argument("--count", type=int, default=5000, help="of each seed")
    parser.add_argument("--part", choices=PARTS, default="unread")
    parser.add_argument("--show", action="store_true", help="print those that went astray")
    parser.add_argument("--write", action="store_true", help="write the tables of the book's page")
    said = parser.parse_args(arguments)
    cases = []
    for h in (h for seed in said.seed for h in hand_ins(said.part, seed, said.count)):
        word, report = verdict(h)
        cases.append((h.topic, h.kind, h.causes, word))
        if said.show and word in SHOWN:
            show(h, word, report)
    print("\n".join(figures(cases)))
    if said.write:
        text = PAGE.read_text(encoding="utf-8")
        before, rest = text.split(START)
        page = f"{before}{START}\n{written(cases)}\n{END}{rest.split(END)[1]}"
        PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
