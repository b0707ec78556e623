"""Sort the downloads of learning platforms by student.

Canvas puts files `lastfirst_12345_678_name` (with LATE after the name if late) into one zip.
Moodle makes folders or files `First Last_12345_assignsubmission_file`. Gradescope makes folders
`submission_12345` and, beside them, a file that lists who submitted them. In any other download
each file or folder bears the id or the name of its student.

Only these outer names tell whose a hand-in is, since the platform or the instructor wrote them.
Nothing inside a hand-in can place it with another student: not a file's name, not a list of
submitters, not the name of the sheet.
"""

import json
import re
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from course.files import HandedFile, Member, open_download, read_members
from course.handed_in import compare_sheet_names, find_sheet_name
from course.roster import StudentIndex, read_csv_rows
from course.store import lock_folder, write_text
from helpers.inputs import ArmError

HAND_IN_FOLDER, LATE_FILE = "handed_in", ".late"  # in a student's folder
NOT_READ_FILE = ".not_read.json"  # in a student's folder: reasons by name
PLACED_FILE = "placed.csv"  # in the folder of the course: hand-ins that the instructor placed
# The student's name ends before the first underscore that is followed by a number.
_PLATFORM_NAME = re.compile(
    r"(?P<prefix>(?P<name>.+?)(?P<late>_late)?_(?P<key>\d+)_(?:assignsubmission_[a-z]+_?|\d+_)).*",
    re.I | re.S,
)
_EXPORT_FOLDER = re.compile(r"assignment_\d+_export")  # of Gradescope
_SUBMITTERS_FILE, _SUBMITTER_KEYS = "submission_metadata.yml", (":sid", ":email", ":name")
_IGNORED = {"__MACOSX", ".DS_Store"}  # macOS adds these to a zip
_MAX_NAMES = 5  # file names in a message

Labels = tuple[str, ...]  # ids, mail addresses or names of a student


@dataclass(frozen=True)
class HandInName:
    """The outer name of a hand-in, as the platform or the instructor wrote it.

    Attributes:
        key: Text that all files of a hand-in share, such as "lovelaceada_12345".
        labels: Ids, mail addresses or names of the student.
        is_late: Whether Canvas marked it as late.
        prefix: Text that a platform puts before the student's own file name, or "".
    """

    key: str
    labels: Labels
    is_late: bool = False
    prefix: str = field(default="", compare=False)


class Collection(NamedTuple):
    """The files by student, the late students, and a message for each doubtful file."""

    files: dict[str, list[HandedFile]]
    late: set[str]
    messages: tuple[str, ...]

    @property
    def handed_in(self) -> list[str]:
        """The students with at least one readable file."""
        return [s for s, files in self.files.items() if any(not f.trouble for f in files)]


def collect_hand_ins(download: Path, names: Mapping[str, str], course: Path) -> Collection:
    """Sort the files of a class into the students' folders, replacing an earlier collection.

    Where two students share a name, or nobody has it, the instructor says in placed.csv whose the
    hand-in is. An earlier collection stays where no file of the new one can be read.

    Args:
        download: A zip or a folder.
        names: The students' names by their ids.
        course: Folder of the course.
    """
    with lock_folder(course), open_download(download) as members:
        collection = sort_by_student(members, names, read_placed(course, names))
        messages = list(collection.messages)
        for student, files in collection.files.items():
            if kept := _store_files(course / student, files, student in collection.late):
                messages.append(f"{student}: {kept}")
    return collection._replace(messages=tuple(messages))


