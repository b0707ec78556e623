"""Downloads of learning platforms, sorted by student.

Canvas puts `lastfirst_12345_678_name` (LATE in between where it was) into one zip, Moodle folders
or files `First Last_12345_assignsubmission_file`, Gradescope folders `submission_12345` and beside
them who that is. Any other folder or file is taken for a student's where it bears an id or a name.
"""

import re
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePosixPath

from course.files import HandedFile, read_files
from course.handed_in import compare_sheet_names, find_sheet_name
from course.roster import People
from helpers.inputs import ArmError

FOLDER = "handed_in"  # in a student's folder
_MOODLE = re.compile(r"(.+)_(\d+)_assignsubmission_[a-z]+(?:_.*)?", re.I | re.S)
_CANVAS = re.compile(r"(.+?)(?:_late)?_(\d+)_\d+_.+", re.I | re.S)
_GRADESCOPE, _KEYS = "submission_metadata.yml", (":sid", ":email", ":name")
_NOISE = {"__MACOSX", ".DS_Store"}  # that a Mac puts into a zip

Words = tuple[str, ...]


def collect(
    download: Path, names: Mapping[str, str], course: Path
) -> tuple[dict[str, list[HandedFile]], Words]:
    """Put the files of a whole class, a zip or a folder, into the students' folders of a course, in
    place of an earlier collection; the files by student, and what could not be placed, with why.

    They are found by the roster's ids and names. Where a name is two students' or nobody's, the id
    on the sheet decides, if the name allows it.
    """
    if not download.exists():
        raise ArmError(f"{download} is not there; expected a download")
    found = read_files(download, max_files=20_000, max_bytes=2_000_000_000)
    placed, doubtful = sort(found, names)
    for student, group in placed.items():
        folder, beside = course / student / FOLDER, course / student / f".{FOLDER}"
        shutil.rmtree(beside, ignore_errors=True)
        beside.mkdir(parents=True)
        for number, file in enumerate(group, 1):
            plain = re.sub(r"[^\w.() -]", "_", PurePosixPath(file.name).name, flags=re.A)[-80:]
            if not file.trouble:
                (beside / f"{number} {plain}").write_bytes(file.content)
        shutil.rmtree(folder, ignore_errors=True)
        beside.rename(folder)
    return placed, doubtful


def sort(
    found: Iterable[HandedFile], names: Mapping[str, str]
) -> tuple[dict[str, list[HandedFile]], Words]:
    """The files by the student they belong to, and what belongs to none for sure, with why."""
    files = [file for file in found if not _NOISE & {*PurePosixPath(file.name).parts}]
    told = [file for file in files if file.name.endswith(_GRADESCOPE)]
    submitters = {folder: words for file in told for folder, words in _submitters(file).items()}
    people, groups = People(names), defaultdict[tuple[str, Words], list[HandedFile]](list)
    for file in files:
        if file not in told:
            groups[_owner(file, people, submitters)].append(file)
    placed, doubtful = defaultdict[str, list[HandedFile]](list), list[str]()
    for (_, words), group in groups.items():
        student, why = _whose(words, group, people)
        if student:
            placed[student] += group
        doubtful += filter(None, (_doubt(file, student, why) for file in group))
    return placed, tuple(doubtful)


def _student_of(file: HandedFile) -> str:
    """Return the student whose sheet a file answers, or ""."""
    return find_sheet_name(file).rpartition("/")[2].partition("#")[0]


def _doubt(file: HandedFile, student: str, why: str) -> str:
    """Say what must be looked at by hand; "" for a file that is surely the student's."""
    if why or file.trouble:
        return f"not placed: {file}: {why}".removesuffix(": ")
    other = compare_sheet_names(_student_of(file) or None, student)
    return f"placed with {student}, but look at it: {file}: {other}" if other else ""


def _owner(file: HandedFile, people: People, submitters: Mapping[str, Words]) -> tuple[str, Words]:
    """Find the shared part of one owner's file names, and the words that name the owner."""
    parts = PurePosixPath(file.name).parts
    for part in parts:
        if part in submitters:
            return part, submitters[part]
        if match := _MOODLE.fullmatch(part) or _CANVAS.fullmatch(part):
            return match[2], (match[1],)
    stems = [*parts[:-1], PurePosixPath(file.name).stem]
    words = [word for stem in stems for word in (stem, stem.split("_")[0])]
    return "", tuple([word for word in words if people.called([word])][:1] or parts[:1])


def _whose(words: Words, group: Iterable[HandedFile], people: People) -> tuple[str, str]:
    """The one student whom these words mean, or "" and why it is not clear."""
    meant = people.called(words)
    if len(meant) == 1:
        return meant.pop(), ""
    sheets = people.called({_student_of(file) for file in group})
    if len(sheets) == 1 and (not meant or sheets <= meant):
        return sheets.pop(), ""
    who = " / ".join(words)
    if not meant:
        return "", f"{who} is nobody in the course"
    return "", f"{who} may be {' or '.join(sorted(meant))}; the sheet in it does not tell"


def _submitters(file: HandedFile) -> dict[str, Words]:
    """Who handed in each folder of an export of Gradescope: ids, mail addresses and names."""
    import yaml  # of the extra [course]

    found = {}
    try:
        for folder, about in yaml.safe_load(file.content).items():
            told = [who.get(key) for who in about[":submitters"] for key in _KEYS]
            found[folder] = tuple(map(str, filter(None, told)))
    except (yaml.YAMLError, AttributeError, KeyError, TypeError) as error:
        raise ArmError(f"{file} cannot be read: {error}") from None
    return found
