"""Test the explorer in the built page by mouse, keyboard and touch, without a network."""

import re

import numpy as np
import pytest
from playwright.sync_api import expect

from helpers.kinematics import forward_kinematics, jacobian, link_frames
from helpers.robots import PANDA, STANFORD, UR10E
from tests.browser.reader import (
    ADD_UP_LAYOUT_SHIFTS,
    SCROLL_INTO_VIEW,
    SIZES,
    SKIP_DRAWING,
    WAIT_FOR_FRAMES,
    Reader,
    find_box,
    keep_first_typeface,
    until,
)
from tests.test_book import HTML

MINUS = "−"
INSTRUMENT = ".arm-explorer:not([data-figure])"

STORE = "document.querySelector('.arm-explorer').explorer.store"


def until_still(page):
    """Wait until the joints have stood still for six frames."""
    page.evaluate(
        f"""async () => {{
        const frame = () => new Promise(requestAnimationFrame);
        for (let still = 0, before = {STORE}.state.q; still < 6; before = {STORE}.state.q) {{
            await frame();
            still = {STORE}.state.q.every((v, k) => Math.abs(v - before[k]) < 1e-9) ? still + 1 : 0;
        }}
    }}"""
    )


# Replaces the explorer by its stub, and mounts the stub again as the page does for a link with this fragment.
KEEP_STUB = f"""document.addEventListener("DOMContentLoaded", () => {{
    window.originalStub = document.querySelector("{INSTRUMENT}")?.cloneNode(true);
}});"""
MOUNT_STUB_AGAIN = f"""(fragment) => {{
    const old = document.querySelector("{INSTRUMENT}"), stub = originalStub.cloneNode(true);
    stub.querySelector("script").replaceWith(old.querySelector("script"));
    old.explorer.dispose();
    old.replaceWith(stub);
    history.replaceState(null, "", fragment || location.pathname + location.search);
    ArmExplorer.mount(stub);
}}"""


class Visit(Reader):
    """A visit to a page with an explorer, which waits until the explorer is live."""

    def __init__(
        self,
        browser,
        fragment="",
        theme="light",
        size="wide",
        name="explorer",
        script="",
        **context,
    ):
        super().__init__(browser, theme, size, "file:", **context)
        self.visits, self.opened = 0, None
        self.page.add_init_script(KEEP_STUB + script)
        self.enter(fragment, name)

    def enter(self, fragment="", name="explorer", drawn=False):
        """Open a page, or mount its explorer anew if the page is open."""
        self.page.emulate_media(media="screen", reduced_motion="no-preference")
        again, self.opened = name == self.opened, name
        if not again:
            self.visits += 1  # a number in the address, since a fragment alone opens no new page
            self.page.goto(f"{(HTML / name).as_uri()}.html?{self.visits}{fragment}")
        self.page.evaluate("(drawn) => { window.skipsDrawing = !drawn; }", drawn)
        if again:
            self.page.evaluate(MOUNT_STUB_AGAIN, fragment)
        self.page.mouse.move(1, 1)
        self.page.locator(INSTRUMENT).evaluate(SCROLL_INTO_VIEW)
        self.page.wait_for_function(f"document.querySelector({INSTRUMENT!r})?.explorer")
        if drawn:
            self.page.locator(".stage .labels:not([hidden])").wait_for()

    def leave(self):
        """Let the next visit load the page anew."""
        self.opened = None

    def pose(self):
        self.tab("Pose")
        cells = self.page.locator(".matrix td").all_inner_texts()
        return np.array([float(cell.replace(MINUS, "-")) for cell in cells]).reshape(4, 4)

    def tab(self, name):
        self.page.get_by_role("tab", name=name).click()

    def state(self, field):
        """Return a field of the explorer's state."""
        return self.page.evaluate(f"{STORE}.state.{field}")

    def q(self):
        return np.array(self.state("q"))

    def fragment(self):
        self.page.get_by_role(
            "button", name="Copy link"
        ).click()  # without it, it follows at a calm pace
        return self.page.evaluate("location.hash")


# Removes the small figure of the explorer's page: it has labels like the explorer's and comes alive during the tests.
PREPARE_SHARED_PAGE = f"""{SKIP_DRAWING}
Object.defineProperty(window, "devicePixelRatio", {{ value: 0.5 }});
document.addEventListener("DOMContentLoaded", () => {{
    if (location.pathname.endsWith("/explorer.html")) document.querySelectorAll("[data-figure]").forEach((f) => f.remove());
}});"""


@pytest.fixture(scope="module")
def shared_page(browser):
    """Share one page in light colours on a wide screen.

    The processor draws the pictures, so only tests that look at them have them drawn, with half the
    pixels in each direction.
    """
    here = Visit(browser, script=PREPARE_SHARED_PAGE)
    yield here
    here.context.close()


@pytest.fixture
def visit(browser, shared_page):
    visits = []

    def enter(fragment="", name="explorer", drawn=False, **kwargs):
        if shared_page in visits:
            kwargs["script"] = PREPARE_SHARED_PAGE
        if kwargs:
            visits.append(Visit(browser, fragment, name=name, **kwargs))
        else:
            shared_page.enter(fragment, name, drawn)
            visits.append(shared_page)
        return visits[-1]

    yield enter
    problems = [problem for each_visit in visits for problem in each_visit.problems]
    shared_page.problems.clear()
    for each_visit in visits:
        if each_visit is not shared_page:
            each_visit.context.close()
    if problems:
        shared_page.leave()
    assert problems == []


