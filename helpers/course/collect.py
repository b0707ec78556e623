"""Downloads of learning platforms, sorted by student.

Canvas puts `lastfirst_12345_678_name` (LATE in between where it was) into one zip, Moodle folders
or files `First Last_12345_assignsubmission_file`, Gradescope folders `submission_12345` and beside
them who that is. Any other folder or file is taken for a student's where it bears an id or a name.
"""

import re
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from helpers.course.files import Found, in_zip, limited, walk
from helpers.course.handed_in import whose
from helpers.course.roster import People
from helpers.inputs import ArmError

FOLDER = "handed_in"  # in a student's folder
_MOODLE = re.compile(r"(.+)_(\d+)_assignsubmission_[a-z]+(?:_.*)?", re.I | re.S)
_CANVAS = re.compile(r"(.+?)(?:_late)?_(\d+)_\d+_.+", re.I | re.S)
_GRADESCOPE = "submission_metadata.yml"
_NOISE = ("__MACOSX", ".DS_Store")  # that a Mac puts into a zip
_FILES, _BYTES = 20_000, 2_000_000_000  # of a whole class


@dataclass(frozen=True)
class Collected:
    """The hand-ins by student, and what could not be placed with the reason."""

    placed: Mapping[str, tuple[Found, ...]]
    doubtful: tuple[str, ...]


def read_download(place: Path) -> tuple[Found, ...]:
    """The files of a download, a zip or a folder; raises ArmError for anything else."""
    if place.is_dir():
        return limited(
            (f for p in sorted(place.iterdir()) for f in walk(p, p.name)), _FILES, _BYTES
        )
    try:
        with place.open("rb") as file:
            return limited(in_zip(file), _FILES, _BYTES)
    except OSError as error:
        raise ArmError(f"{place} cannot be read ({error.strerror}); expected a download") from None


def sort(files: Iterable[Found], names: Mapping[str, str]) -> Collected:
    """Every file with the student it belongs to, by the roster's ids and names.

    Where a name is two students' or nobody's, the id on the sheet decides, if the name allows it.
    """
    files = [f for f in files if not {*_NOISE} & {*PurePosixPath(f.name).parts}]
    people, about = People(names), _submitters(files)
    groups = defaultdict[tuple[str, tuple[str, ...]], list[Found]](list)
    for found in files:
        if not found.name.endswith(_GRADESCOPE):
            groups[_owner(found, people, about)].append(found)
    placed, doubtful = defaultdict[str, list[Found]](list), []
    for (_, words), group in groups.items():
        student, why = _whose(words, group, people)
        if student:
            placed[student] += group
            doubtful += [str(found) for found in group if found.trouble]
        else:
            doubtful += [f"{found}: {why}" for found in group]
    return Collected({s: tuple(group) for s, group in placed.items()}, tuple(doubtful))


def _owner(
    found: Found, people: People, about: Mapping[str, tuple[str, ...]]
) -> tuple[str, tuple[str, ...]]:
    """What a platform's names of one owner's files share, and the words that mean the owner."""
    parts = PurePosixPath(found.name).parts
    for part in parts:
        if part in about:
            return part, about[part]
        if match := _MOODLE.fullmatch(part) or _CANVAS.fullmatch(part):
            return match[2], (match[1],)
    stems = [*parts[:-1], PurePosixPath(found.name).stem]
    words = [word for stem in stems for word in (stem, stem.split("_")[0])]
    known = [word for word in words if people.by_id([word]) or people.by_name(word)]
    return "", tuple(known[:1] or parts[:1])


def _whose(words: tuple[str, ...], group: Iterable[Found], people: People) -> tuple[str, str]:
    """The one student whom these words mean, or "" and why it is not clear."""
    meant = people.by_id(words) or {s for word in words for s in people.by_name(word)}
    if len(meant) == 1:
        return meant.pop(), ""
    sheets = people.by_id({whose(found) for found in group})
    if len(sheets) == 1 and (not meant or sheets <= meant):
        return sheets.pop(), ""
    who = " / ".join(words)
    if not meant:
        return "", f"{who} is nobody in the course"
    return "", f"{who} may be {' or '.join(sorted(meant))}; the sheet in it does not tell"


def _submitters(files: Iterable[Found]) -> dict[str, tuple[str, ...]]:
    """Who handed in each folder of an export of Gradescope: ids, mail addresses and names."""
    import yaml

    about: dict[str, tuple[str, ...]] = {}
    for found in files:
        if not found.name.endswith(_GRADESCOPE):
            continue
        try:
            for folder, submission in yaml.safe_load(found.content).items():
                about[str(folder)] = tuple(_words(submission[":submitters"]))
        except (yaml.YAMLError, AttributeError, KeyError, TypeError) as error:
            raise ArmError(f"{found} cannot be read: {error}") from None
    return about


def _words(submitters: Iterable[Mapping[str, Any]]) -> list[str]:
    keys = (":sid", ":email", ":name")
    return [str(who[key]) for who in submitters for key in keys if who.get(key)]


def put(collected: Collected, course: Path) -> None:
    """Write the files into each student's folder, in place of an earlier
    collection.
    """
    for student, group in collected.placed.items():
        folder, beside = course / student / FOLDER, course / student / f".{FOLDER}"
        shutil.rmtree(beside, ignore_errors=True)
        beside.mkdir(parents=True)
        for number, found in enumerate(group, 1):
            plain = re.sub(r"[^\w.() -]", "_", PurePosixPath(found.name).name, flags=re.A)[-80:]
            if not found.trouble:
                (beside / f"{number} {plain}").write_bytes(found.content)
        shutil.rmtree(folder, ignore_errors=True)
        beside.rename(folder)
