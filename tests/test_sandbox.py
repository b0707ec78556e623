"""What a stranger's notebook may do while it is marked: asked from inside, by a script in
Python's place that says what it sees.
"""

import io
import json
import os
import re
import shutil
import stat
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest

import helpers
from helpers.arm import ArmError
from helpers.course import sandbox
from helpers.course.sandbox import Limits, Ran
from tests.test_commands import a_machine_with_another_encoding_of_its_own  # noqa: F401

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="notebooks are run on Linux only")
BUBBLEWRAP = sys.platform == "linux" and sandbox.best_apart() == "bubblewrap"
LOOK = r"""#!/bin/bash
say() { echo "<$1>"; shift; "$@" 2>&1; }
say words printf '%s\n' "${@:1:$#-1}"
say last echo "${!#}"
say here pwd
say names env
say id id -u
say status grep -E 'Groups|CapInh|CapPrm|CapBnd|NoNewPrivs' /proc/self/status
say limits cat /proc/self/limits
say mounts cat /proc/self/mountinfo
say net cat /proc/net/dev
say apart readlink /proc/self/ns/pid /proc/self/ns/net /proc/self/ns/ipc /proc/self/ns/uts
say session ps -o pid=,sid= $$
say seen ls /
say links readlink /bin /lib /lib64
say owned stat -c '%a %n' /run /tmp
say input head -c 1 /dev/stdin
say written touch /usr/x /x /dev/x
say deep stat -c '%a' "$(dirname "$(dirname "$0")")/.."
say book cat "${!#}"
echo "<end>"
echo unseen >&2
"""


@pytest.fixture
def python(tmp_path, monkeypatch):
    """A script in the place of Python, in a folder of its own two levels down."""

    def put(script):
        path = tmp_path / "some" / "python" / "bin" / "python"
        path.parent.mkdir(parents=True)
        path.write_text(script, encoding="utf-8")
        path.chmod(0o755)
        home = str(path.parents[1])
        fake = SimpleNamespace(executable=str(path), prefix=home, base_prefix="/usr")
        monkeypatch.setattr(sandbox, "sys", fake)
        return path

    return put


def copied(tmp_path, text="the notebook\n"):
    path = tmp_path / "copy.ipynb"
    path.write_text(text, encoding="utf-8")
    path.chmod(0o444)
    return path


def seen(out):
    """What the script says, by heading."""
    parts = re.split(r"^<(\w+)>\n", out.decode(), flags=re.M)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))


def limits(text):
    return {line[:25].strip(): line[25:].split()[:2] for line in text.splitlines()[1:]}


def looked(python, tmp_path, apart):
    script = python(LOOK)
    mine, (reading, writing) = os.dup(0), os.pipe()
    os.write(writing, b"typed by whoever grades")
    os.dup2(reading, 0)
    try:
        out = sandbox._execute(copied(tmp_path), apart, Limits(77, 33, 3 * 2**30))
    finally:
        os.dup2(mine, 0)
        for number in (mine, reading, writing):
            os.close(number)
    found = seen(out)
    assert found["words"].splitlines() == [
        "-m", "nbconvert", "--to", "notebook", "--execute", "--allow-errors", "--stdout",
        "--log-level=ERROR", "--ExecutePreprocessor.timeout=33",
        "--ExecutePreprocessor.interrupt_on_timeout=True",
    ]  # fmt: skip
    rules = limits(found["limits"])
    assert {
        "Max cpu time": ["77", "77"],
        "Max address space": [str(3 * 2**30)] * 2,
        "Max file size": ["20971520"] * 2,
        "Max open files": ["256"] * 2,
        "Max core file size": ["0"] * 2,
    }.items() <= rules.items()
    assert found["end"] == ""
    assert found["input"] == ""
    assert found["book"] == "the notebook\n"
    names = dict(line.split("=", 1) for line in found["names"].splitlines())
    for own in ("_", "SHLVL", "PWD", "OLDPWD"):  # bash makes them itself
        names.pop(own, None)
    assert names.pop("PATH") == f"{script.parent}:/usr/bin:/bin"
    assert names.pop("PYTHONPATH") == str(Path(helpers.__file__).parents[1])
    return found, rules, names