# For each link, without any input: its arm, its tab, the first fields of the joints, and text that the tab shows.
HOME_OF_PANDA = ["0.0°", "0.0°", "0.0°", "90.0°", "0.0°", "180.0°", "0.0°"]
POSED = "#arm=Panda&q=0.1,0.2,0.3,1.4,0.5,1.6,0.7"
IN_DEGREES = ["5.7°", "11.5°", "17.2°", "80.2°", "28.6°", "91.7°", "40.1°"]
TYPED = "#arm=Elbow arm&q=0.6,-1.1&view=table&rows=R,0.4,0,0,0;R,0.3,0,0,0"
RUN = "euler_inverse_1000_5_0.1_x_0_1e-9_0.02_2_"
LINKS = [
    ("", "Panda", "DH table", HOME_OF_PANDA, ""),
    ("#arm=Panda (homework)&view=trace", "Panda (homework)", "Circle trace", HOME_OF_PANDA, "Draw a circle from here"),
    ("#arm=UR10e&view=jacobian", "UR10e", "Jacobian", ["0.0°", "−90.0°", "0.0°", "−90.0°", "0.0°", "0.0°"], "manipulability"),
    ("#arm=UR10e+(homework)&view=branches", "UR10e (homework)", "IK branches", ["0.0°"] * 6, "Find the solutions for this pose"),
    ("#arm=Stanford arm&view=pose", "Stanford arm", "Pose", ["0.0°", "0.0°", "0.500 m", "0.0°"], "Tip at ("),
    ("#arm=Elbow arm&view=branches", "Elbow arm", "IK branches", ["0.0°", "45.0°", "−90.0°"], "Find the solutions for this position"),
    (POSED + "&view=torque&wrench=-5,0,0,0,0,0", "Panda", "Static torque", IN_DEGREES, "−5"),
    (POSED + "&unit=rad&frames=ends", "Panda", "DH table", ["0.100 rad", "0.200 rad", "0.300 rad"], "unpressed Frames"),
    (TYPED, "Your arm", "DH table", ["34.4°", "−63.0°"], "Yours has 2 joints"),
    ("#arm=Elbow arm&view=pose&mark=0.3,0.2,0.75", "Elbow arm", "Pose", ["0.0°"], "from the mark"),
    (f"#arm=Panda (homework)&view=homework&runs={RUN};{RUN}next", "Panda (homework)", "Play the homework", HOME_OF_PANDA, "1.145 mm"),
    ("#arm=Nobody", "Panda", "DH table", HOME_OF_PANDA, "no arm called “Nobody”"),
    ("#arm=Panda&q=1,2", "Panda", "DH table", HOME_OF_PANDA, "Panda has 7 joint values"),
]  # fmt: skip

LIST_SHOWN_STATE = """() => {
    const { shadowRoot } = document.querySelector(".arm-explorer"), one = (name) => shadowRoot.querySelector(name);
    const pressed = [...shadowRoot.querySelectorAll("header button")].find((b) => b.textContent === "Frames");
    const fields = [...shadowRoot.querySelectorAll(".view input")].map((e) => e.value).join(" ");
    return {
        arm: one("select.name").selectedOptions[0].textContent,
        tab: one("[role=tab][aria-selected=true]").textContent,
        joints: [...shadowRoot.querySelectorAll(".joint .value")].map((e) => e.value),
        words: `${one(".notice").textContent} ${one(".view").textContent} ${fields} `
            + (pressed.ariaPressed === "true" ? "" : "unpressed Frames"),
        layoutShift,
    };
}"""


@pytest.fixture(scope="module")
def untouched(browser):
    """Share a page for tests without input, in a system font: a late web font would move a line."""
    page = browser.new_page(viewport=SIZES["wide"], offline=True)
    page.add_init_script(SKIP_DRAWING + ADD_UP_LAYOUT_SHIFTS)
    keep_first_typeface(page)
    yield page
    page.context.close()


@pytest.mark.parametrize(
    ("size", "link", "arm", "tab", "joints", "words"),
    [("wide", *one) for one in LINKS] + [("phone", *one) for one in LINKS[::6]],
    ids=lambda one: str(one)[:40],
)
def test_link_state_shows_without_interaction(untouched, size, link, arm, tab, joints, words):
    untouched.set_viewport_size(SIZES[size])
    untouched.goto("about:blank")
    untouched.goto(f"{(HTML / 'explorer.html').as_uri()}{link}")
    untouched.locator("section.explorer .view > div").wait_for()
    untouched.wait_for_function(f"({LIST_SHOWN_STATE})().words.includes('{words}')")
    untouched.evaluate(WAIT_FOR_FRAMES, 6)
    seen = untouched.evaluate(LIST_SHOWN_STATE)
    assert seen["arm"] == arm.replace(" (homework)", ", homework’s lengths")
    assert seen["tab"] == tab
    assert seen["joints"][: len(joints)] == joints
    assert seen["layoutShift"] < 0.01, "the page’s own arm stood there, with other joints"
    picture = find_box(untouched.locator("section.explorer .stage"))
    assert picture["y"] + picture["height"] / 2 < SIZES[size]["height"], "the first thing there"


def test_pose_of_dragged_slider_equals_python(visit):
    here = visit()
    home = here.pose()
    np.testing.assert_allclose(home, forward_kinematics(PANDA, PANDA.home), atol=5.1e-5)
    slider = here.page.get_by_role("slider", name="Joint 4, angle")
    box = find_box(slider)
    here.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    here.page.mouse.down()
    here.page.mouse.move(box["x"] + 0.8 * box["width"], box["y"] + box["height"] / 2, steps=5)
    here.page.mouse.up()
    q = np.array(PANDA.home)
    q[3] = slider.evaluate("e => Number(e.value)")
    assert q[3] > PANDA.home[3] + 0.5
    np.testing.assert_allclose(here.pose(), forward_kinematics(PANDA, q), atol=5.1e-5)
    np.testing.assert_allclose(here.q(), q, atol=1e-6)


