"""Read files of strangers so that none of them can stop the reader.

Links are not followed, devices and pipes are not opened. A file that is too large is reported
instead of read. A zip counts as a folder, a zip inside a zip as well, and no deeper.
"""

import io
import os
import stat
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

MAX_BYTES = 5_000_000  # A sheet with all its outputs has less than 100 000 bytes.


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
        """Ending in small letters, such as ".ipynb", or "" for a file that was not read.

        Windows hides endings, so `answers.json.txt` is a JSON file too.
        """
        name = self.name.lower().removesuffix(".txt")
        known = name.endswith((".json", ".ipynb"))
        return "" if self.trouble else Path(name if known else self.name.lower()).suffix

    def __str__(self) -> str:
        text = f"{self.name} ({self.trouble})" if self.trouble else self.name
        return text.encode(errors="backslashreplace").decode()  # a name need not be text


def read_files(
    path: Path, max_files: int = 200, max_bytes: int = 50_000_000
) -> tuple[HandedFile, ...]:
    """Read the files below a folder or in a zip, in order of their names.

    After `max_files` files or `max_bytes` bytes the last item says that more was not read.
    """
    files, bytes_left = list[HandedFile](), max_bytes
    for file in _read_zip(path) if path.is_file() else _unpack_zips(_read_folder(path)):
        bytes_left -= len(file.content)
        if len(files) == max_files or bytes_left < 0:
            trouble = f"not read: there are more than {max_files} files or {max_bytes:,} bytes"
            return (*files, HandedFile(file.name, trouble=trouble))
        files.append(file)
    return tuple(files)


def _read_folder(root: Path) -> Iterator[HandedFile]:
    """Read every file below a folder, and report links and unreadable files."""
    errors: list[OSError] = []
    for folder, subfolders, names in os.walk(root, onerror=errors.append):
        subfolders.sort()
        links = [name for name in subfolders if os.path.islink(os.path.join(folder, name))]
        for path in (Path(folder, name) for name in sorted([*names, *links])):
            yield _read_file(path, path.relative_to(root).as_posix())
    for error in errors:
        name = os.path.relpath(error.filename, root.parent)
        yield HandedFile(name, trouble=f"cannot be read: {error.strerror}")


def _read_file(path: Path, name: str) -> HandedFile:
    """Read an ordinary file of at most `MAX_BYTES` bytes."""
    safe_flags = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        status = path.lstat()
        if not stat.S_ISREG(status.st_mode):
            return HandedFile(name, trouble="no ordinary file")
        if status.st_size > MAX_BYTES:
            return HandedFile(name, trouble=f"larger than {MAX_BYTES:,} bytes")
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | safe_flags)) as file:
            return HandedFile(name, file.read(MAX_BYTES))
    except OSError as error:
        return HandedFile(name, trouble=f"cannot be read: {error.strerror}")


def _unpack_zips(files: Iterable[HandedFile], depth: int = 2) -> Iterator[HandedFile]:
    """Replace every zip by the files inside it."""
    for file in files:
        if file.kind != ".zip":
            yield file
        elif not depth:
            yield replace(file, content=b"", trouble="lies too deep")
        else:
            for inner in _read_zip(io.BytesIO(file.content), depth - 1):
                yield replace(inner, name=f"{file.name}/{inner.name}")


def _read_zip(file: Path | io.BytesIO, depth: int = 2) -> Iterator[HandedFile]:
    """Read the files in a zip, or report that the zip is broken."""
    try:
        with zipfile.ZipFile(file) as archive:
            members = [member for member in archive.infolist() if not member.is_dir()]
            yield from _unpack_zips((_read_member(archive, m) for m in members), depth)
    except Exception as error:  # zipfile raises many kinds for a broken zip
        yield HandedFile("", trouble=f"no zip that can be read: {error}")


def _read_member(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> HandedFile:
    """Read a file of a zip.

    zipfile never reads more bytes than `file_size` says.
    """
    if member.file_size > MAX_BYTES:
        return HandedFile(member.filename, trouble=f"larger than {MAX_BYTES:,} bytes")
    try:
        return HandedFile(member.filename, archive.read(member))
    except Exception as error:  # broken data raises many kinds, too
        return HandedFile(member.filename, trouble=str(error))