def test_a_process_of_its_own_has_limits_and_none_of_the_graders_environment(
    python, tmp_path, monkeypatch, capfd
):
    monkeypatch.setenv("COURSE_SECRET", "hidden")
    monkeypatch.setattr(sandbox, "_tasks_of_mine", lambda: 1000)
    found, rules, names = looked(python, tmp_path, "process")
    assert capfd.readouterr() == ("", "")  # a stranger writes nothing to the grader's terminal
    home = found["here"].strip()
    assert names == {
        "HOME": home, "TMPDIR": home, "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "Agg",
        "LANG": "C.UTF-8",
    }  # fmt: skip
    assert Path(home).parent == Path(sandbox.tempfile.gettempdir())
    assert not Path(home).exists()
    assert rules["Max processes"] == ["1256", "1256"]
    assert found["last"].strip() == str(tmp_path / "copy.ipynb")
    assert int(found["session"].split()[1]) != os.getsid(0)


@pytest.mark.skipif(not BUBBLEWRAP, reason="bubblewrap is not installed or does not work here")
def test_bubblewrap_shows_the_notebook_and_what_runs_it_and_nothing_else(
    python, tmp_path, monkeypatch
):
    monkeypatch.setenv("COURSE_SECRET", "hidden")
    tools = tmp_path / "tools"  # of whoever grades: his own PATH finds bubblewrap
    tools.mkdir()
    script = f'#!/bin/sh\ntouch {tmp_path}/met\nexec {shutil.which("bwrap")} "$@"\n'
    (tools / "bwrap").write_text(script, encoding="utf-8")
    (tools / "bwrap").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tools}:{os.environ['PATH']}")
    found, rules, names = looked(python, tmp_path, "bubblewrap")
    assert (tmp_path / "met").exists()
    links = [path for path in ("/bin", "/lib", "/lib64") if Path(path).is_symlink()]
    assert found["links"].split() == [os.readlink(path) for path in links]
    assert names == {
        "HOME": "/run", "TMPDIR": "/tmp", "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "Agg",
        "LANG": "C.UTF-8",
    }  # fmt: skip
    assert (found["here"], found["last"]) == ("/run\n", "/in.ipynb\n")
    assert rules["Max processes"] == ["256", "256"]
    outside = [os.readlink(f"/proc/self/ns/{name}") for name in ("pid", "net", "ipc", "uts")]
    assert not {*outside} & {*found["apart"].split()}
    assert re.findall(r"^ *(\w+):", found["net"], re.M) in ([], ["lo"])
    status = dict(re.findall(r"(\w+):[ \t]*(.*)", found["status"]))
    assert int(status["NoNewPrivs"]) == 1
    assert not any(int(status[name], 16) for name in ("CapInh", "CapPrm", "CapBnd"))
    if os.geteuid() == 0:
        assert int(found["id"]) == 2**30 + os.getpid()
        assert status["Groups"].strip() == ""
    top = {"dev", "in.ipynb", "proc", "run", "tmp", "usr", "bin", "lib", "lib64"}
    mounted = [str(Path(helpers.__file__).parent), str(tmp_path / "some" / "python")]
    assert {*found["seen"].split()} - top == {Path(p).parts[1] for p in mounted} - {"tmp"}
    mounts = {}
    for line in found["mounts"].splitlines():
        words = line.split()
        mounts[words[4]] = (words[5].split(",")[0], words[words.index("-") + 1], words[-1])
    assert {place for place, (how, *_) in mounts.items() if how != "ro"} - {"/proc"} <= {
        "/run", "/tmp",
    } | {place for place in mounts if re.match("/(proc|dev)/", place)}  # fmt: skip
    assert {"/", "/usr", "/dev", "/in.ipynb", *mounted} <= mounts.keys()
    for place in ("/run", "/tmp"):
        assert mounts[place][1] == "tmpfs"
        assert "size=65536k" in mounts[place][2]
    assert found["owned"] == "1777 /run\n1777 /tmp\n"
    assert found["written"].count("\n") == 3
    assert found["deep"] == "755\n"


@pytest.mark.parametrize(
    ("script", "size"),
    [
        ("head -c 4000000 /dev/zero", 4_000_000),
        ("head -c 5000000 /dev/zero", 5_000_000),
        ("head -c 5000001 /dev/zero", 0),
        ("echo $$ > {pid}; yes; sleep 100", 0),
        ("exit 3", 0),
    ],
)
def test_output_is_cut_at_five_million_bytes_and_what_still_runs_is_ended(
    python, tmp_path, script, size
):
    pid = tmp_path / "pid"
    python(f"#!/bin/bash\n{script.format(pid=pid)}\n")
    out = sandbox._execute(copied(tmp_path), "process", Limits())
    assert len(out) == size
    if pid.exists():
        for _ in range(1000):
            try:
                os.kill(int(pid.read_bytes()), 0)
            except ProcessLookupError:
                return
            time.sleep(0.01)
        pytest.fail("it still runs")