def test_keys_move_joints_tabs_and_view(visit):
    here = visit("#arm=Panda&view=pose", drawn=True)
    here.page.get_by_role("slider", name="Joint 1, angle").focus()
    here.page.keyboard.press("PageUp")
    here.page.keyboard.press("Shift+ArrowRight")
    assert here.q()[0] == pytest.approx(np.radians(10.1), abs=1e-6)
    here.page.get_by_role("tab", name="Pose").focus()
    here.page.keyboard.press("ArrowRight")
    expect(here.page.get_by_role("tab", name="Jacobian")).to_have_attribute("aria-selected", "true")
    picture = here.page.locator(".stage canvas")
    before = picture.screenshot()
    here.page.locator(".stage").focus()
    for _ in range(5):
        here.page.keyboard.press("ArrowLeft")
    until(here.page, lambda: picture.screenshot() != before)


def test_typed_values_are_validated(visit):
    here = visit("#arm=Stanford arm&view=pose")
    field = here.page.get_by_label("Joint 2, angle, typed")
    field.fill("pi/2")
    field.press("Enter")
    slide = here.page.get_by_label("Joint 3, slide, typed")
    slide.fill("0.7 m")
    slide.press("Enter")
    expected = [0, np.pi / 2, 0.7, 0, 0, 0]
    np.testing.assert_allclose(here.q(), expected, atol=1e-6)
    np.testing.assert_allclose(here.pose(), forward_kinematics(STANFORD, expected), atol=5.1e-5)
    field.fill("ninety")
    field.press("Enter")
    expect(here.page.locator(".sliders .error")).to_contain_text("“ninety” is no number")
    np.testing.assert_allclose(here.q(), expected, atol=1e-6)


def test_bad_table_entry_keeps_last_arm(visit):
    here = visit()
    here.page.locator("[data-cell='3-a']").fill("0.1")
    expect(here.page.locator(".dh .verdict")).to_contain_text("17.5 mm")
    here.page.locator("[data-cell='3-a']").fill("100 mm")
    here.page.locator("[data-cell='5-alpha']").fill("9o")
    assert here.page.locator("[data-cell='3-a']").input_value() == "0.1", "in the column's unit"
    words = here.page.locator(".dh .error").inner_text()
    assert words.startswith("Row 5, α “9o” is no number")
    assert words.endswith("The last good arm stays.")
    rows = list(PANDA.rows)
    rows[2] = type(rows[2])(0.1, "-pi/2", "d_3")
    mine = type(PANDA)("mine", tuple(rows), PANDA.values)
    here.page.get_by_role("button", name="rad", exact=True).click()
    expect(here.page.locator("[data-cell='1-alpha']")).to_have_value("π/2")
    np.testing.assert_allclose(here.pose(), forward_kinematics(mine, PANDA.home), atol=5.1e-5)


def test_table_rows_are_added_and_removed(visit):
    here = visit("#arm=Elbow arm")
    here.page.get_by_role("button", name="Add a row").click()
    here.page.get_by_label("Row 4, kind of joint").select_option("prismatic")
    expect(here.page.get_by_role("slider", name="Joint 4, slide")).to_have_count(1)
    here.page.get_by_role("button", name="Remove row 2").click()
    expect(here.page.get_by_role("slider")).to_have_count(3)
    here.page.get_by_role("button", name="Back to the first table").click()
    expect(here.page.get_by_role("slider")).to_have_count(3)
    expect(here.page.locator(".dh .verdict")).to_contain_text("stays as a ghost")
    here.page.locator("[data-cell='3-a']").fill("0.088")
    again = visit(here.fragment())
    assert again.state("arm.name") == "Your arm"
    expect(again.page.locator("[data-cell='3-a']")).to_have_value("0.088")


def test_shown_jacobian_equals_python(visit):
    q = [0.4, -1.2, 1.3, -1.2, -1.2, 0.3]
    here = visit(f"#arm=UR10e&view=jacobian&q={','.join(map(str, q))}")
    cells = here.page.locator(".heat td").all_inner_texts()
    shown = np.array([float(cell.replace(MINUS, "-")) for cell in cells]).reshape(6, 6)
    np.testing.assert_allclose(shown, jacobian(UR10E, q), atol=5.1e-4)


def test_static_torques_follow_the_force_ball(visit):
    here = visit("#arm=Panda&view=torque", drawn=True)
    field = here.page.get_by_label("F x, N", exact=True)
    field.fill("-5")
    totals = here.page.locator(".bars .total").all_inner_texts()
    expected = [0, 21.81431, 0, -16.702654, 0.696491, 0.235249, -0.03068]
    shown = [float(text.replace(MINUS, "-")) for text in totals]
    np.testing.assert_allclose(shown, expected, atol=5.1e-3)
    field.fill("push")
    expect(here.page.locator(".torque > .error")).to_contain_text("The last good wrench stays")
    field.fill("-5")
    here.page.get_by_role("button", name="Fit").click()
    box = find_box(here.page.locator(".stage canvas"))
    ball = find_force_ball(here.page)
    here.page.mouse.move(box["x"] + ball[0], box["y"] + ball[1])
    here.page.mouse.down()
    here.page.mouse.move(box["x"] + ball[0] + 5, box["y"] + ball[1] - 60, steps=6)
    here.page.mouse.up()
    pushed = here.page.get_by_label("F z, N", exact=True).input_value()
    assert float(pushed.replace(MINUS, "-")) < -1, "the ball above the tip pushes down"