def _store_files(folder: Path, files: Sequence[HandedFile], is_late: bool) -> str:
    """Store the files of a student; return a message if the earlier collection is kept."""
    troubles = {file.name: file.trouble for file in files if file.trouble}
    write_text(folder / NOT_READ_FILE, json.dumps(troubles) + "\n")
    target, new_folder = folder / HAND_IN_FOLDER, folder / f".{HAND_IN_FOLDER}"
    if len(troubles) == len(files) and target.exists():
        return "no file of this collection can be read, so the earlier one stays"
    shutil.rmtree(new_folder, ignore_errors=True)
    new_folder.mkdir()
    for number, file in enumerate(files, 1):
        safe_name = re.sub(r"[^\w.() -]", "_", PurePosixPath(file.name).name, flags=re.A)[-80:]
        if not file.trouble:
            (new_folder / f"{number} {safe_name}").write_bytes(file.content)
    shutil.rmtree(target, ignore_errors=True)
    new_folder.rename(target)
    (folder / LATE_FILE).unlink(missing_ok=True)
    if is_late:
        (folder / LATE_FILE).touch()
    return ""


def read_unread_files(folder: Path) -> list[HandedFile]:
    """Return the files of a student's hand-in that `collect` could not read, with the reasons."""
    path = folder / NOT_READ_FILE
    troubles = json.loads(path.read_bytes()) if path.exists() else {}
    return [HandedFile(name, trouble=trouble) for name, trouble in troubles.items()]


def read_placed(course: Path, names: Mapping[str, str]) -> dict[str, str]:
    """Read which student an instructor assigned to each hand-in, by the hand-in's key.

    Raises ArmError with every line that names no student.
    """
    path = course / PLACED_FILE
    rows = [*read_csv_rows(path)] if path.exists() else []
    problems = [
        f"line {line}: no student {row.get('id')!r}"
        for line, row in rows
        if row.get("id") not in names
    ]
    if problems:
        raise ArmError(f"{path} cannot be used; {'; '.join(problems)}")
    return {row.get("hand-in", ""): row["id"] for _, row in rows}


def sort_by_student(
    members: Iterable[Member], names: Mapping[str, str], placed: Mapping[str, str] | None = None
) -> Collection:
    """Read each hand-in, with a size limit for each, and find its student.

    Args:
        members: The files of a download.
        names: The students' names by their ids.
        placed: Ids of students by the keys of hand-ins that an instructor placed.
    """
    index = StudentIndex(names)
    hand_ins, messages = group_members(members, index)
    owners, doubts = assign_students(hand_ins, index, placed or {})
    files, late = defaultdict[str, list[HandedFile]](list), set[str]()
    for name, group in hand_ins.items():
        handed = read_members(group)
        if name not in owners:
            messages.append(_describe_unplaced(name.key, doubts[name], handed))
            continue
        student = owners[name]
        files[student] += handed
        late |= {student} if name.is_late else set()
        messages += filter(None, (_describe_doubt(file, student) for file in handed))
    return Collection(dict(files), late, tuple(messages))


def group_members(
    members: Iterable[Member], index: StudentIndex
) -> tuple[dict[HandInName, list[Member]], list[str]]:
    """Group the files of a download by their outer names; return messages about the download."""
    paths = [(PurePosixPath(member.name), member) for member in members]
    paths = [(path, member) for path, member in paths if not _IGNORED & {*path.parts}]
    roots = {path.parts[0] for path, _ in paths if path.parts}
    if len(roots) == 1 and _EXPORT_FOLDER.fullmatch(min(roots)):
        paths = [(PurePosixPath(*path.parts[1:]), member) for path, member in paths]
    submitters, messages = dict[str, Labels](), list[str]()
    hand_ins = defaultdict[HandInName, list[Member]](list)
    for path, member in paths:
        if str(path) == _SUBMITTERS_FILE:
            try:
                submitters = _read_submitters(member.read())
            except ArmError as error:
                messages.append(f"passed over: {error}")
    for path, member in paths:
        if str(path) != _SUBMITTERS_FILE:
            hand_ins[_read_outer_name(path, index, submitters)].append(member)
    return hand_ins, messages