BOMB = """import os, time
for count in range(1500):
    try:
        if not os.fork():
            os.close(1)
            time.sleep(60)
            os._exit(0)
    except BlockingIOError:
        print(count)
        break
"""


@pytest.mark.parametrize("apart", ["bubblewrap", "process"])
def test_a_notebook_gets_a_few_hundred_processes_and_no_more(python, tmp_path, apart):
    if apart == "process" and os.geteuid() == 0:
        pytest.skip("no number of processes holds for the superuser; refused without a flag")
    if not BUBBLEWRAP:
        pytest.skip("bubblewrap is not installed or does not work here")
    real = os.path.realpath(sys.executable)
    script = python(f'#!/bin/sh\nexec {real} -I -S "$(dirname "$0")/bomb.py"\n')
    (script.parent / "bomb.py").write_text(BOMB, encoding="utf-8")
    sandbox.sys.base_prefix = sys.base_prefix
    assert 100 < int(sandbox._execute(copied(tmp_path), apart, Limits())) < 256


def test_a_notebook_that_goes_on_after_its_time_is_killed_five_seconds_later():
    assert sandbox._limited(Limits(notebook=7))[:4] == ["timeout", "-k", "5", "7"]


def test_what_lies_in_usr_is_mounted_once(monkeypatch):
    package = str(Path(helpers.__file__).parent)
    for prefix, base, expected in (
        ("/usr", "/usr/local", [package]),
        ("/usrs/a", "/a", sorted(["/usrs/a", "/a", package])),
        ("/a", "/a", sorted(["/a", package])),
    ):
        monkeypatch.setattr(sandbox, "sys", SimpleNamespace(prefix=prefix, base_prefix=base))
        assert sandbox._mounted() == expected


def test_processes_and_threads_of_this_user_are_counted(tmp_path, monkeypatch):
    assert sandbox._tasks_of_mine() >= 1
    for place in ("1/task/1", "1/task/2", "12/task/12", "self/task/12", "13"):  # 13 has ended
        (tmp_path / place).mkdir(parents=True)
    assert sandbox._tasks_of_mine(tmp_path) == 3
    monkeypatch.setattr(sandbox.os, "getuid", lambda: 4_000_000)
    assert sandbox._tasks_of_mine(tmp_path) == 0


def test_limits_need_their_programs(monkeypatch):
    for missing in ("timeout", "prlimit"):
        monkeypatch.setattr(sandbox.shutil, "which", lambda name, gone=missing: name != gone)
        with pytest.raises(ArmError) as told:
            sandbox._limited(Limits())
        words = "timeout and prlimit were not found; notebooks are run on Linux only"
        assert str(told.value) == words


