"""Pack a file for each student so that Canvas or Moodle gives it to that student alone.

Both platforms take a zip of feedback files whose names begin as those of the downloaded hand-ins:
Canvas at "Upload Submissions" of the grade book, Moodle at "Upload multiple feedback files in a
zip". A download therefore tells the names, and different sheets go out in the same way, once each
student has handed in any small file.
"""

import zipfile
from pathlib import Path

from course.answers import NOTEBOOK_FILE
from course.collect import assign_students, group_members, read_placed
from course.files import open_download
from course.roster import StudentIndex
from course.store import Course
from helpers.inputs import ArmError

FEEDBACK_FILE = "feedback.txt"


def pack_for_platform(
    course: Course, folder: Path, download: Path, out: Path, results: Path | None = None
) -> list[str]:
    """Write a zip with the feedback, or without results the sheet, of each student.

    Args:
        course: The course.
        folder: Its folder.
        download: Hand-ins of Canvas or Moodle, a zip or a folder.
        out: The zip to write.
        results: The folder that `grade` wrote.

    Returns the students who are not in the zip, since the download has nothing of theirs.

    Raises ArmError if the download bears no names of Canvas or Moodle, or a file is missing.
    """
    index = StudentIndex(course.names)
    with open_download(download) as members:
        hand_ins, _ = group_members(members, index)
    owners, _ = assign_students(hand_ins, index, read_placed(folder, course.names))
    prefixes = {student: name.prefix for name, student in owners.items() if name.prefix}
    if not prefixes:
        raise ArmError(f"{download} has no names of Canvas or Moodle; expected their download")
    base, file_name = (results, FEEDBACK_FILE) if results else (folder, NOTEBOOK_FILE)
    missing = [student for student in prefixes if not (base / student / file_name).exists()]
    if missing:
        raise ArmError(f"{base} has no {file_name} of {', '.join(missing)}; expected one for each")
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for student, prefix in prefixes.items():
            archive.write(base / student / file_name, prefix + file_name)
    return [student for student in course.sheets if student not in prefixes]
