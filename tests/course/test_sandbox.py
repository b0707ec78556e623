"""What a stranger's notebook may do while it is marked, asked from inside."""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from course import sandbox

REFUSED = sandbox.refusal()
pytestmark = pytest.mark.skipif(bool(REFUSED), reason=REFUSED or "it works")
SECONDS = 100
ROOT = Path(__file__).parents[1]


ENDLESS = "import time\nwhile True: time.sleep(1)"


def run(*cells, seconds=SECONDS):
    return sandbox.run(cells, seconds)


# What whoever grades has, and none of it may be met inside: a word in the environment, keys in the
# session's and in the user's keyring, an open file, files of his, a server on this machine.
GRADER = r"""
import ctypes, json, os, platform, socket, sys, tempfile
from course import sandbox
folder, cells = json.loads(sys.argv[1])
add_key, keyctl = {"x86_64": (248, 250), "aarch64": (217, 219)}[platform.machine()]
libc = ctypes.CDLL(None)
keys = [libc.syscall(add_key, b"user", b"canary-key", b"canary", 6, ring) for ring in (-3, -4)]
for key in keys:
    libc.syscall(keyctl, 5, key, 0x3f3f3f3f)  # all may see and read it
server = socket.create_server(("127.0.0.1", 0))
files = [open(os.path.join(folder, "other.json")), server]
for file in files:
    os.set_inheritable(file.fileno(), True)
about = f"keys, keyctl, port, folder = {keys}, {keyctl}, {server.getsockname()[1]}, {folder!r}"
print(json.dumps(sandbox.run([about, *cells], 100)))
"""
LOOK = r"""
import ctypes, glob, os, pathlib, socket
libc = ctypes.CDLL(None, use_errno=True)
def attempt(function):
    try:
        return function()
    except Exception as error:
        return f"refused: {error}"
def everything(pattern):
    return str([attempt(lambda: pathlib.Path(path).read_bytes()) for path in glob.glob(pattern)])
def key(number):
    held = ctypes.create_string_buffer(64)
    return libc.syscall(keyctl, 11, number, held, 64), held.value.decode()
def refused(call):
    return libc.syscall(*call) if isinstance(call, tuple) else call()
answer_environment = everything("/proc/*/environ") + str(dict(os.environ))
answer_descriptors = [attempt(lambda: os.readlink(path)) for path in glob.glob("/proc/[0-9]*/fd/*")]
answer_keys = [key(number) for number in keys] + [attempt(lambda: open("/proc/keys").read())]
answer_session = libc.syscall(keyctl, 0, -3, 0)
answer_commands = everything("/proc/*/cmdline")
answer_files = [os.path.exists(folder), attempt(lambda: os.listdir("/root")),
                attempt(lambda: os.listdir("/home")), os.path.exists("/etc/passwd")]
answer_network = [attempt(lambda: socket.create_connection(("127.0.0.1", port), 3) and "met"),
                  attempt(lambda: socket.create_connection(("1.1.1.1", 80), 3) and "met")]
answer_namespaces = [libc.unshare(flag) for flag in (0x10000000, 0x00020000, 0x40000000)]
answer_clone = libc.syscall(220 if keyctl == 219 else 56, 0x10000011, 0, 0, 0, 0)
answer_processes = sorted(int(name) for name in os.listdir("/proc") if name.isdigit())
answer_user = os.getuid()
answer_write = [attempt(lambda p=p: open(p + "/mark", "w").write("x"))
                for p in ("/usr", "/", "/dev", "/proc/sys", os.path.dirname(os.__file__))]
answer_own = attempt(lambda: open("picture.svg", "w").write("mine"))
answer_rights = [line.split()[1] for line in open("/proc/self/status")
                 if line.startswith(("CapEff", "CapPrm", "CapBnd", "NoNewPrivs"))]
"""


@pytest.fixture(scope="module")
def seen():
    """What the notebook found, with all that whoever grades has around it."""
    folder = Path(f"/tmp/course-{os.getpid()}")
    folder.mkdir(mode=0o755)
    (folder / "other.json").write_text("canary", encoding="utf-8")
    given = json.dumps([str(folder), [LOOK]])
    environment = {"PYTHONPATH": str(ROOT), **os.environ, "SECRET": "canary"}
    done = subprocess.run(
        [sys.executable, "-c", GRADER, given], env=environment, cwd=folder,
        capture_output=True, text=True, close_fds=False,
    )  # fmt: skip
    shutil.rmtree(folder)
    assert done.returncode == 0, done.stderr
    answers, trouble = json.loads(done.stdout.splitlines()[-1])
    assert trouble == "", answers
    return answers


