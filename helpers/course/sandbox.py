"""Running a notebook that a stranger wrote, apart from everything else.

It runs in bubblewrap: its own namespaces, no network, no files but Python's, an empty environment,
a folder in memory to write to. A filter of system calls, as Flatpak has one, keeps the kernel's
keys and further namespaces out of reach. `helpers.course.inside` sets the limits of a process.

What that does not protect from: holes in the kernel, the sum of the memory of 256 processes (the
limit is for each), reading whatever is mounted (Python, the packages), and a notebook that prints
whatever it likes; its output is only ever read as JSON and judged outside, where the key is.
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
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import helpers

NOT_RUN = "notebooks are not run here; hand in answers.json, or install bubblewrap"
_SIZE = 5_000_000  # bytes of the answers that are read


@dataclass(frozen=True)
class Limits:
    """Seconds for a notebook and for one of its cells, and bytes of memory for each process."""

    notebook: int = 120
    cell: int = 30
    memory: int = 4 * 2**30


@dataclass(frozen=True)
class Ran:
    """What came of a notebook: its answers, and words about what went wrong."""

    answers: Mapping[str, Any]
    trouble: str = ""


def refusal() -> str:
    """Why no notebook can be run on this machine and what to do; "" where one can."""
    if sys.platform != "linux" or platform.machine() not in _CALLS:
        return "notebooks are run on Linux on x86-64 or ARM64 only"
    if not all(map(shutil.which, ("bwrap", "setpriv"))):
        return "to run notebooks, install bubblewrap (on Debian and Ubuntu: apt install bubblewrap)"
    if _execute([sys.executable, "-c", "import nbclient; print(1)"], {}, 60) != b"1\n":
        return "bubblewrap is installed, but the system does not let it work; notebooks are not run"
    return ""


def run(book: Mapping[str, Any], limits: Limits) -> Ran:
    """Execute the code of a notebook and read the answers that its names hold at the end.

    One that is broken, endless or hostile raises nothing: the trouble is told in the result.
    """
    code = [cell["source"] for cell in book["cells"] if cell["cell_type"] == "code"]
    numbers = map(str, (limits.notebook, limits.cell, limits.memory))
    command = [sys.executable, "-m", "helpers.course.inside", "/in.json", *numbers]
    printed = _execute(command, {"/in.json": json.dumps(code).encode()}, limits.notebook)
    try:
        found = json.loads(printed.splitlines()[-1])
        answers, trouble = found.get("answers", {}), str(found["trouble"])
        return Ran({str(name): answer for name, answer in answers.items()}, trouble[:200])
    except (ValueError, KeyError, TypeError, AttributeError, IndexError, RecursionError):
        return Ran({}, "running it gave no result: too long, too large, or stopped by itself")


def _execute(command: Sequence[str], given: Mapping[str, bytes], seconds: int) -> bytes:
    """What a command prints in the sandbox within its time; then all that it began is killed."""
    with contextlib.ExitStack() as stack:
        data = {path: stack.enter_context(_readable(content)) for path, content in given.items()}
        calls = stack.enter_context(_readable(_filter()))
        out = stack.enter_context(tempfile.TemporaryFile())
        process = subprocess.Popen(
            [*_bubblewrap(data, calls), *command], stdin=subprocess.DEVNULL, stdout=out,
            stderr=subprocess.DEVNULL, env={}, cwd="/", pass_fds=(*data.values(), calls),
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


@contextlib.contextmanager
def _readable(content: bytes) -> Iterator[int]:
    """A descriptor from which another process reads this."""
    with tempfile.TemporaryFile() as file:
        file.write(content)
        file.seek(0)
        yield file.fileno()


def _bubblewrap(data: Mapping[str, int], calls: int) -> list[str]:
    """The command that makes a root of its own: the system's programs, Python, the packages and
    the given files, all read-only, and two folders in memory.
    """
    as_root = os.geteuid() == 0
    words = [str(shutil.which("bwrap")), *(_ROOTS_NAMESPACES if as_root else _NAMESPACES)]
    words += ["--die-with-parent", "--new-session", "--clearenv", "--seccomp", str(calls)]
    words += ["--ro-bind", "/usr", "/usr"]
    for folder in ("/lib", "/lib64", "/bin"):
        if Path(folder).is_dir():
            kind = (
                ["--symlink", f"usr{folder}"]
                if Path(folder).is_symlink()
                else ["--ro-bind", folder]
            )
            words += [*kind, folder]
    words += ["--proc", "/proc", "--ro-bind", "/dev/null", "/proc/keys", "--dev", "/dev"]
    words += ["--remount-ro", "/dev"]
    for folder in ("/home", "/tmp"):
        words += ["--perms", "1777", "--size", "67108864", "--tmpfs", folder]
    for path in _mounted():
        # Made by bubblewrap itself, the folders above would be for their owner only.
        for above in [*reversed(Path(path).parents)][1:]:
            words += ["--perms", "0755", "--dir", str(above)]
        words += ["--ro-bind", path, path]
    for path, descriptor in data.items():
        words += ["--perms", "0444", "--ro-bind-data", str(descriptor), path]
    words += ["--remount-ro", "/", "--chdir", "/home"]
    for name, value in _environment().items():
        words += ["--setenv", name, value]
    return [*words, *(_as_nobody() if as_root else [])]


# A namespace of users is what makes the others possible for an ordinary user, and the number of
# processes is counted in it. For the superuser no such number holds, in whatever namespace: the
# kernel asks who he is outside. So he needs none, and what he runs becomes nobody instead.
_NAMESPACES = ["--unshare-all", "--unshare-user", "--cap-drop", "ALL"]
_ROOTS_NAMESPACES = ["--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts"]
_ROOTS_NAMESPACES += ["--unshare-cgroup-try", "--cap-drop", "ALL"]
for _capability in ("CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP"):
    _ROOTS_NAMESPACES += ["--cap-add", _capability]


def _as_nobody() -> list[str]:
    """setpriv: a user without a name, rights or files, another one for each notebook that runs at
    the same time, so that they do not count for each other.
    """
    user = 2**30 + os.getpid()
    words = [str(shutil.which("setpriv")), f"--reuid={user}", f"--regid={user}", "--clear-groups"]
    return [*words, "--no-new-privs", "--inh-caps=-all", "--bounding-set=-all"]


def _mounted() -> list[str]:
    """Where Python, its packages and the helpers lie, each once; secrets and sheets lie
    elsewhere.
    """
    folders = {sys.base_prefix, sys.prefix, str(Path(helpers.__file__).parent), _packages()}
    return [f for f in sorted(folders) if f and not f"{f}/".startswith("/usr/")]


def exposed(path: Path) -> bool:
    """Whether a path lies where notebooks can read."""
    return any(path.resolve().is_relative_to(folder) for folder in ("/usr", *_mounted()))


def _packages() -> str:
    """The folder of installed packages in which nbclient is; "" where it is not installed."""
    found = find_spec("nbclient")
    return str(Path(str(found.origin)).parents[1]) if found else ""


def _environment() -> dict[str, str]:
    """What a notebook sees of the environment: nothing of the grader's own."""
    return {
        "PATH": f"{Path(sys.executable).parent}:/usr/bin:/bin",
        "HOME": "/home",
        "PYTHONPATH": f"{Path(helpers.__file__).parents[1]}:{_packages()}",
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
