"""Test the explorer in JupyterLab: page and kernel keep the same joint values."""

import json
import os
import subprocess
import sys
import time
import urllib.request
from importlib.util import find_spec
from urllib.error import URLError

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook
from playwright.sync_api import expect

from tests.browser.reader import SKIP_DRAWING

CELLS = (
    "from helpers.explorer import ArmExplorer\n"
    "from helpers.robots import ELBOW, PANDA\n"
    "explorer = ArmExplorer(PANDA, views=['torque', 'trace'], arms=[ELBOW])\nexplorer",
    "print('joint 1 at', round(explorer.q[0], 4), 'pushed by', explorer.wrench[2])",
    "print('a path of', len(explorer.trace), 'configurations')",
    "explorer.q = [0.5, 0, 0, 2.0, 0, 3.0, 0]; explorer.wrench = [0, 0, -7, 0, 0, 0]",
    "explorer",
    "explorer.arm_name = 'Elbow arm'",
    "print(explorer.arm.name, 'with', len(explorer.q), 'joints,', explorer.q[0])",
    "from helpers.explorer import ArmFigure\nArmFigure('ellipsoid', PANDA, joints=[4])",
)


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    """Start a JupyterLab for this machine with one notebook and return its address."""
    if not find_spec("jupyterlab"):
        pytest.skip("JupyterLab is not installed here")
    home = tmp_path_factory.mktemp("lab")
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    notebook = new_notebook(cells=[new_code_cell(source) for source in CELLS], metadata=kernel)
    nbformat.write(notebook, home / "explorer.ipynb")
    port = 18000 + os.getpid() % 2000
    command = [
        sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}",
        "--IdentityProvider.token=", "--ServerApp.password=", f"--ServerApp.root_dir={home}",
        "--LabApp.news_url=", "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    ]  # fmt: skip
    folders = {f"JUPYTER_{kind}_DIR": str(home / kind.lower()) for kind in ("CONFIG", "RUNTIME")}
    with open(home / "log", "w", encoding="utf-8") as log:
        server = subprocess.Popen(command, env={**os.environ, **folders}, stdout=log, stderr=log)
        address = f"http://127.0.0.1:{port}"
        try:
            _wait_for(f"{address}/api", server, home / "log")
            yield address
        finally:
            server.terminate()
            try:
                server.wait(10)
            except subprocess.TimeoutExpired:  # a busy machine takes long to end its kernels
                server.kill()
                server.wait()


def _wait_for(address, server, log):
    for _ in range(600):
        try:
            urllib.request.urlopen(address, timeout=5).close()
        except (URLError, OSError):
            assert server.poll() is None, log.read_text(encoding="utf-8")
            time.sleep(0.25)
        else:
            return
    raise AssertionError(log.read_text(encoding="utf-8"))


def _until_connected(address):
    """Wait until JupyterLab is connected: before, it shows an idle kernel and loses a cell."""
    for _ in range(600):
        try:
            with urllib.request.urlopen(f"{address}/api/kernels") as answer:
                kernels = json.load(answer)
        except URLError:  # the server has an error for a kernel that is half started
            kernels = []
        if any(kernel["connections"] and kernel["execution_state"] == "idle" for kernel in kernels):
            return
        time.sleep(0.25)
    raise AssertionError(kernels)


def test_sliders_and_python_share_one_arm(browser, lab):
    page = browser.new_page(viewport={"width": 1300, "height": 1400})
    page.add_init_script(SKIP_DRAWING)
    page.set_default_timeout(180_000)  # a busy machine takes its time to start a kernel
    page.goto(f"{lab}/lab/tree/explorer.ipynb")
    page.locator(".jp-Notebook .jp-CodeCell").nth(3).wait_for()
    _until_connected(lab)

    def run(cell):
        page.locator(".jp-Notebook .jp-CodeCell .jp-InputArea-editor").nth(cell).click()
        page.keyboard.press("Shift+Enter")

    def comes_to_say(cell, words):
        """Run a cell until it prints a text, since the widget reports to the kernel with a delay."""
        said = page.locator(".jp-CodeCell").nth(cell).locator(".jp-OutputArea-output")
        for _ in range(60):
            run(cell)
            said.wait_for()
            if said.inner_text().strip() == words:
                return
            page.wait_for_timeout(500)
        raise AssertionError(said.inner_text())

    run(0)
    slider = page.get_by_role("slider", name="Joint 1, angle")
    slider.wait_for()
    slider.focus()
    for _ in range(3):
        page.keyboard.press("PageUp")  # ten degrees each
    page.get_by_label("F z, N", exact=True).fill("-4")
    comes_to_say(1, "joint 1 at 0.5236 pushed by -4.0")

    page.get_by_role("tab", name="Circle trace").click()
    page.get_by_role("button", name="Draw a circle from here").click()
    comes_to_say(2, "a path of 181 configurations")

    page.get_by_role("tab", name="Static torque").click()
    run(3)
    expect(slider).to_have_value("0.5", timeout=60_000)
    expect(page.get_by_label("F z, N", exact=True)).to_have_value("−7", timeout=60_000)

    run(4)  # a second view of the same explorer, which shares its state
    views = page.locator("section.explorer")
    expect(views).to_have_count(2, timeout=60_000)
    run(5)
    for view in (views.first, views.last):
        expect(view.get_by_role("slider", name="Joint")).to_have_count(3, timeout=60_000)
    views.first.get_by_label("Arm", exact=True).select_option("Panda")
    expect(views.last.get_by_role("slider", name="Joint")).to_have_count(7, timeout=60_000)
    views.last.get_by_label("Joint 1, angle, typed").fill("0.25 rad")
    views.last.get_by_label("Joint 1, angle, typed").press("Enter")
    comes_to_say(6, "Panda with 7 joints, 0.25")

    run(7)  # a chapter's small figure, of which a text cell shows only the words
    figure = page.locator("figure.live")
    expect(figure.locator(".words")).to_contain_text("Rank 6", timeout=60_000)
    stills = page.locator(".jp-RenderedSVG")
    assert stills.count(), "GitHub shows a picture"
    expect(stills.locator("visible=true")).to_have_count(0)
    figure.get_by_role("slider", name="Joint 4").focus()
    before = figure.locator("output").inner_text()
    page.keyboard.press("PageUp")
    expect(figure.locator("output")).not_to_have_text(before)
    page.close()