@pytest.mark.parametrize("place", ["environment", "descriptors", "keys", "commands", "files"])
def test_nothing_of_the_graders_is_met_inside(seen, place):
    assert "canary" not in json.dumps(seen[place])


def test_keys_files_network_and_namespaces_are_refused(seen):
    assert [number for number, _ in seen["keys"][:2]] == [-1, -1]
    assert seen["session"] == -1
    assert seen["files"][0] is False
    assert seen["files"][3] is False
    assert all(words.startswith("refused") for words in seen["network"])
    assert seen["namespaces"] == [-1, -1, -1]
    assert seen["clone"] == -1
    assert len(seen["processes"]) < 10
    assert seen["user"] != 0
    assert all(str(words).startswith("refused") for words in seen["write"])
    assert {int(number, 16) for number in seen["rights"]} == {0, 1}


def test_a_notebook_has_a_folder_of_its_own_to_write_to(seen):
    assert seen["own"] == 4


def test_a_cell_that_fails_or_never_ends_costs_itself():
    found = run("answer_p = [1, 2]", "1 / 0", ENDLESS, "answer_J = 4", seconds=24)
    words = "the cell `1 / 0` raised ZeroDivisionError: division by zero; "
    words += "the cell `import time` was stopped, since it took too long"
    assert found == ({"p": [1, 2], "J": 4}, words)


@pytest.mark.parametrize(
    ("cell", "words"),
    [
        ("import os\nos._exit(0)", "its kernel stopped before the end"),
        ("import os, signal\nos.kill(os.getppid(), signal.SIGKILL)", "running it gave no result"),
        ("answer_p = 'x' * 10**8", "running it gave no result"),
    ],
)
def test_a_notebook_that_ends_itself_gives_no_answers_and_words(cell, words):
    answers, trouble = run("answer_p = 1", cell)
    assert not answers
    assert trouble.startswith(words)


def mine(word):
    """Processes of this machine whose command holds a word."""
    commands = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            commands.append(path.read_bytes())
        except OSError:
            continue
    return [c for c in commands if word.encode() in c]


def test_all_that_a_notebook_began_ends_with_it():
    word = f"daemon{os.getpid()}"
    daemon = f"""
import os, sys, subprocess
if not os.fork():
    os.setsid()
    if not os.fork():
        os.execv(sys.executable, [sys.executable, "-c", "import time; time.sleep(900)", "{word}"])
    os._exit(0)
answer_p = 1"""
    assert run(daemon)[0] == {"p": 1}
    deaf = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)"
    assert run(daemon, f"{deaf}\n{ENDLESS}", seconds=12)[1]
    for _ in range(600):  # the kernel ends them
        if not mine(word):
            return
        time.sleep(0.1)
    pytest.fail("it still runs")


def test_a_notebook_gets_a_few_hundred_processes_and_a_little_space():
    bomb = (
        "import os, time\nanswer_p = 0\nfor count in range(1500):\n    try:\n"
        "        if not os.fork():\n            time.sleep(60)\n            os._exit(0)\n"
        "    except OSError:\n        answer_p = count\n        break"
    )
    large = (
        "answer_R = 0\ntry:\n    for number in range(20):\n"
        "        with open(str(number), 'wb') as file:\n            file.write(bytes(10**7))\n"
        "        answer_R = number\nexcept OSError:\n    pass"
    )
    found, _ = run(
        large,
        "answer_J = 0\ntry:\n    bytearray(10**10)\nexcept MemoryError:\n    answer_J = 1",
        bomb,
    )
    assert 3 <= found["R"] <= 7
    assert found["J"] == 1
    assert 100 < found["p"] < 256


def test_why_no_notebook_is_run_is_said_with_what_to_install(monkeypatch):
    monkeypatch.setattr(sandbox.shutil, "which", lambda name: None)
    assert "install bubblewrap (on Debian and Ubuntu: apt install bubblewrap)" in sandbox.refusal()
    monkeypatch.undo()
    monkeypatch.setattr(sandbox, "_bubblewrap", lambda *_: ["/bin/false"])
    assert "does not let it work" in sandbox.refusal()
    monkeypatch.setattr(sandbox, "find_spec", lambda name: None)
    assert "pip install -e '.[course]' in the book's folder" in sandbox.refusal()
    monkeypatch.setattr(sandbox.platform, "machine", lambda: "riscv64")
    assert sandbox.refusal() == "notebooks are run on Linux on x86-64 or ARM64 only"