def find_force_ball(page):
    """Return the pixel of the force's ball, the rightmost of its colour."""
    from io import BytesIO

    from PIL import Image

    picture = np.asarray(
        Image.open(BytesIO(page.locator(".stage canvas").screenshot())).convert("RGB")
    )
    match = np.abs(picture.astype(int) - (199, 126, 0)).sum(axis=-1) < 30
    rows, columns = np.nonzero(match)
    near = columns > columns.max() - 18
    return float(np.median(columns[near])), float(np.median(rows[near]))


# Presses Pause at the first frame in which the arm has moved, since a slow machine may take as long to find the button
# as the path lasts (8 s). Returns the progress at the pause and three frames later, and the largest number of frames
# requested during one frame: requests that doubled in each frame once froze the page.
PLAYED_AND_PAUSED = f"""(button) => new Promise((done) => {{
    const store = {STORE}, own = requestAnimationFrame.bind(window);
    let asked = 0, most = 0;
    const moved = () => Math.max(...store.state.q.map((v, k) => Math.abs(v - store.state.trace[0][k])));
    const later = (frames, then) => own(() => (frames ? later(frames - 1, then) : then()));
    const watch = () => {{
        most = Math.max(most, asked);
        asked = 0;
        if (store.state.playing && moved() <= 0.05) return later(0, watch);
        window.requestAnimationFrame = own;
        button.click();
        const {{ progress }} = store.state;
        later(3, () => done([progress, store.state.progress, most]));
    }};
    button.click();
    window.requestAnimationFrame = (act) => (asked++, own(act));
    watch();
}});"""


def test_circle_is_traced_played_and_scrubbed(visit):
    here = visit("#arm=Panda (homework)&view=trace")
    here.page.get_by_role("button", name="Draw a circle from here").click()
    expect(here.page.locator(".trace .verdict")).to_contain_text("would have to pass their limits")
    expect(here.page.locator(".plots figure")).to_have_count(7)
    button = here.page.get_by_role("button", name="Play")
    here.page.locator(
        ".stage .labels:not([hidden])"
    ).wait_for()  # The first picture requests frames too.
    paused, later, most = button.evaluate(PLAYED_AND_PAUSED)
    expect(button).to_be_visible()
    assert 0 < paused == later < 1, "on the way, and it stays there"
    assert 1 <= most <= 2, "frames: one for the motion and one for the picture"
    moved = np.abs(here.q() - here.state("trace[0]")).max()
    assert moved > 0.05
    scrub = here.page.get_by_role("slider", name="Place along the path")
    scrub.fill("500")
    here.page.get_by_label("Plane of the circle").focus()
    tip = here.pose()[:3, 3]
    np.testing.assert_allclose(tip, [0.679, 0, 0.825 - 0.2], atol=2e-4)
    here.tab("Circle trace")
    axes = here.page.locator(".labels > span:not([hidden])", has_text=": 0.1 m")
    expect(axes).to_have_text(["y: 0.1 m", "z: 0.1 m"])
    here.page.get_by_label("What the plots show").select_option("torque")
    expect(here.page.locator(".plots figcaption").first).to_contain_text("N m")
    here.page.get_by_label("Radius of the circle, m").fill("-1")
    here.page.get_by_role("button", name="Draw a circle from here").click()
    expect(here.page.locator(".trace .error")).to_contain_text("no length above 0")


# Lists the pixels of the picture over which the cursor is a pointer.
POINTED = """(canvas) => {
    const { left, top, width, height } = canvas.getBoundingClientRect(), found = [];
    for (let y = 10; y < height; y += 32)
        for (let x = 10; x < width; x += 32) {
            canvas.dispatchEvent(new PointerEvent("pointermove", { clientX: left + x, clientY: top + y, bubbles: true }));
            const hit = canvas.getRootNode().elementFromPoint(left + x, top + y);
            if (canvas.style.cursor === "pointer" && hit === canvas) found.push([x, y]);
        }
    return found;
}"""


