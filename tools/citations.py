"""What stands in place of a citation in a copy that knows no bibliography."""

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from pybtex.database import Entry, parse_file

BIBLIOGRAPHY = Path(__file__).parents[1] / "book/references.bib"


@cache
def works() -> Mapping[str, Entry]:
    return parse_file(BIBLIOGRAPHY).entries


def in_words(keys: str) -> str:
    """The works of a citation, as Craig 2018."""
    cited = [works()[key] for key in keys.split(",")]
    return "; ".join(f"{_authors(work)} {work.fields['year']}" for work in cited)


def listed(key: str) -> str:
    """A work as a line of a list."""
    work = works()[key]
    address = work.fields.get("url", "")
    words = f"- {_authors(work)}: *{work.fields['title']}*, {work.fields['year']}. {address}"
    return re.sub(r"[{}]", "", words).strip()


def _authors(work: Entry) -> str:
    """The last names of up to two authors, or the first and others."""
    names = [" ".join(who.last_names) for who in work.persons.get("author", [])]
    words = f"{names[0]} and others" if len(names) > 2 else " and ".join(names)
    return re.sub(r"[{}]", "", words)
