"""Read files of students so that no file can stop the program.

Links are not followed, devices and pipes are not opened. A file that is too large is reported
instead of read. A zip counts as a folder, a zip inside a zip as well, and no deeper.
"""

import io
import os
import stat
import zipfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from helpers.inputs import ArmError

MAX_BYTES = 20_000_000  # of one file, such as a long scan; a sheet with its outputs has 100 000
MAX_HAND_IN_FILES, MAX_HAND_IN_BYTES = 200, 50_000_000
_MAX_DEPTH = 2  # depth to which zips within zips are opened


@dataclass(frozen=True)
class HandedFile:
    """A file of a hand-in.

    Attributes:
        name: Path from the folder where the search began.
        content: Bytes of the file; empty if it was not read.
        trouble: Why the file was not read, or "".
    """

    name: str
    content: bytes = b""
    trouble: str = ""

    @property
    def kind(self) -> str:
        """Extension in lower case, such as ".ipynb", or "" for a file that was not read.

        Windows hides endings, so `answers.json.txt` is a JSON file too.
        """
        name = self.name.lower().removesuffix(".txt")
        known = name.endswith((".json", ".ipynb"))
        return "" if self.trouble else Path(name if known else self.name.lower()).suffix

    def __str__(self) -> str:
        text = f"{self.name} ({self.trouble})" if self.trouble else self.name
        return text.encode(errors="backslashreplace").decode()  # names may be invalid Unicode


@dataclass(frozen=True)
class Member:
    """A file below a folder or in a zip that is not read yet."""

    name: str
    read: Callable[[], HandedFile]


@contextmanager
def open_download(path: Path) -> Iterator[list[Member]]:
    """List the files of a download, which is a folder or a zip, and keep the zip open.

    Raises ArmError if the download is missing or is no zip that can be read.
    """
    if path.is_dir():
        yield list_folder(path)
        return
    if not path.exists():
        raise ArmError(f"{path} is not there; expected a download")
    try:
        archive = zipfile.ZipFile(path)
    except (zipfile.BadZipFile, OSError) as error:
        raise ArmError(f"{path} is no zip that can be read: {error}") from None
    with archive:
        yield _list_archive(archive)


def read_files(folder: Path) -> tuple[HandedFile, ...]:
    """Read the files below a folder as one hand-in, in order of their names."""
    return read_members(list_folder(folder))


def read_members(members: Iterable[Member]) -> tuple[HandedFile, ...]:
    """Read the files of one hand-in and those in its zips.

    After `MAX_HAND_IN_FILES` files or `MAX_HAND_IN_BYTES` bytes, zips counted, the last item says
    that more was not read.
    """
    files_left, bytes_left = MAX_HAND_IN_FILES, MAX_HAND_IN_BYTES
    files, waiting = list[HandedFile](), [(member, 0) for member in members][::-1]
    while waiting:
        member, depth = waiting.pop()
        file = member.read()
        files_left, bytes_left = files_left - 1, bytes_left - len(file.content)
        if files_left < 0 or bytes_left < 0:
            trouble = (
                "not read, nor what follows it: a hand-in may have"
                f" {MAX_HAND_IN_FILES} files and {MAX_HAND_IN_BYTES:,} bytes"
            )
            return (*files, HandedFile(file.name, trouble=trouble))
        if file.kind != ".zip":
            files.append(file)
        elif depth == _MAX_DEPTH:
            files.append(replace(file, content=b"", trouble="lies too deep"))
        else:
            waiting += [(inner, depth + 1) for inner in _list_zip(file)][::-1]
    return tuple(files)


def list_folder(root: Path) -> list[Member]:
    """List every file below a folder, with links and folders that cannot be opened."""
    members, errors = list[Member](), list[OSError]()
    for folder, subfolders, names in os.walk(root, onerror=errors.append):
        subfolders.sort()
        links = [name for name in subfolders if os.path.islink(os.path.join(folder, name))]
        for path in (Path(folder, name) for name in sorted([*names, *links])):
            name = path.relative_to(root).as_posix()
            members.append(Member(name, partial(_read_file, path, name)))
    for error in errors:
        name = os.path.relpath(error.filename, root.parent)
        members.append(_make_unreadable(name, f"cannot be read: {error.strerror}"))
    return members


def _read_file(path: Path, name: str) -> HandedFile:
    """Read an ordinary file of at most `MAX_BYTES` bytes."""
    safe_flags = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        status = path.lstat()
        if not stat.S_ISREG(status.st_mode):
            return HandedFile(name, trouble="no ordinary file")
        if status.st_size > MAX_BYTES:
            return _refuse_size(name, status.st_size)
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | safe_flags)) as file:
            return HandedFile(name, file.read(MAX_BYTES))
    except OSError as error:
        return HandedFile(name, trouble=f"cannot be read: {error.strerror}")


def _list_zip(file: HandedFile) -> list[Member]:
    """List the files in a zip of a hand-in; a broken zip gives one file with this message."""
    try:
        archive = zipfile.ZipFile(io.BytesIO(file.content))
        return _list_archive(archive, f"{file.name}/")
    except Exception as error:  # zipfile raises many kinds for a broken zip
        return [_make_unreadable(f"{file.name}/", f"no zip that can be read: {error}")]


def _list_archive(archive: zipfile.ZipFile, prefix: str = "") -> list[Member]:
    return [
        Member(prefix + info.filename, partial(_read_zipped, archive, info, prefix + info.filename))
        for info in archive.infolist()
        if not info.is_dir()
    ]


def _read_zipped(archive: zipfile.ZipFile, info: zipfile.ZipInfo, name: str) -> HandedFile:
    """Read a file of a zip.

    zipfile never reads more bytes than `file_size` says.
    """
    if info.file_size > MAX_BYTES:
        return _refuse_size(name, info.file_size)
    try:
        return HandedFile(name, archive.read(info))
    except Exception as error:  # broken data raise many kinds of exceptions too
        return HandedFile(name, trouble=str(error))


def _refuse_size(name: str, size: int) -> HandedFile:
    return HandedFile(name, trouble=f"{size:,} bytes; a file may have {MAX_BYTES:,}")


def _make_unreadable(name: str, trouble: str) -> Member:
    return Member(name, lambda: HandedFile(name, trouble=trouble))
