"""Sort the downloads of learning platforms by student.

Canvas puts files `lastfirst_12345_678_name` (with LATE after the name if late) into one zip.
Moodle makes folders or files `First Last_12345_assignsubmission_file`. Gradescope makes folders
`submission_12345` and a file that lists who submitted them. Any other folder or file belongs to
the student whose id or name it bears.
"""

import re
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePosixPath

from course.files import HandedFile, read_files
from course.handed_in import compare_sheet_names, find_sheet_name
from course.roster import StudentIndex
from helpers.inputs import ArmError

HAND_IN_FOLDER, LATE_FILE = "handed_in", ".late"  # in a student's folder
_MOODLE = re.compile(r"(?P<name>.+)_(?P<key>\d+)_assignsubmission_[a-z]+(?:_.*)?", re.I | re.S)
_CANVAS = re.compile(r"(?P<name>.+?)(?P<late>_late)?_(?P<key>\d+)_\d+_.+", re.I | re.S)
_GRADESCOPE, _KEYS = "submission_metadata.yml", (":sid", ":email", ":name")
_IGNORED = {"__MACOSX", ".DS_Store"}  # macOS adds these to a zip

Labels = tuple[str, ...]  # ids, mail addresses or names of a student
SortedFiles = tuple[dict[str, list[HandedFile]], Labels]


def collect_hand_ins(download: Path, names: Mapping[str, str], course: Path) -> SortedFiles:
    """Put the files of a class into the students' folders, in place of an earlier collection.

    Files belong to students by the roster's ids and names. If a name is shared by several
    students, or by none, the id on the sheet decides, as far as the name allows it.

    Args:
        download: A zip or a folder.
        names: The students' names by their ids.
        course: Folder of the course.

    Returns:
        The files by student, and a message for each file that must be looked at by hand.
    """
    if not download.exists():
        raise ArmError(f"{download} is not there; expected a download")
    files = read_files(download, max_files=20_000, max_bytes=2_000_000_000)
    placed, messages = sort_by_student(files, names)
    for student, group in placed.items():
        folder, new_folder = (
            course / student / HAND_IN_FOLDER,
            course / student / f".{HAND_IN_FOLDER}",
        )
        shutil.rmtree(new_folder, ignore_errors=True)
        new_folder.mkdir(parents=True)
        for number, file in enumerate(group, 1):
            safe_name = re.sub(r"[^\w.() -]", "_", PurePosixPath(file.name).name, flags=re.A)[-80:]
            if not file.trouble:
                (new_folder / f"{number} {safe_name}").write_bytes(file.content)
        shutil.rmtree(folder, ignore_errors=True)
        new_folder.rename(folder)
        late_file = course / student / LATE_FILE
        late_file.unlink(missing_ok=True)
        if any(map(_is_marked_late, group)):
            late_file.touch()
    return placed, messages


def _is_marked_late(file: HandedFile) -> bool:
    """Return whether Canvas named a file as late."""
    matches = map(_CANVAS.fullmatch, PurePosixPath(file.name).parts)
    return any(match and match["late"] for match in matches)


def sort_by_student(files: Iterable[HandedFile], names: Mapping[str, str]) -> SortedFiles:
    """Sort files by their students, with a message for each doubtful file."""
    files = [file for file in files if not _IGNORED & {*PurePosixPath(file.name).parts}]
    submitter_lists = [file for file in files if file.name.endswith(_GRADESCOPE)]
    submitters = {
        folder: labels
        for file in submitter_lists
        for folder, labels in _read_submitters(file).items()
    }
    index, groups = StudentIndex(names), defaultdict[tuple[str, Labels], list[HandedFile]](list)
    for file in files:
        if file not in submitter_lists:
            groups[_find_owner_labels(file, index, submitters)].append(file)
    placed, messages = defaultdict[str, list[HandedFile]](list), list[str]()
    for (_, labels), group in groups.items():
        student, reason = _find_student(labels, group, index)
        if student:
            placed[student] += group
        messages += filter(None, (_describe_doubt(file, student, reason) for file in group))
    return placed, tuple(messages)


def _find_sheet_owner(file: HandedFile) -> str:
    """Return the id of the student whose sheet a file answers, or ""."""
    return find_sheet_name(file).rpartition("/")[2].partition("#")[0]


def _describe_doubt(file: HandedFile, student: str, reason: str) -> str:
    """Return a message about a file that needs a look, or "" if it is surely the student's."""
    if reason or file.trouble:
        return f"not placed: {file}: {reason}".removesuffix(": ")
    other = compare_sheet_names(_find_sheet_owner(file) or None, student)
    return f"placed with {student}, but look at it: {file}: {other}" if other else ""


def _find_owner_labels(
    file: HandedFile, index: StudentIndex, submitters: Mapping[str, Labels]
) -> tuple[str, Labels]:
    """Return a key that files of an owner share, and labels of the owner."""
    parts = PurePosixPath(file.name).parts
    for part in parts:
        if part in submitters:
            return part, submitters[part]
        if match := _MOODLE.fullmatch(part) or _CANVAS.fullmatch(part):
            return match["key"], (match["name"],)
    stems = [*parts[:-1], PurePosixPath(file.name).stem]
    labels = [label for stem in stems for label in (stem, stem.split("_")[0])]
    return "", tuple([label for label in labels if index.find_students([label])][:1] or parts[:1])


def _find_student(
    labels: Labels, group: Iterable[HandedFile], index: StudentIndex
) -> tuple[str, str]:
    """Return the id of the student whom labels mean, or "" and the reason for doubt."""
    candidates = index.find_students(labels)
    if len(candidates) == 1:
        return candidates.pop(), ""
    sheet_owners = index.find_students({_find_sheet_owner(file) for file in group})
    if len(sheet_owners) == 1 and (not candidates or sheet_owners <= candidates):
        return sheet_owners.pop(), ""
    name = " / ".join(labels)
    if not candidates:
        return "", f"{name} is nobody in the course"
    return "", f"{name} may be {' or '.join(sorted(candidates))}; the sheet in it does not tell"


def _read_submitters(file: HandedFile) -> dict[str, Labels]:
    """Read the labels of who submitted each folder of an export of Gradescope."""
    import yaml  # of the extra [course]

    submitters = {}
    try:
        for folder, entry in yaml.safe_load(file.content).items():
            labels = [person.get(key) for person in entry[":submitters"] for key in _KEYS]
            submitters[folder] = tuple(map(str, filter(None, labels)))
    except (yaml.YAMLError, AttributeError, KeyError, TypeError) as error:
        raise ArmError(f"{file} cannot be read: {error}") from None
    return submitters