def _read_outer_name(
    path: PurePosixPath, index: StudentIndex, submitters: Mapping[str, Labels]
) -> HandInName:
    """Return what the first part of a path reveals about its student."""
    outer = path.parts[0] if path.parts else ""
    if outer in submitters:
        return HandInName(outer, submitters[outer])
    if match := _PLATFORM_NAME.fullmatch(outer):
        prefix = f"{outer}/" if len(path.parts) > 1 else match["prefix"]
        key = f"{match['name']}_{match['key']}"
        return HandInName(key, (match["name"],), bool(match["late"]), prefix)
    stem = outer if len(path.parts) > 1 else path.stem
    label = next((x for x in (stem, stem.split("_")[0]) if index.find_students([x])), stem)
    return HandInName(label, (label,))


def assign_students(
    hand_ins: Iterable[HandInName], index: StudentIndex, placed: Mapping[str, str]
) -> tuple[dict[HandInName, str], dict[HandInName, str]]:
    """Return the student of each hand-in, or the reason why it cannot be assigned."""
    owners, doubts = dict[HandInName, str](), dict[HandInName, str]()
    for name in hand_ins:
        candidates = {placed[name.key]} if name.key in placed else index.find_students(name.labels)
        if len(candidates) == 1:
            owners[name] = candidates.pop()
        else:
            label = " / ".join(name.labels)
            may_be = f"may be {' or '.join(sorted(candidates))}"
            doubts[name] = f"{label} {may_be if candidates else 'is nobody in the course'}"
    claims = defaultdict[str, list[HandInName]](list)
    for name, student in owners.items():
        if name.key not in placed and not index.is_id(name.labels):
            claims[student].append(name)
    for student, rivals in claims.items():
        if len({name.key for name in rivals}) > 1:
            keys = " and ".join(sorted({name.key for name in rivals}))
            for name in rivals:
                del owners[name]
                doubts[name] = f"{keys} both bear the name of {student}"
    return owners, doubts


def _describe_unplaced(key: str, reason: str, files: Sequence[HandedFile]) -> str:
    """Describe a hand-in without a student, and what the instructor can do."""
    names = [str(file) for file in files]
    more = f" and {len(names) - _MAX_NAMES} more" if len(names) > _MAX_NAMES else ""
    sheets = sorted({owner for file in files if (owner := _find_sheet_student(file))})
    claim = f"; its sheet names {' and '.join(sheets)}" if sheets else ""
    return (
        f"not placed: {key}: {reason}{claim}. Its files: {', '.join(names[:_MAX_NAMES])}{more}. If"
        f" you know whose it is, write {key!r} and the id into {PLACED_FILE} (columns hand-in, id)"
    )


def _describe_doubt(file: HandedFile, student: str) -> str:
    """Return a message about an assigned file that the instructor should check, or ""."""
    if file.trouble:
        return f"not read: {student}: {file}"
    other = compare_sheet_names(_find_sheet_student(file) or None, student)
    return f"placed with {student}, but look at it: {file}: {other}" if other else ""


def _find_sheet_student(file: HandedFile) -> str:
    """Return the id of the student whose sheet a file answers, or ""."""
    return find_sheet_name(file).rpartition("/")[2].partition("#")[0]


def _read_submitters(file: HandedFile) -> dict[str, Labels]:
    """Read from an export of Gradescope which students submitted each folder.

    Every value is read as text, so that an id such as 007 keeps its zeros.
    """
    import yaml  # installed with the extra [course]

    class TextLoader(yaml.BaseLoader):
        def compose_node(self, parent: Any, index: Any) -> Any:
            if self.check_event(yaml.AliasEvent):
                raise ArmError("it has aliases, which Gradescope does not write")
            return super().compose_node(parent, index)

    try:
        return {
            folder: tuple(
                label
                for person in entry[":submitters"]
                for key in _SUBMITTER_KEYS
                if (label := person.get(key, "")) not in ("", "null", "~")
            )
            for folder, entry in yaml.load(file.content, TextLoader).items()
        }
    except (yaml.YAMLError, ArmError, ValueError, AttributeError, KeyError, TypeError,
            RecursionError) as error:  # fmt: skip
        raise ArmError(f"{file} cannot be read: {error!r}"[:300]) from None
