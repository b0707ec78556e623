"""Measure the script time of each frame while the Panda's tip is dragged in the explorer.

The processor is slowed to a quarter of its speed. Build the book first, then run
`python benchmarks/frames.py`. All drawing calls are made, but into one pixel: without a graphics
card, filling the pixels would take most of the time.
"""

import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from playwright.sync_api import Browser, sync_playwright  # noqa: E402

from tools.browser import launch_browser  # noqa: E402

RUNS, SLOWDOWN = 5, 4

# Adds up the time in animation callbacks, timers and pointer events of each frame.
CLOCK = """(() => {
    const spent = (window.spent = []);
    const raf = (window.unclocked = requestAnimationFrame.bind(window));
    const timeout = setTimeout.bind(window), listen = EventTarget.prototype.addEventListener;
    let [sum, last] = [0, 0];
    const clocked = (act) => function (...given) {
        const start = performance.now();
        try { return act.apply(this, given); } finally { sum += performance.now() - start; }
    };
    window.requestAnimationFrame = (act) => raf((now) => {
        if (now !== last) { spent.push(sum); [sum, last] = [0, now]; }
        clocked(act)(now);
    });
    window.setTimeout = (act, ...more) => timeout(clocked(act), ...more);
    EventTarget.prototype.addEventListener = function (type, act, how) {
        const moved = type === "pointermove" && typeof act === "function";
        return listen.call(this, type, moved ? clocked(act) : act, how);
    };
    const { viewport } = WebGL2RenderingContext.prototype;
    const { drawImage } = CanvasRenderingContext2D.prototype;
    WebGL2RenderingContext.prototype.viewport = function () { viewport.call(this, 0, 0, 1, 1); };
    CanvasRenderingContext2D.prototype.drawImage = function (image, ...place) {
        const gl = image.getContext?.("webgl2");
        return gl ? gl.flush() : drawImage.call(this, image, ...place);
    };
})()"""

# Drags the tip around a circle by a step for each frame.
DRAG = """(frames) => new Promise((done) => {
    const grip = document.querySelector(".arm-explorer").shadowRoot.querySelector(".grip");
    const { x, y, width, height } = grip.getBoundingClientRect();
    const at = (angle) => ({
        pointerId: 1, bubbles: true, composed: true, buttons: 1,
        clientX: x + width / 2 + 40 * Math.sin(angle),
        clientY: y + height / 2 + 40 * (1 - Math.cos(angle)),
    });
    grip.setPointerCapture = () => {};
    grip.dispatchEvent(new PointerEvent("pointerdown", at(0)));
    spent.length = 0;
    const step = (k) => {
        if (k > frames) {
            grip.dispatchEvent(new PointerEvent("pointerup", at(0)));
            return done(spent.slice(2));
        }
        grip.dispatchEvent(new PointerEvent("pointermove", at((2 * Math.PI * k) / frames)));
        return unclocked(() => step(k + 1));
    };
    unclocked(() => step(1));
})"""


def measure_drag(browser: Browser) -> list[float]:
    """Return milliseconds of script per frame of a drag, after a warm-up drag."""
    page = browser.new_page(viewport={"width": 1280, "height": 720})
    page.add_init_script(CLOCK)
    page.goto((ROOT / "book/_build/html/explorer.html").as_uri() + "#arm=Panda&view=pose")
    page.mouse.move(1, 1)
    page.locator("section.explorer").wait_for()
    page.wait_for_timeout(1000)
    page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": SLOWDOWN})
    page.evaluate(DRAG, 60)
    spent = page.evaluate(DRAG, 150)
    page.close()
    return sorted(spent)


def main() -> None:
    with sync_playwright() as playwright:
        browser = launch_browser(playwright)
        runs = [measure_drag(browser) for _ in range(RUNS)]
        browser.close()
    for share in (0.5, 0.95):
        times = [run[int(share * len(run))] for run in runs]
        name = "median" if share == 0.5 else "95 % under"
        each = ", ".join(f"{ms:.1f}" for ms in times)
        print(f"{name}: {statistics.median(times):.1f} ms (runs: {each})")


if __name__ == "__main__":
    main()
