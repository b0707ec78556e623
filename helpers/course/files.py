"""Files that strangers made, read so that none of them can stop the reader.

Links are not followed, devices and pipes not opened; what is too large, too deep or too much is
told instead of read. A zip counts as a folder.
"""

import io
import lzma
import os
import stat
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO

FILE = 5_000_000  # bytes of one file; larger ones are not read
ALL = 50_000_000  # bytes of one student's files together
_MOST = 200  # files of one student
_DEEPEST = 8  # folders and zips within each other
_BROKEN = (
    zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, NotImplementedError, RuntimeError,
)  # fmt: skip


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


def within(place: Path) -> tuple[Found, ...]:
    """The files of one student: all below a folder in order of their names, those in zips too."""
    try:
        inside = sorted(os.listdir(place))
    except OSError as error:
        return (Found(place.name, trouble=f"cannot be read: {error.strerror}"),)
    return limited(found for name in inside for found in walk(place / name, name))


def limited(files: Iterable[Found], count: int = _MOST, size: int = ALL) -> tuple[Found, ...]:
    """As many of the files as one student may have; the rest is told."""
    kept: list[Found] = []
    for found in files:
        size -= len(found.content)
        if len(kept) == count or size < 0:
            told = f"not read: there are more than {count} files or {ALL:,} bytes"
            return (*kept, Found(found.name, trouble=told))
        kept.append(found)
    return tuple(kept)


def walk(path: Path, name: str, depth: int = 1) -> Iterator[Found]:
    """A file, or all files below a folder or in a zip, by the name that it goes by."""
    try:
        status = path.lstat()
        if not stat.S_ISDIR(status.st_mode):
            yield from _opened(Found(name, _read(path)), depth)
        elif depth > _DEEPEST:
            yield Found(name, trouble="lies too deep")
        else:
            for inside in sorted(os.listdir(path)):
                yield from walk(path / inside, f"{name}/{inside}", depth + 1)
    except OSError as error:
        yield Found(name, trouble=f"cannot be read: {error.strerror}")
    except ValueError as error:
        yield Found(name, trouble=str(error))


def _read(path: Path) -> bytes:
    """The content of an ordinary file; raises ValueError, in words, or OSError."""
    if not stat.S_ISREG(path.lstat().st_mode):
        raise ValueError("no ordinary file")
    careful = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    with open(path, "rb", opener=lambda name, flags: os.open(name, flags | careful)) as file:
        return _bounded(file)


def _bounded(file: IO[bytes]) -> bytes:
    content = file.read(FILE + 1)
    if len(content) > FILE:
        raise ValueError(f"larger than {FILE:,} bytes")
    return content


def _opened(found: Found, depth: int) -> Iterator[Found]:
    """A file itself, or what a zip holds."""
    if found.kind != ".zip":
        yield found
    elif depth > _DEEPEST:
        yield replace(found, content=b"", trouble="lies too deep")
    else:
        inside = in_zip(io.BytesIO(found.content), depth + 1)
        yield from limited(replace(f, name=f"{found.name}/{f.name}") for f in inside)


def in_zip(file: IO[bytes], depth: int = 1) -> Iterator[Found]:
    """The files in a zip, however often packed; one that is broken is told."""
    try:
        with zipfile.ZipFile(file) as archive:
            for entry in archive.infolist():
                if not entry.is_dir():
                    yield from _opened(_entry(archive, entry), depth)
    except (*_BROKEN, OSError, ValueError) as error:
        yield Found("", trouble=f"no zip that can be read: {error}")


def _entry(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> Found:
    try:
        with archive.open(entry) as file:
            return Found(entry.filename, _bounded(file))
    except (*_BROKEN, OSError, ValueError) as error:
        return Found(entry.filename, trouble=str(error))