@pytest.mark.parametrize("missing", ["bwrap", "prlimit", "setpriv", None])
@pytest.mark.parametrize("code", [0, 1])
@pytest.mark.parametrize("user", [0, 1000])
def test_bubblewrap_is_asked_whether_it_works(tmp_path, monkeypatch, capfd, missing, code, user):
    script = f'#!/bin/bash\nprintf "%s\\n" "$@" > {tmp_path}/asked\nprintf noise\nexit {code}\n'
    for name in {"bwrap", "prlimit", "setpriv"} - {missing}:
        (tmp_path / name).write_text(script, encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(sandbox.os, "geteuid", lambda: user)
    works = missing is None and code == 0
    assert sandbox.best_apart() == ("bubblewrap" if works else "nothing")
    assert (tmp_path / "asked").exists() == (missing is None)
    assert capfd.readouterr() == ("", "")
    if missing is None:
        asked = (tmp_path / "asked").read_text("utf-8").split()
        assert ("--unshare-user" in asked) == (user == 1000)
        assert ("setpriv" in asked) == ("--clear-groups" in asked) == (user == 0)
        seven = ["--ro-bind", "/", "/", "--proc", "/proc"]
        assert asked[asked.index("--ro-bind") :][:5] == seven
        assert asked[-1] == "true"
        assert "--unshare-net" in asked or "--unshare-all" in asked


def test_what_bubblewrap_is_given_differs_by_who_runs_it(tmp_path, monkeypatch):
    for user, first in ((0, "--unshare-pid"), (1000, "--unshare-all")):
        monkeypatch.setattr(sandbox.os, "geteuid", lambda user=user: user)
        words = sandbox._bubblewrap(tmp_path)
        assert words[:2] == ["bwrap", first]
        assert {"--die-with-parent", "--new-session"} <= {*words}
        assert ("setpriv" in words) == (user == 0)
        assert words[-2:] == ["prlimit", "--nproc=256"]


@pytest.mark.parametrize(
    ("apart", "user", "as_root", "words"),
    [
        ("nothing", 1000, True, "it has no answers.json, and notebooks are not run without leave"),
        ("process", 0, False,
         "it has no answers.json, and the superuser runs no notebook unprotected"),
        ("process", 0, True, ""), ("process", 1000, False, ""), ("bubblewrap", 0, False, ""),
    ],
)  # fmt: skip
def test_what_is_run_is_a_copy_that_prints_its_names(
    tmp_path, monkeypatch, apart, user, as_root, words
):
    code = {"cell_type": "code", "execution_count": 3, "metadata": {}, "source": "answer_é = 1"}
    out = {"output_type": "stream", "name": "stdout", "text": "old"}
    text = {"cell_type": "markdown", "metadata": {}, "source": "# É"}
    odd = {"cell_type": "heading", "source": "of nbformat 3"}
    book = {"cells": [text, {**code, "outputs": [out]}, odd], "metadata": {"x": 1}, "nbformat": 3}
    path = tmp_path / "a b.ipynb"
    path.write_text(json.dumps(book), encoding="utf-8")
    before = path.read_bytes()
    met = []

    def executed(copy, apart, limits):
        met.append(
            (copy, apart, limits, stat.S_IMODE(copy.stat().st_mode), copy.read_text("utf-8"))
        )
        cells = [{}, {"outputs": [{"name": "stdout", "text": sandbox._MARK + '{"p": 1}'}]}]
        return json.dumps({"cells": cells}).encode()

    monkeypatch.setattr(sandbox, "_execute", executed)
    monkeypatch.setattr(sandbox.os, "geteuid", lambda: user)
    found = sandbox.run(path, apart, None, as_root=as_root)
    assert found == (Ran(None, words) if words else Ran({"p": 1}, ""))
    assert path.read_bytes() == before
    if words:
        assert not met
        return
    ((copy, how, limits, mode, written),) = met
    assert (how, limits, mode) == (apart, Limits(120, 30, 4 * 2**30), 0o444)
    assert copy.suffix == ".ipynb"
    assert not copy.parent.exists()
    run = json.loads(written)
    nbformat.validate(run)
    assert run["cells"][:2] == [text, {**code, "outputs": []}]
    assert len(run["cells"]) == 3
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    assert run["metadata"] == {"kernelspec": kernel}
    space = {"answer_p": [1, 2]}
    printed = io.StringIO()
    monkeypatch.setattr(sys, "stdout", printed)
    exec(run["cells"][2]["source"], space)
    assert printed.getvalue() == sandbox._MARK + '{"p": [1, 2]}\n'
    mine = Limits(1, 2, 3)
    monkeypatch.setattr(sandbox, "_execute", lambda *a: met.append(a) or b"")
    sandbox.run(path, apart, mine, as_root=as_root)
    assert met[-1][1:] == (apart, mine)


def test_only_three_ways_are_known(tmp_path):
    with pytest.raises(
        ArmError, match=r"^apart is 'docker'; expected one of bubblewrap, process, nothing$"
    ):
        sandbox.run(tmp_path / "x.ipynb", "docker")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "x.ipynb is no ordinary file"),
        ("{", "x.ipynb is no notebook"),
        ("[]", "x.ipynb is no notebook"),
        ('{"cells": [{}]}', "x.ipynb is no notebook"),
        ('{"cells": 3}', "x.ipynb is no notebook"),
        (" " * 5_000_001, "x.ipynb has more than 5,000,000 bytes"),
        ('{"cells": []}' + " " * (5_000_000 - 13), None),
        (b"\xff", "x.ipynb is no notebook"),
        (Path("/etc/hostname"), "x.ipynb is no ordinary file"),
    ],
    ids=range(9),
)
def test_a_file_that_is_no_notebook_is_told(tmp_path, content, words):
    path = tmp_path / "x.ipynb"
    if isinstance(content, Path):
        path.symlink_to(content)
    elif content is not None:
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    if words is None:
        assert sandbox.read_notebook(path) == {"cells": []}
        return
    with pytest.raises(ValueError, match=r"^x\.ipynb") as told:
        sandbox.read_notebook(path)
    assert str(told.value) == words
    assert sandbox.run(path, "bubblewrap") == Ran(None, words)