def test_branches_are_chosen_in_picture_and_list(visit):
    q = [0.4, -1.2, 1.3, -1.2, -1.2, 0.3]
    here = visit(f"#arm=UR10e&view=branches&q={','.join(map(str, q))}")
    here.page.get_by_role("button", name="Find the solutions for this pose").click()
    ways, canvas = here.page.locator(".solutions button"), here.page.locator(".stage canvas")
    expect(ways).to_have_count(8)
    wanted = forward_kinematics(UR10E, q)

    def wait_for_arrival():
        until(here.page, lambda: np.abs(here.q() - q).max() > 0.1)
        until(
            here.page, lambda: np.allclose(forward_kinematics(UR10E, here.q()), wanted, atol=1e-5)
        )

    canvas.scroll_into_view_if_needed()
    box = find_box(canvas)
    ghosts, before = canvas.evaluate(POINTED), None
    while ghosts != before:  # until the picture has come to rest
        here.page.evaluate(WAIT_FOR_FRAMES, 6)
        ghosts, before = canvas.evaluate(POINTED), ghosts
    share = len(ghosts) * 32**2 / (box["width"] * box["height"])
    assert 0.01 < share < 0.3, "the ghosts, and nothing around them"
    x, y = ghosts[len(ghosts) // 2]
    canvas.click(position={"x": x, "y": y})
    wait_for_arrival()
    for i in (3, 6):
        ways.nth(i).click()
        expect(ways.nth(i)).to_have_attribute("aria-current", "true")
        wait_for_arrival()
    turned = here.q() - 2 * np.pi * np.sign(here.q())  # every joint by a whole turn
    here.page.evaluate(f"(q) => {STORE}.dispatch({{ type: 'moveJoints', q }})", turned.tolist())
    expect(here.page.locator(".solutions [aria-current='true']")).to_have_count(1)
    expect(ways.nth(6)).to_have_attribute("aria-current", "true")


# Follow the chapters' instructions and compare with what they announce.


def type_value(page, label, text):
    field = page.get_by_label(label, exact=True)
    field.fill(text)
    field.press("Enter")


def test_chapter_1_offset_slides_on_parallel_axes(
    visit,
):
    page = visit(name="01_dh_tables").page
    verdict = page.locator(".dh .verdict")
    page.locator("[data-cell='2-d']").fill("0.1639")
    expect(verdict).to_contain_text("163.9 mm")
    page.locator("[data-cell='4-d']").fill("0")
    type_value(page, "Joint 3, angle, typed", "70")
    type_value(page, "Joint 5, angle, typed", "-40")
    expect(verdict).to_contain_text("0.0 mm and 0.0°")

    page.get_by_role("button", name="Back to the first table").click()
    type_value(page, "Joint 3, angle, typed", "0")
    for row in (2, 3):
        page.locator(f"[data-cell='{row}-alpha']").fill("0")
    for joint in (1, 2, 4, 5, 6):
        type_value(page, f"Joint {joint}, angle, typed", "25")
    expect(verdict).to_contain_text("0.0 mm and 0.0°")
    type_value(page, "Joint 3, angle, typed", "25")
    assert "0.0 mm" not in verdict.inner_text()


def test_live_figures_share_one_webgl_context(visit):
    page = visit(name="01_dh_tables").page
    figures = page.locator("[data-figure]").all()
    assert len(figures) >= 3
    expect(figures[-1].locator("canvas")).to_have_count(0)
    for figure in figures:
        figure.evaluate(SCROLL_INTO_VIEW)
        figure.locator("canvas").wait_for()
    assert page.evaluate("ArmExplorer.getUsage().figures") == len(figures) + 1


def test_chapter_2_joints_3_and_5_restore_rank(visit):
    page = visit(name="02_jacobian").page
    verdict = page.locator(".jacobian .verdict:not([hidden])")
    lost = "Here the tip cannot move along y, move along z nor turn about x."
    assert verdict.inner_text() == f"Singular: rank 3 of 6. {lost}"
    for joint in (1, 6):
        type_value(page, f"Joint {joint}, angle, typed", "30")
        expect(verdict).to_contain_text("rank 3 of 6")
        type_value(page, f"Joint {joint}, angle, typed", "0")
    type_value(page, "Joint 3, angle, typed", "30")
    expect(verdict).to_contain_text("rank 5 of 6")
    type_value(page, "Joint 5, angle, typed", "30")
    assert verdict.inner_text().startswith("Rank 6")


def test_chapter_3_joints_turn_once_round_on_the_homework_circle_only(visit):
    page = visit(name="03_circle_tracing").page
    verdict = page.locator(".trace .verdict")
    assert verdict.inner_text().startswith("Joint 5 and joint 7 would have to pass their limits")
    spans = page.locator(".plots .past .span").all_inner_texts()
    assert spans == [f"{MINUS}360.0° … 0.0°"] * 2
    for joint, angle in {1: "0", 2: "25", 4: "85", 5: "0", 6: "150", 7: "0"}.items():
        type_value(page, f"Joint {joint}, angle, typed", angle)
    page.get_by_role("button", name="Draw a circle from here").click()
    expect(verdict).to_have_text("All joints stay within their limits.")
    expect(page.locator(".plots .past")).to_have_count(0)
    page.locator(INSTRUMENT).get_by_label("Arm", exact=True).select_option("Panda, elbow out")
    expect(verdict).not_to_have_text("All joints stay within their limits.")
    page.get_by_role("button", name="Draw a circle from here").click()
    expect(verdict).to_have_text("All joints stay within their limits.")
    expect(page.locator(".plots .past")).to_have_count(0)


def test_chapter_4_pushed_pen_overloads_joint_6(visit):
    page = visit(name="04_static_torque").page
    totals = page.locator(".bars .total")
    expect(totals.nth(1)).to_have_text("22.18")
    page.get_by_label("F x, N", exact=True).fill("5")
    expect(totals.nth(1)).to_have_text("27.10")  # 4.92 N m more
    page.get_by_label("F x, N", exact=True).fill("0")
    page.get_by_label("F z, N", exact=True).fill("-60")
    verdict = page.locator(".torque .verdict")
    expect(verdict).to_have_text("Too much for joint 6.")
    type_value(page, "Joint 6, angle, typed", "90")
    expect(verdict).to_contain_text("Every joint can hold this.")
    page.get_by_role("tab", name="Circle trace").click()
    page.get_by_label("What the plots show").select_option("torque")
    expect(page.locator(".plots figure")).to_have_count(7)


LIST_NAMELESS_CONTROLS = """e => [...e.querySelectorAll("button, input, select, [tabindex='0']")]
    .filter(c => !(c.getAttribute("aria-label") || c.textContent.trim() || c.labels?.length))
    .map(c => c.outerHTML.slice(0, 120))"""


@pytest.mark.parametrize(("theme", "size"), [("light", "wide"), ("dark", "phone")])
def test_every_tab_fits_and_names_its_controls(visit, theme, size):
    here = visit(theme=theme, size=size)
    card = here.page.locator("section.explorer")
    expect(card).to_have_attribute("data-theme", theme)
    for name in ("DH table", "Pose", "Jacobian", "Circle trace", "Static torque", "IK branches"):
        here.tab(name)
        assert here.page.evaluate("document.documentElement.scrollWidth") <= SIZES[size]["width"]
        assert card.evaluate("e => e.scrollWidth <= e.clientWidth + 1")
        assert card.evaluate(LIST_NAMELESS_CONTROLS) == []
    other = "dark" if theme == "light" else "light"
    here.page.evaluate(f"document.documentElement.dataset.theme = '{other}'")
    expect(card).to_have_attribute("data-theme", other)
    here.page.emulate_media(media="print")
    expect(card.locator(".still")).to_be_visible()
    expect(card.locator("header, .views, canvas").locator("visible=true")).to_have_count(0)


def test_wide_layout_shows_all_columns(visit):
    """In a wide panel the picture is on the left and every tab fits its column of 530 px."""
    here = visit("#arm=UR10e")
    here.page.locator(INSTRUMENT).evaluate(
        "e => e.style.cssText = 'width: 1100px; max-width: none'"
    )
    for name in ("DH table", "Jacobian"):
        here.tab(name)
        table = here.page.locator(".view .scroll")
        assert find_box(table)["x"] > find_box(here.page.locator(".stage canvas"))["x"]
        assert table.evaluate("e => e.scrollWidth <= e.clientWidth + 1")
    here.leave()


def test_undo_button_keeps_the_focus(visit):
    here = visit("#arm=Panda&view=pose")
    here.page.get_by_role("slider", name="Joint 1, angle").press("ArrowRight")
    undo = here.page.get_by_role("button", name="Undo")
    undo.click()
    expect(undo).to_be_focused()
    expect(undo).to_have_attribute("aria-disabled", "true")
    here.page.keyboard.press("Control+y")
    assert here.q()[0] == pytest.approx(np.pi / 180)


def test_reduced_motion_skips_the_glide(visit):
    here = visit("#arm=UR10e&view=pose")
    here.page.emulate_media(reduced_motion="reduce")
    here.page.get_by_label("Joint 1, angle, typed").fill("90")
    here.page.get_by_label("Joint 1, angle, typed").press("Enter")
    here.page.get_by_role("button", name="Home").click()
    np.testing.assert_allclose(here.pose(), forward_kinematics(UR10E, UR10E.home), atol=5.1e-5)


def test_numbers_work_without_webgl(browser):
    here = Reader(browser, "light", "wide", "file:")
    here.page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    page = here.open((HTML / "explorer.html").as_uri() + "#arm=Panda&view=pose")
    page.wait_for_function(f"document.querySelector({INSTRUMENT!r})?.explorer")
    stage = page.locator("section.explorer .stage")
    stage.hover()
    stage.get_by_text("No WebGL").wait_for()
    before = stage.locator(".still").evaluate("e => e.outerHTML")
    page.get_by_label("Joint 4, angle, typed").fill("120")
    page.get_by_label("Joint 4, angle, typed").press("Enter")
    assert page.get_by_role("slider", name="Joint 4, angle").evaluate("e => Number(e.value)") == pytest.approx(np.radians(120))  # fmt: skip
    expect(stage.locator(".still")).to_be_visible()
    assert stage.locator(".still").evaluate("e => e.outerHTML") != before, "it follows"
    here.context.close()


def pixel_of(page, frame):
    """Return the pixel of a frame's origin in the window."""
    return page.evaluate(
        f"""() => {{
        const canvas = document.querySelector('.arm-explorer').shadowRoot.querySelector('.stage canvas');
        const [x, y] = canvas.figure.projectToPixel({STORE}.derived.frames.at({frame}).o);
        const box = canvas.getBoundingClientRect();
        return [box.left + x, box.top + y];
    }}"""
    )


def drag_mouse(page, start, by, steps=8):
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(start[0] + by[0], start[1] + by[1], steps=steps)
    until_still(page)


def test_arm_is_dragged_by_links_and_tip(visit):
    """Drag a link and the tip, read why it stops, undo, pin the tip and swing the elbow."""
    here = visit("#arm=Panda&view=pose&q=0.1,-0.4,0.3,1.6,0.2,1.9,0.4")
    page = here.page
    start = here.q()
    page.locator(".stage").scroll_into_view_if_needed()
    for frame, by in ((4, (30, 15)), (4, (300, 400)), (-1, (500, -80))):
        drag_mouse(page, pixel_of(page, frame), by)
        lower, upper = PANDA.limits
        assert ((here.q() >= lower - 1e-9) & (here.q() <= upper + 1e-9)).all()
        turned = np.flatnonzero(np.abs(here.q() - start) > 1e-6)
        assert frame == -1 or turned.tolist() == [3], "a link turns its joint, and no other"
        why = page.locator(".why").text_content()
        assert re.fullmatch(r".*: \d+ mm short\." if frame == -1 else "", why)
        assert 5 <= page.evaluate("ArmExplorer.getUsage().calls") <= 16
        assert here.state("dragging")
        page.mouse.up()
        assert not here.state("dragging")
        np.testing.assert_allclose(here.pose(), forward_kinematics(PANDA, here.q()), atol=5.1e-5)
        page.get_by_role("button", name="Undo").click()
        np.testing.assert_allclose(here.q(), start, atol=1e-12)

    page.get_by_role("button", name="Pin the tip").click()
    drag_mouse(page, pixel_of(page, 3), (35, 20))
    page.mouse.up()
    assert np.abs(here.q() - start).max() > 0.05
    poses = forward_kinematics(PANDA, np.array([here.q(), start]))
    np.testing.assert_allclose(*poses, atol=1e-6)

    before = poses[0][:3, 3]
    page.get_by_role("button", name="Tip", exact=True).focus()
    for _ in range(3):
        page.keyboard.press("ArrowUp")
    moved = forward_kinematics(PANDA, here.q())[:3, 3] - before
    assert np.linalg.norm(moved) == pytest.approx(0.03, abs=2e-3)
    page.get_by_label("Tip z, typed").fill("0.5")
    page.get_by_label("Tip z, typed").press("Enter")
    assert forward_kinematics(PANDA, here.q())[2, 3] == pytest.approx(0.5, abs=1e-3)


def test_dragged_tip_explains_why_it_stops(visit):
    page = visit("#arm=Elbow arm&view=pose").page
    said = []
    for x in ("0.6", "0.69", "0.9"):
        type_value(page, "Tip x, typed", x)
        said.append(page.locator(".why").text_content())
    assert said[:2] == ["", "Nearly singular along the arrow."]
    straight = "Joint 3 straight, in line with joint 2 and the tip"
    assert re.fullmatch(straight + r": 20\d mm short\.", said[2])
    assert page.locator(".view .error").last.inner_text() == said[2]
    page.get_by_role("button", name="Pin the tip").click()
    page.get_by_role("button", name="Tip pinned (place): nothing is free").wait_for()
    here = visit("#arm=Panda&view=pose")
    type_value(here.page, "Tip z, typed", "-1")
    assert "Joint 2 at its limit" in here.page.locator(".why").text_content()
    type_value(here.page, "Tip x, typed", "2")
    assert "Joint 4 straight, in line with" in here.page.locator(".why").text_content()
    joint_2, joint_4, tip = (link_frames(PANDA, here.q())[k] for k in (1, 3, -1))
    forearm, upper_arm = tip[:3, 3] - joint_4[:3, 3], joint_4[:3, 3] - joint_2[:3, 3]
    area = np.cross(forearm, upper_arm) @ joint_4[:3, 2]  # seen along axis 4
    assert abs(area) < 0.01 * np.linalg.norm(forearm) * np.linalg.norm(upper_arm)


@pytest.mark.parametrize("size", ["wide", "phone"])
@pytest.mark.parametrize("frame", [-1, 5])
def test_view_follows_a_dragged_tip(visit, size, frame):
    """Drag the tip, or a link that carries it, out of the picture on each side and upward."""
    here = visit("#arm=Panda&view=pose", size=size)
    page = here.page
    stage = page.get_by_role("application")
    stage.scroll_into_view_if_needed()
    for by in ((0, -400), (500, -100), (-500, -100)):
        page.get_by_role("button", name="Home").click()
        until(page, lambda: np.allclose(here.q(), PANDA.home))
        box = find_box(stage)
        drag_mouse(page, pixel_of(page, frame), by, steps=20)
        x, y = pixel_of(page, -1)
        page.mouse.up()
        assert box["x"] < x < box["x"] + box["width"]
        assert box["y"] < y < box["y"] + box["height"]


def test_view_follow_keeps_the_drag_steady(visit):
    """A pointer that rests outside of the picture lets the arm rest."""
    here = visit("#arm=Panda&view=pose&q=0.1,-0.4,0.3,1.6,0.2,1.9,0.4")
    here.page.locator(".stage").scroll_into_view_if_needed()
    drag_mouse(here.page, pixel_of(here.page, -1), (0, -160), steps=20)
    rest = here.q()
    here.page.evaluate(WAIT_FOR_FRAMES, 30)
    np.testing.assert_allclose(here.q(), rest, atol=1e-6)
    here.page.mouse.up()


def test_memory_does_not_grow(visit):
    """Twenty explorers share one context, survive its loss, and leave nothing behind."""
    here = visit("#arm=Panda&view=table")
    here.leave()
    page = here.page
    page.locator(".stage").scroll_into_view_if_needed()
    answer = page.evaluate(
        """async () => {
        const store = document.querySelector('.arm-explorer').explorer.store;
        let buffers = 0;
        for (const [name, step] of [['createBuffer', 1], ['deleteBuffer', -1], ['createVertexArray', 1], ['deleteVertexArray', -1]]) {
            const own = WebGL2RenderingContext.prototype[name];
            WebGL2RenderingContext.prototype[name] = function (...given) { buffers += step; return own.apply(this, given); };
        }
        const still = () => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)));
        const until = async (holds) => { for (let n = 0; n < 900 && !holds(); n++) await still(); };
        const spec = document.querySelector('.arm-explorer script').textContent;
        const { arms } = JSON.parse(spec);
        const round = async (times) => {
            for (let n = 0; n < times; n++) {
                store.dispatch({ type: 'selectArm', arm: arms[n % arms.length] });
                const rows = store.state.arm.rows.map((row, k) => (k ? row : { ...row, a: 0.001 * (n + 1) }));
                store.dispatch({ type: 'editTable', rows });
                await still();
            }
            store.dispatch({ type: 'selectArm', arm: arms[0] });
            await still();
            return { ...ArmExplorer.getUsage(), buffers };
        };
        const [first, later] = [await round(arms.length), await round(2 * arms.length)];
        const hosts = Array.from({ length: 19 }, () => {
            const host = document.createElement('div');
            host.innerHTML = '<script type="application/json"></' + 'script>';
            host.firstChild.textContent = spec.replace('"link":true', '"link":false');
            document.querySelector('.arm-explorer').before(host);
            return [host, ArmExplorer.mount(host)];
        });
        await until(() => ArmExplorer.getUsage().figures === 20);
        const many = ArmExplorer.getUsage().figures;
        const context = ArmExplorer.getContextLoser();
        const note = hosts[0][0].shadowRoot.querySelector('.lost');
        const quiet = note.hidden;
        context.loseContext();
        await until(() => !note.hidden);
        const told = quiet && !note.hidden;
        context.restoreContext();
        await until(() => note.hidden);
        const back = note.hidden;
        for (const [host, made] of hosts) {
            made.dispose();
            host.remove();
        }
        await still();
        return { first, later, many, told, back, after: ArmExplorer.getUsage() };
    }"""
    )
    assert answer["later"]["geometries"] == answer["first"]["geometries"]
    assert answer["later"]["textures"] == answer["first"]["textures"]
    assert answer["later"]["buffers"] == answer["first"]["buffers"]
    assert answer["many"] == 20
    assert answer["told"]
    assert answer["back"]
    assert answer["after"]["figures"] == 1
    lost = (
        "does not belong to this context",
        "Context Lost",
        "CONTEXT_LOST",
    )  # what Chromium says of it
    here.problems[:] = [one for one in here.problems if not any(words in one for words in lost)]


# Describes the control with the focus: its name, and whether the picture covers its top edge. Null above the sliders.
FOCUSED_PART = """() => {
    const root = document.querySelector(".arm-explorer").shadowRoot;
    const focused = root.activeElement;
    if (!focused?.closest(".sliders, .views")) return null;
    const bottom = root.querySelector(".stage").getBoundingClientRect().bottom;
    return { name: focused.outerHTML.slice(0, 80), covered: focused.getBoundingClientRect().top < bottom };
}"""


@pytest.mark.parametrize("view", ["table", "branches", "trace"])
def test_shift_tab_stops_below_the_picture(visit, view):
    """On a phone, the picture that stays covers no control with the focus (WCAG 2.2, 2.4.11)."""
    page = visit(f"#arm=Panda&view={view}", size="phone", script=PREPARE_SHARED_PAGE).page
    page.evaluate(
        """() => [...document.querySelector(".arm-explorer").shadowRoot.querySelectorAll(".views :is(button, input, select)")]
            .findLast((part) => part.checkVisibility() && !part.disabled && part.tabIndex >= 0).focus()"""
    )
    visited = []
    while part := page.evaluate(FOCUSED_PART):
        visited.append(part)
        page.keyboard.press("Shift+Tab")
    assert len(visited) > 8
    assert [part["name"] for part in visited if part["covered"]] == []


def test_vertical_swipe_ignores_sliders(visit):
    """On a phone: large targets, a picture that stays, sliders that a vertical swipe leaves alone."""
    here = visit(
        "#arm=Panda&view=table",
        size="phone",
        script=PREPARE_SHARED_PAGE,
        has_touch=True,
        is_mobile=True,
    )
    page = here.page
    small = page.evaluate(
        """() => [...document.querySelector('.arm-explorer').shadowRoot.querySelectorAll('button, select, input[type=text]')]
            .filter((e) => e.getClientRects().length && !e.closest('[hidden]'))
            .map((e) => [e.getBoundingClientRect().height, e.outerHTML.slice(0, 80)]).filter(([height]) => height < 43.5)"""
    )
    assert small == []
    rail = page.locator(".rail").nth(3)
    start = here.q()
    touch = page.context.new_cdp_session(page)

    def swipe(dx, dy):
        rail.hover(trial=True)  # scrolls until the picture that stays does not cover it
        box = find_box(rail)
        x, y = box["x"] + 0.2 * box["width"], box["y"] + box["height"] / 2
        points = [{"x": x + dx * k / 6, "y": y + dy * k / 6} for k in range(7)]
        touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": points[:1]})
        for point in points[1:]:
            touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [point]})
        touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        until_still(page)

    swipe(0, -120)
    np.testing.assert_allclose(here.q(), start, atol=1e-12)

    def has_moved():
        """Swipe sideways. A touch on a page that still scrolls only stops it."""
        swipe(60, 0)
        return here.q()[3] > start[3] + 0.1

    until(page, has_moved)
    assert here.q()[3] < start[3] + 2, "from where it stood, not to where the thumb is"
    page.locator("[data-cell='7-d']").scroll_into_view_if_needed()
    picture = find_box(page.locator(".stage"))
    assert picture["y"] >= 0
    assert picture["y"] + picture["height"] < 844, "the picture is in view while one types"


