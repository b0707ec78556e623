"""Running a notebook that a stranger wrote, apart from everything else.

It runs in bubblewrap: its own namespaces, no network, no files but Python's, an empty environment,
a folder in memory to write to. A filter of system calls, as Flatpak has one, keeps the kernel's
keys and further namespaces out of reach. `course.inside` sets the limits of a process.
Its output is only ever read as JSON and judged outside, where the key is.
"""

import contextlib
import json
import os
import platform
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import helpers

NOT_RUN = "notebooks are not run here; hand in answers.json, which its last cell writes"
SECONDS = 120  # for a notebook
_SIZE = 5_000_000  # bytes of the answers that are read


def refusal() -> str:
    """Why no notebook can be run on this machine and what to do; "" where one can."""
    if sys.platform != "linux" or platform.machine() not in _CALLS:
        return "notebooks are run on Linux on x86-64 or ARM64 only"
    if os.geteuid() == 0:  # no limit on the number of processes holds for the superuser's
        return "notebooks are not run by the superuser; type the command as an ordinary user"
    if not shutil.which("bwrap"):
        return "to run notebooks, install bubblewrap (on Debian and Ubuntu: apt install bubblewrap)"
    if not find_spec("nbclient"):
        return (
            "to run notebooks, install the extra: pip install -e '.[course]' in the book's folder"
        )
    if _execute([sys.executable, "-c", "import nbclient; print(1)"], b"", 60) != b"1\n":
        return "bubblewrap is installed, but the system does not let it work; notebooks are not run"
    return ""


def run(code: Sequence[str], seconds: int) -> tuple[Mapping[str, Any], str]:
    """The answers that a notebook's names hold when its cells have run, and what went wrong.

    One that is broken, endless or hostile raises nothing.
    """
    command = [sys.executable, "-m", "course.inside", str(seconds)]
    printed = _execute(command, json.dumps(code).encode(), seconds)
    try:
        found = json.loads(printed.splitlines()[-1])
        return dict(found["answers"]), str(found["trouble"])[:200]
    except (ValueError, KeyError, TypeError, IndexError, RecursionError):
        return {}, "running it gave no result: too long, too large, or stopped by itself"


def _execute(command: Sequence[str], given: bytes, seconds: int) -> bytes:
    """What a command prints in the sandbox within its time; then all that it began is killed."""
    with contextlib.ExitStack() as stack:
        read, calls, out = (stack.enter_context(tempfile.TemporaryFile()) for _ in range(3))
        for file, content in ((read, given), (calls, _filter())):
            file.write(content)
            file.seek(0)
        process = subprocess.Popen(
            [*_bubblewrap(calls.fileno()), *command], stdin=read, stdout=out,
            stderr=subprocess.DEVNULL, env={}, cwd="/", pass_fds=[calls.fileno()],
            start_new_session=True,
        )  # fmt: skip
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            pass
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        out.seek(0)
        return out.read(_SIZE)


def _bubblewrap(calls: int) -> list[str]:
    """A root of its own: programs, Python and packages, read-only, and two folders in memory."""
    words = [str(shutil.which("bwrap")), "--unshare-all", "--unshare-user", "--cap-drop", "ALL"]
    words += ["--die-with-parent", "--new-session", "--clearenv", "--seccomp", str(calls)]
    words += ["--ro-bind", "/usr", "/usr"]
    for folder in ("/lib", "/lib64", "/bin"):
        if Path(folder).is_symlink():
            words += ["--symlink", f"usr{folder}", folder]
        elif Path(folder).is_dir():
            words += ["--ro-bind", folder, folder]
    words += ["--proc", "/proc", "--ro-bind", "/dev/null", "/proc/keys"]
    words += ["--dev", "/dev", "--remount-ro", "/dev"]
    for folder in ("/home", "/tmp"):
        words += ["--perms", "1777", "--size", "67108864", "--tmpfs", folder]
    for path in _mounted():
        words += ["--ro-bind", path, path]
    words += ["--remount-ro", "/", "--chdir", "/home"]
    for name, value in _environment().items():
        words += ["--setenv", name, value]
    return words


def _mounted() -> list[str]:
    """Where Python, its packages and the helpers lie, each once; sheets lie elsewhere."""
    ours = (str(Path(file).parent) for file in (helpers.__file__, __file__))
    folders = {sys.base_prefix, sys.prefix, *ours, _packages()}
    return [f for f in sorted(folders) if not f"{f}/".startswith("/usr/")]


def _roots() -> set[str]:
    """The folders above the helpers and this package."""
    return {str(Path(file).parents[1]) for file in (helpers.__file__, __file__)}


def exposed(path: Path) -> bool:
    """Whether a path lies where notebooks can read."""
    return any(path.resolve().is_relative_to(folder) for folder in ("/usr", *_mounted()))


def _packages() -> str:
    """The folder of installed packages in which nbclient is."""
    return str(Path(str(getattr(find_spec("nbclient"), "origin", None))).parents[1])


def _environment() -> dict[str, str]:
    """What a notebook sees of the environment: nothing of the grader's own."""
    return {
        "PATH": f"{Path(sys.executable).parent}:/usr/bin:/bin",
        "HOME": "/home",
        "PYTHONPATH": ":".join([*_roots(), _packages()]),
        "OPENBLAS_NUM_THREADS": "1",
        "MPLBACKEND": "Agg",
        "LANG": "C.UTF-8",
    }


# What seccomp calls a machine, the number of clone there, and of the calls that are refused:
# unshare, setns, clone3 (whose flags a filter cannot see), add_key, request_key, keyctl.
_CALLS = {
    "x86_64": (0xC000003E, 56, (272, 308, 435, 248, 249, 250)),
    "aarch64": (0xC00000B7, 220, (97, 268, 435, 217, 218, 219)),
}


def _filter() -> bytes:
    """A program of the kernel's packet filter that answers "not known here" (ENOSYS) to those."""
    machine, clone, refused = _CALLS[platform.machine()]
    load, equal, at_least, any_bit, end = 0x20, 0x15, 0x35, 0x45, 0x06
    allow, refuse = (end, 0, 0, 0x7FFF0000), (end, 0, 0, 0x00050000 | 38)
    program = [(load, 0, 0, 4), (equal, 1, 0, machine), refuse]
    program += [(load, 0, 0, 0), (at_least, 0, 1, 0x40000000), refuse]  # numbers of x32
    for number in refused:
        program += [(equal, 0, 1, number), refuse]
    new_user = 0x10000000  # among the flags, its first argument
    program += [(equal, 0, 3, clone), (load, 0, 0, 16), (any_bit, 0, 1, new_user), refuse, allow]
    return b"".join(struct.pack("=HBBI", *line) for line in program)
