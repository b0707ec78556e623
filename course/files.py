"""Files that strangers made, read so that none of them can stop the reader.

Links are not followed, devices and pipes not opened; what is too large or too much is told instead
of read. A zip counts as a folder, one in a zip as well, and no deeper.
"""

import io
import os
import stat
import zipfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

FILE = 5_000_000  # bytes of one file; larger ones are not read


@dataclass(frozen=True)
class Found:
    """A file by its path from where the search began, and what it holds or why it was not read."""

    name: str
    content: bytes = b""
    trouble: str = ""

    @property
    def kind(self) -> str:
        """The ending in small letters, such as ".ipynb"; "" of a file that was not read."""
        return "" if self.trouble else Path(self.name).suffix.lower()

    def __str__(self) -> str:
        words = f"{self.name} ({self.trouble})" if self.trouble else self.name
        return words.encode(errors="backslashreplace").decode()  # a name need not be text


def within(place: Path, most: int = 200, size: int = 50_000_000) -> tuple[Found, ...]:
    """The files below a folder, or in a zip, in order of their names, those in zips too; what is
    beyond so many, or so many bytes, is told.
    """
    kept, left = list[Found](), size
    for found in _in_zip(place) if place.is_file() else _unpacked(_walked(place)):
        left -= len(found.content)
        if len(kept) == most or left < 0:
            told = f"not read: there are more than {most} files or {size:,} bytes"
            return (*kept, Found(found.name, trouble=told))
        kept.append(found)
    return tuple(kept)


def _walked(place: Path) -> Iterator[Found]:
    troubles: list[OSError] = []
    for folder, inside, names in os.walk(place, onerror=troubles.append):
        inside.sort()
        links = [name for name in inside if os.path.islink(os.path.join(folder, name))]
        for path in (Path(folder, name) for name in sorted([*names, *links])):
            yield _read(path, path.relative_to(place).as_posix())
    for error in troubles:
        name = os.path.relpath(error.filename, place.parent)
        yield Found(name, trouble=f"cannot be read: {error.strerror}")


def _read(path: Path, name: str) -> Found:
    careful = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        status = path.lstat()
        if not stat.S_ISREG(status.st_mode):
            return Found(name, trouble="no ordinary file")
        if status.st_size > FILE:
            return Found(name, trouble=f"larger than {FILE:,} bytes")
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | careful)) as file:
            return Found(name, file.read(FILE))
    except OSError as error:
        return Found(name, trouble=f"cannot be read: {error.strerror}")


def _unpacked(files: Iterable[Found], depth: int = 2) -> Iterator[Found]:
    """The files, and in place of a zip what it holds."""
    for found in files:
        if found.kind != ".zip":
            yield found
        elif not depth:
            yield replace(found, content=b"", trouble="lies too deep")
        else:
            for inside in _in_zip(io.BytesIO(found.content), depth - 1):
                yield replace(inside, name=f"{found.name}/{inside.name}")


def _in_zip(file: Path | io.BytesIO, depth: int = 2) -> Iterator[Found]:
    """The files in a zip, however often packed; one that is broken is told."""
    try:
        with zipfile.ZipFile(file) as archive:
            entries = (_entry(archive, e) for e in archive.infolist() if not e.is_dir())
            yield from _unpacked(entries, depth)
    except Exception as error:  # a broken zip raises what it likes
        yield Found("", trouble=f"no zip that can be read: {error}")


def _entry(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> Found:
    if entry.file_size > FILE:  # of which zipfile reads no more than it says
        return Found(entry.filename, trouble=f"larger than {FILE:,} bytes")
    try:
        return Found(entry.filename, archive.read(entry))
    except Exception as error:  # so does what it holds
        return Found(entry.filename, trouble=str(error))