def test_pasted_table_fills_the_cells_and_is_announced_once(visit):
    here = visit("#arm=Elbow arm&view=table")
    here.leave()
    page = here.page
    cell = page.locator("[data-cell='1-a']")
    cell.focus()
    cell.evaluate(
        """(e) => {
        window.heard = [];
        const region = document.querySelector('.arm-explorer').shadowRoot.querySelector('[aria-live]');
        new MutationObserver(() => region.textContent && heard.push(region.textContent)).observe(region, { childList: true });
        window.due = new Map();  // from here on no time passes, however slow the machine
        window.setTimeout = (then) => (due.set(-due.size - 1, then), -due.size);
        const clear = window.clearTimeout;
        window.clearTimeout = (timer) => due.set(timer, null) && clear(timer);
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', '0\\tpi/2\\t0.6\\tq1\\n0.45\\t0\\t0\\tq2\\n0.3\\t0\\t0\\tq3');
        e.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
    }"""
    )
    page.wait_for_function(f"{STORE}.state.arm.name === 'Your arm'")  # the reader comes with it
    assert here.state("arm.rows.length") == 3
    page.locator("[data-cell='1-a']:focus").wait_for()
    expect(page.locator("[data-cell='1-d']")).to_have_value("0.6")
    expect(page.locator("[data-cell='2-a']")).to_have_value("0.45")
    assert here.q() == pytest.approx([0, 0, 0])
    page.get_by_role("slider", name="Joint 1, angle").focus()
    for _ in range(30):
        page.keyboard.press("ArrowRight")
    page.evaluate("(async () => { for (const [, then] of [...due]) { then?.(); await null; } })()")
    heard = page.evaluate("heard")
    assert len(heard) == 1
    assert heard[0].startswith("Tip at x ")
