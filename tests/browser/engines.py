"""Drive Firefox and WebKit by the same methods: open a page, ask, type, press, drag.

Playwright, which drives Chromium in all other tests, cannot drive Firefox and WebKitGTK as
distributions have them. These speak WebDriver BiDi and WebDriver, protocols of the W3C with the same
description of key and pointer actions.
"""

import json
import os
import shutil
import socket
import subprocess
import time
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.error import HTTPError
from urllib.request import Request, urlopen

from tools.browser import NoBrowser

WINDOW = {"width": 1200, "height": 900}
KEYS = {"\n": "\ue007", "End": "\ue010", "ArrowRight": "\ue014"}


class _WebDriverBrowser:
    """Type and drag by WebDriver actions, for Firefox and WebKit."""

    def type(self, text):
        kinds = ("keyDown", "keyUp")
        keys = [{"type": kind, "value": KEYS.get(key, key)} for key in text for kind in kinds]
        self.act({"type": "key", "id": "keys", "actions": keys})

    def press(self, key):
        self.type([key])

    def drag(self, start, end):
        places = [[a + (b - a) * k / 5 for a, b in zip(start, end, strict=True)] for k in range(6)]
        to, *on = (
            {"type": "pointerMove", "x": round(x), "y": round(y), "duration": 50} for x, y in places
        )
        down, up = ({"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp"))
        mouse = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}}
        self.act({**mouse, "actions": [to, down, *on, up]})


class Firefox(_WebDriverBrowser):
    """Drive Firefox by WebDriver BiDi, which needs no driver program."""

    def __init__(self, line):
        self.line, self.count, self.context = line, 0, {}
        self.send("session.new", capabilities={})
        first = self.send("browsingContext.getTree")["contexts"][0]
        self.context = {"context": first["context"]}
        self.send("browsingContext.setViewport", **self.context, viewport=WINDOW)

    def send(self, method, **params):
        self.count += 1
        self.line.send(json.dumps({"id": self.count, "method": method, "params": params}))
        while (answer := json.loads(self.line.recv())).get("id") != self.count:
            pass
        assert answer["type"] == "success", answer
        return answer["result"]

    def open(self, url):
        self.send("browsingContext.navigate", **self.context, url=url, wait="complete")

    def ask(self, script):
        text = f"JSON.stringify({script}) ?? 'null'"
        how = {"expression": text, "target": self.context, "awaitPromise": False}
        answer = self.send("script.evaluate", **how)
        assert answer["type"] == "success", answer
        return json.loads(answer["result"]["value"])

    def act(self, hand):
        self.send("input.performActions", **self.context, actions=[hand])


class WebKit(_WebDriverBrowser):
    """Drive WebKit by WebDriver."""

    def __init__(self, address):
        self.address = address
        self.address += f"/session/{self.send('/session', capabilities={})['sessionId']}"
        self.send("/window/rect", **WINDOW)

    def send(self, path, **params):
        try:
            with urlopen(Request(self.address + path, json.dumps(params).encode())) as answer:
                return json.load(answer)["value"]
        except HTTPError as error:
            raise OSError(f"{path} {params}: {error.read().decode()}") from error

    def open(self, url):
        self.send("/url", url=url)

    def ask(self, script):
        return self.send("/execute/sync", script=f"return {script}", args=[])

    def act(self, hand):
        self.send("/actions", actions=[hand])


@contextmanager
def firefox():
    import websocket  # comes with Jupyter

    with TemporaryDirectory() as profile, ExitStack() as running:
        name = "firefox-esr" if shutil.which("firefox-esr") else "firefox"
        _start(running, name, "--profile", profile, "--remote-debugging-port=0")
        told = Path(profile, "WebDriverBiDiServer.json")
        at = _until(lambda: json.loads(told.read_text(encoding="utf-8")))
        address = f"ws://{at['ws_host']}:{at['ws_port']}/session"
        yield Firefox(websocket.create_connection(address, suppress_origin=True, timeout=300))


@contextmanager
def webkit():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with ExitStack() as running:
        _start(running, "WebKitWebDriver", f"--port={port}")
        yield _until(lambda: WebKit(f"http://127.0.0.1:{port}"))


def _start(running, name, *arguments):
    """Start a browser or its driver on a virtual screen; `running` ends both."""
    for program in ("Xvfb", name):
        if not shutil.which(program):
            raise NoBrowser(f"{program} is not installed")
    screen = ["Xvfb", "-displayfd", "1", "-screen", "0", "1400x1200x24"]
    shown = _program(running, screen, stdout=subprocess.PIPE, text=True)
    display = {"DISPLAY": f":{shown.stdout.readline().strip()}", "LIBGL_ALWAYS_SOFTWARE": "1"}
    quiet = {"stdout": subprocess.DEVNULL, "env": os.environ | display}
    _program(running, [name, *arguments], **quiet)


def _program(running, words, **how):
    one = subprocess.Popen(words, stderr=subprocess.DEVNULL, **how)
    running.callback(one.wait)
    running.callback(one.terminate)
    return one


def _until(ready):
    """Call `ready` until it returns, for up to a minute while a program starts."""
    for _ in range(600):
        with suppress(OSError, ValueError):
            return ready()
        time.sleep(0.1)
    return ready()
