"""Test the judge's form in the built pages: typing, verdicts, marked cells, links, without a network."""

import re
from datetime import datetime, timedelta
from itertools import count
from urllib.parse import urlencode

import pytest
from playwright.sync_api import expect

from helpers.explorer import judge
from tests.browser.reader import (
    ADD_UP_LAYOUT_SHIFTS,
    AXE,
    LIST_AXE_FINDINGS,
    SCROLL_INTO_VIEW,
    SKIP_DRAWING,
    find_box,
    keep_first_typeface,
    load_with_storage,
    read_storage,
)
from tests.cases import questions_about, typed_fields
from tests.test_book import HTML

PAGE = HTML / "check_your_homework.html"
LIVE_VERDICT = ".arm-judge:not(:has(> .unscripted)) .verdict"
ELBOW = """-0.2841 -0.3039 -0.0778
0.5200 -0.1660 -0.0425
0.0000 0.5925 0.2866
0.0000 0.4794 0.4794
0.0000 -0.8776 -0.8776
1.0000 0.0000 0.0000"""  # at (0.5, 0.7, -0.4), by hand

LIST_OVERFLOWING_PARTS = """() => [...document.querySelectorAll(".arm-judge, .arm-judge :not(.scroll *, .marked pre *)")]
  .filter((part) => part.getBoundingClientRect().right > innerWidth).map((part) => part.outerHTML.slice(0, 80))"""

# Counts the lines that some words take in a box of width 0, where no line has room for two.
LINES = """(box, words) => {
  box.style.width = 0;
  const texts = document.createTreeWalker(box, NodeFilter.SHOW_TEXT), range = document.createRange();
  while (!texts.nextNode().data.includes(words));
  const node = texts.currentNode, at = node.data.indexOf(words);
  range.setStart(node, at);
  range.setEnd(node, at + words.length);
  return new Set([...range.getClientRects()].map((one) => one.top)).size;
}"""


LOOKS = [("light", 1280, 800), ("dark", 390, 844)]
wide, phone, both = (
    pytest.mark.parametrize("page", looks, indirect=True, ids=str)
    for looks in (LOOKS[:1], LOOKS[1:], LOOKS)
)


@pytest.fixture
def page(request, browser):
    """Open the form with an empty storage; no picture is drawn in it."""
    scheme, width, height = request.param
    context = browser.new_context(
        viewport={"width": width, "height": height}, color_scheme=scheme, offline=True
    )
    context.add_init_script(SKIP_DRAWING)
    page = context.new_page()
    problems = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    enter(page)
    yield page
    context.close()
    assert problems == []


visit_numbers = count(1)


def enter(page, fragment=""):
    """Load the page anew and wait for the form.

    A number makes each address another one, since a new fragment alone loads nothing.
    """
    page.goto(f"{PAGE.as_uri()}?{next(visit_numbers)}{fragment}")
    page.locator(LIVE_VERDICT).wait_for()


def ask(page, answer, q="0.5, 0.7, -0.4"):
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    page.get_by_label("Configuration q").fill(q)
    page.get_by_label("Your answer", exact=True).fill(answer)


def list_serious_findings(page, part=".arm-judge"):
    """List the serious findings of axe in a part of the page."""
    page.add_script_tag(path=AXE)
    return page.locator(part).first.evaluate(LIST_AXE_FINDINGS)


def verdict(page, words):
    page.locator(".arm-judge .verdict", has_text=words).wait_for()


@wide
def test_link_restores_typed_answer(page):
    verdict(page, "joint i turns about the axis of the frame before it")
    expect(page.locator(".arm-judge td.off")).to_have_count(15)  # of 18: last two axes coincide
    ask(page, ELBOW)
    verdict(
        page, "The Jacobian of Elbow arm is right at q = (0.5, 0.7, -0.4), to the digits you gave."
    )
    expect(page.locator(".arm-judge td.off")).to_have_count(0)
    ask(page, ELBOW.replace("0.2866", "0.3866"))
    verdict(page, "olumn 3 (joint 3): check vz.")
    expect(page.locator(".arm-judge td.off")).to_have_text(["wrong: 0.3866"])
    page.get_by_role("button", name="Copy link").click()
    page.get_by_text("The link").first.wait_for()
    other = page.context.new_page()
    other.goto(page.url)
    verdict(other, "check vz")
    expect(other.get_by_label("Your answer", exact=True)).to_have_value(
        ELBOW.replace("0.2866", "0.3866")
    )
    other.close()


@wide
def test_report_of_wrong_answer_is_copied(page):
    """The report has question, answer, reading and verdict, also without a clipboard."""
    button = page.get_by_role("button", name="Copy a report of this")
    verdict(page, "An example, with a mistake in it.")
    expect(button).to_be_hidden()
    ask(page, ELBOW)
    verdict(page, "is right at q = (0.5, 0.7, -0.4), to the digits you gave")
    expect(button).to_be_hidden()
    for answer, words in (
        (
            "Here are\n1 2 3\n4 5 6",
            ["Read:\n", "row 1\t1\t2\t3\n", "Said:\nI find 2 rows of 3 numbers"],
        ),
        (
            ELBOW.replace("0.2866", "0.3866"),
            ["vz\t", "wrong: 0.3866", "column 3 (joint 3): check vz"],
        ),
    ):
        ask(page, answer)
        verdict(page, words[-1].removeprefix("Said:\n"))
        button.click()
        report = page.get_by_label("The report")
        report.wait_for()
        for part in (
            "Question: Jacobian at a configuration\nArm: Elbow arm\nConfiguration q: 0.5, 0.7, -0.4\n",
            f"Typed:\n{answer}\n",
            *words,
        ):
            assert part in report.input_value(), report.input_value()
    page.get_by_text("whoever keeps this book").wait_for()


@phone
def test_torques_typed_by_keyboard_set_the_example_wrench(page):
    page.get_by_label("Question").focus()
    page.keyboard.press("ArrowDown")
    verdict(page, "Type or paste your answer.")
    page.get_by_role("button", name="Show an example").press("Enter")
    verdict(page, "the force has the wrong sign")
    expect(page.get_by_label("Wrench on the tool")).to_be_visible()
    note = page.get_by_text("This wrench is the example's")
    expect(note).to_be_visible()
    page.get_by_label("Wrench on the tool").fill("0, 0, -5, 0, 0, 0")
    note.wait_for(state="hidden")


@wide
def test_table_reading_is_shown(page):
    page.get_by_label("Question", exact=True).select_option(label="Denavit-Hartenberg table")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    heads = "a (mm) alpha (deg) d (mm) theta"
    typed = f"{heads}\n0 90 500 q1\n400 0 0 q2+90\n200 0 0 q3"
    page.get_by_label("Your answer", exact=True).fill(typed)
    verdict(page, "a in row 3 is 100 mm too short (you have 200).")
    assert page.locator(".arm-judge .verdict").evaluate(LINES, "100 mm") == 1
    expect(page.locator(".arm-judge td.off")).to_have_text(["wrong: 0.2"])
    expect(page.locator(".arm-judge .scroll td", has_text="+ 90°")).to_have_count(1)
    page.get_by_label("Your answer", exact=True).fill(typed.replace("\n200", "\n300"))
    verdict(page, "with other zeros or directions of its joints")
    page.locator(".arm-judge summary", has_text="Taken").click()
    page.get_by_label("Convention", exact=True).select_option("craig")
    verdict(page, "the modified (Craig) convention, turned into the standard one")


@wide
def test_joint_angles_of_a_table_are_used_and_forgotten(page):
    page.get_by_label("Question", exact=True).select_option(label="Denavit-Hartenberg table")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    table = "a (mm) alpha (deg) d (mm) theta\n0 90 500 q1\n400 0 0 q2+90\n300 0 0 q3"
    page.get_by_label("Your answer", exact=True).fill(table)
    page.get_by_role("button", name="Use my joint angles").click()
    page.get_by_label("Question", exact=True).select_option(label="Jacobian at a configuration")
    page.get_by_label("Configuration q").fill(f"0.5, {0.7 - 1.5707963}, -0.4")
    page.get_by_label("Your answer", exact=True).fill(ELBOW)
    verdict(page, "in your joints is right")
    page.get_by_role("button", name="Forget my joint angles").click()
    verdict(page, "The Jacobian of Elbow arm is not right")


FORMULAS = """-s_1*(L*c_2+a_3*c_23), -c_1*(L*s_2+a_3*s_23), -a_3*c_1*s_23
c_1*(L*c_2+a_3*c_23), -s_1*(L*s_2+a_3*s_23), -a_3*s_1*s_23
0, L*c_2+a_3*c_23, a_3*c_23
0, sin(q_1), s_1
0, -cos(q_1), -c_1
1, 0, 0"""

COUNT_ANNOUNCEMENTS = """() => {
  window.announcements = 0;
  new MutationObserver(() => window.announcements++)
    .observe(document.querySelector(".arm-judge .verdict"), { childList: true });
}"""


@phone
def test_formulas_are_read_while_typed(page):
    ask(page, FORMULAS)
    verdict(page, "no value for L")
    read = page.locator(".arm-judge .read")
    page.locator(".arm-judge summary", has_text="Taken").click()
    expect(read.locator("caption")).to_have_text(re.compile("; 5 entries could not be$"))
    expect(read.locator("td.off").first).to_have_text("not read: -s_1*(L*c_2+a_3*c_23)")
    page.get_by_label("Your own symbols").fill("L = 0.4")
    verdict(page, "The Jacobian of Elbow arm is right.")
    cell = read.locator("td", has_text="= 0.2866")
    expect(cell.locator("msub")).to_have_text(["a3", "c23"])
    page.set_viewport_size({"width": 320, "height": 700})
    assert page.evaluate(LIST_OVERFLOWING_PARTS) == []
    assert list_serious_findings(page) == []
    page.get_by_role("button", name="Copy link").click()
    page.get_by_text("The link").first.wait_for()
    assert "values=L+%3D+0.4" in page.url


PASTED = """(field, text) => {
  field.value = text;
  field.dispatchEvent(new InputEvent("input", { bubbles: true, inputType: "insertFromPaste" }));
  return document.querySelector(".arm-judge .verdict").textContent;
}"""


@phone
def test_pasted_answer_is_judged_at_once(page):
    ask(page, "")
    page.locator(".arm-judge summary", has_text="Taken").click()
    page.get_by_label("Your own symbols").fill("L = 0.4")
    verdict(page, "Type or paste your answer.")
    field = page.get_by_label("Your answer", exact=True)
    assert "The Jacobian of Elbow arm is right." in field.evaluate(PASTED, FORMULAS)
    page.locator(".arm-judge .read td", has_text="= 0.2866").wait_for()


def test_verdict_is_announced_after_a_pause(browser):
    page = browser.new_page(offline=True)
    page.clock.install()
    enter(page)
    ask(page, "")
    page.clock.pause_at(datetime.now() + timedelta(hours=1))  # all earlier pauses are over
    verdict(page, "Type or paste your answer.")
    page.evaluate(COUNT_ANNOUNCEMENTS)
    page.get_by_label("Your answer", exact=True).press_sequentially("[0.5 1 2; 3 4]")
    page.clock.run_for(200)
    expect(page.locator(".arm-judge .read")).to_contain_text("0.5")
    assert page.evaluate("announcements") == 0
    page.clock.run_for(2000)
    verdict(page, "I find 5 numbers")
    assert page.evaluate("announcements") == 1
    page.close()


@phone
def test_typed_markup_is_not_executed(page):
    hostile = "<img src=x onerror=window.hit=1>, 1, a_{<script>window.hit=2</script>}"
    ask(page, f"{hostile}\n1, 2, 3")
    read = page.locator(".arm-judge .read")
    read.locator("td", has_text="<img src=x").wait_for()
    expect(read.locator("img, script")).to_have_count(0)
    assert page.evaluate("window.hit") is None
    enter(page, "#ask=jacobian&arm=<b>Nobody</b>")
    page.get_by_text("there is no arm called “<b>Nobody</b>” here").wait_for()


@both
def test_form_fits(page):
    assert page.evaluate(LIST_OVERFLOWING_PARTS) == []
    assert (
        page.get_by_role("region", name="How your answer is read").evaluate("e => e.tabIndex") == 0
    )


SIX_COLUMNS = """-0.154 0 1 0 0 0
0.763 0 0 0 0 0
0 -0.763 0 0 -0.263 0
0 0 0 1 0 1
0 1 0 0 1 0
1 0 0 0 0 0"""  # the Stanford arm with its boom level, by hand


@pytest.fixture
def chapter(browser):
    """Open a chapter on a phone, without its formulas."""
    context = browser.new_context(viewport={"width": 390, "height": 800}, offline=True)
    page = context.new_page()
    page.add_init_script(SKIP_DRAWING)

    def open_page(name):
        page.goto((HTML / f"{name}.html").as_uri())
        return page

    yield open_page
    context.close()


def scroll_to(place):
    """Scroll until a small judge is live; parts that become live on the way move the page."""
    for _ in range(300):
        place.evaluate(SCROLL_INTO_VIEW)
        if not place.locator(".unscripted").count():
            return place
        place.page.wait_for_timeout(100)
    raise AssertionError("no judge came to life")


def test_chapter_form_hides_given_fields(chapter):
    page = chapter("02_jacobian")
    for name in ("judge", "explorer"):  # far away
        expect(page.locator(f"script[src$='{name}.js']")).to_have_count(0)
    place = scroll_to(page.locator(".arm-judge").nth(1))
    place.get_by_label("Your answer", exact=True).fill("1 2 3")
    place.locator(".verdict", has_text="I find 3 numbers").wait_for()
    place = scroll_to(page.locator(".arm-judge").nth(0))
    expect(place.locator("label:visible")).to_have_text(["Your answer"])
    answer = place.get_by_label("Your answer", exact=True)
    answer.fill(SIX_COLUMNS)
    place.locator(".verdict", has_text="The Jacobian of Stanford arm is right").wait_for()
    answer.fill(SIX_COLUMNS.replace("-0.154", "-0.254"))
    place.locator(".verdict", has_text="olumn 1 (joint 1): check vx").wait_for()
    place.get_by_role("link", name="More room").click()
    verdict(page, "olumn 1 (joint 1): check vx")
    expect(page.get_by_label("Configuration q")).to_have_value("0, pi/2, 0.5, 0, 0, 0")


@pytest.mark.parametrize(
    ("name", "number", "answer", "words"),
    [
        ("exercises/dh_tables", 0, "0.325 0 0.4 q1\n0.225 pi 0 q2\n0 0 q3 0\n0 0 0 q4", "same arm"),
        ("03_circle_tracing", 0, "0 0 1.57 0 3.14 0\n" * 9, "does not draw the path"),
        ("04_static_torque", 0, "0 27.09615 0 -18.43515 0.696491 1.115249 -0.03068", "wrong sign"),
        ("05_inverse_kinematics", 0, "1 2 3", "and q3 belong to no branch"),
    ],
)
def test_chapter_form_judges_its_question(chapter, name, number, answer, words):
    place = scroll_to(chapter(name).locator(".arm-judge").nth(number))
    place.get_by_label("Your answer", exact=True).fill(answer)
    place.locator(".verdict", has_text=words).wait_for()


@phone
def test_trajectory_file_is_judged(page, tmp_path):
    page.get_by_label("Question").select_option("trace")
    page.get_by_role("button", name="Show an example").click()
    verdict(page, "the path is drawn in the opposite direction")
    assert page.locator(".arm-judge .verdict").evaluate(LINES, "200 mm") == 1
    rows = page.get_by_label("Your answer", exact=True).input_value().split("\n")
    file = tmp_path / "run.csv"
    file.write_text("\n".join(",".join(row.split()) for row in rows[::-1]), "utf-8")
    page.locator("input[type=file]").set_input_files(file)
    page.get_by_text("From run.csv, 25 lines.").wait_for()
    verdict(page, "UR10e (homework) draws the path")
    caption = page.locator(".path figcaption")
    expect(caption).to_have_text(re.compile("yours, its errors 10+ times as large"))


@both
def test_answer_field_is_on_first_screen(page):
    page.add_init_script(ADD_UP_LAYOUT_SHIFTS)
    keep_first_typeface(page)
    enter(page)
    verdict(page, "An example, with a mistake in it.")
    field = find_box(page.get_by_label("Your answer", exact=True))
    assert field["y"] + 100 < page.viewport_size["height"]
    assert page.evaluate("scrollY") == 0
    assert page.evaluate("layoutShift") < 0.001


@phone
def test_verdict_stays_above_phone_keyboard(page):
    page.set_viewport_size({"width": 390, "height": 480})  # what a keyboard leaves of 844
    page.evaluate("matchMedia = () => ({ matches: true })")
    field = page.get_by_label("Your answer", exact=True)
    field.focus()
    page.keyboard.insert_text("1, 2, 3")  # the example was chosen whole
    verdict(page, "expected: ")
    expect(field).to_have_value("1, 2, 3")
    line, box = find_box(page.locator(".arm-judge .short")), find_box(field)
    expect(page.locator(".arm-judge .short")).to_contain_text("I find 3 numbers")
    assert line["y"] > find_box(page.locator(".bar"))["height"]
    assert line["height"] < 30
    assert line["y"] + line["height"] < box["y"]
    assert box["y"] + box["height"] < 480


@phone
def test_untouched_form_shows_no_error(page):
    field = page.get_by_label("Your answer", exact=True)
    arms = page.get_by_label("Arm", exact=True)
    for question in ("jacobian", "torques", "table", "branches", "pose", "trace"):
        page.get_by_label("Question", exact=True).select_option(question)
        begins = page.get_by_label("Configuration q at which the circle begins", exact=True)
        expect(begins).to_be_visible(visible=question == "trace")
        offered = ("UR10E", "ELBOW") if question == "branches" else ("PANDA", "UR10E", "ELBOW")
        for arm in (*offered, "UR10E_HOMEWORK"):
            arms.select_option(arm)
            example = "An example" in page.locator(".arm-judge .verdict").inner_text()
            assert example == (field.input_value() != "")
            expect(field).to_have_attribute("aria-invalid", "false")
            expect(page.locator(".verdict:is(.wrong, .rounded, .so)")).to_have_count(0)
    page.get_by_label("Question", exact=True).select_option("jacobian")
    expect(page.get_by_label("Configuration q")).to_have_value("0, 0, 0, 0, 0, 0")  # the arm's home


OPEN_FRAGMENT = """fragment => new Promise((done) => {
  addEventListener("hashchange", done, { once: true });
  if (location.hash === `#${fragment}`) done();
  location.hash = fragment;
})"""
LIST_GRADE_COLOURS = """box => ["right", "so far", "rounded", "wrong"].map((grade) => {
  box.className = `verdict ${grade}`;
  return getComputedStyle(box).borderLeftColor;
})"""


@phone
def test_common_answers_are_explained_on_phone(page):
    for case in questions_about("brought")[
        ::5
    ]:  # their words are tested once, by tests/test_judge.py
        page.evaluate(OPEN_FRAGMENT, urlencode({**typed_fields(case), "answer": ""}))
        page.get_by_label("Your answer", exact=True).fill(case["answer"])
        for words in case.get("said", ["Type or paste your answer."]):
            # Only Python lists the values that are left out; the page shows them in the typed text.
            verdict(page, "are right" if words.startswith("set aside") else words)
        assert page.evaluate(LIST_OVERFLOWING_PARTS) == [], case
    one_way = judge.EXAMPLES[3] | {"answer": "0.5000  0.7000 -0.4002"}
    page.evaluate(OPEN_FRAGMENT, urlencode(one_way))
    box = page.locator(".arm-judge .verdict.so")
    right, so_far, rounded, wrong = box.evaluate(LIST_GRADE_COLOURS)
    assert so_far == rounded
    assert len({right, so_far, wrong}) == 3


SWAPPED = "\n".join(ELBOW.splitlines()[3:] + ELBOW.splitlines()[:3])


@phone
def test_advice_button_sets_its_field(page):
    ask(page, SWAPPED, "28.6479, 40.1070, -22.9183")
    offered = page.locator(".arm-judge .offer button")
    offered.first.wait_for()
    expect(offered).to_have_text(
        ["Angles in: deg", "Order of the rows: ω, then v"], use_inner_text=True
    )
    for left in (1, 0):
        offered.first.click()
        page.wait_for_function(f"document.querySelectorAll('.offer button').length === {left}")
    verdict(page, "is right")
    taken = page.locator(".arm-judge summary", has_text="Taken")
    expect(taken).to_contain_text("angles in deg; rows ω, then v")


WRONG = ELBOW.replace("0.2866", "0.3866")


@wide
def test_typed_answer_survives_a_reload(page):
    ask(page, WRONG)
    verdict(page, "check vz")
    load_with_storage(page, read_storage(page, "judge:"), lambda: enter(page))
    verdict(page, "check vz")
    expect(page.get_by_label("Your answer", exact=True)).to_have_value(WRONG)
    expect(page.get_by_label("Configuration q")).to_have_value("0.5, 0.7, -0.4")


@wide
def test_each_question_and_arm_keeps_its_own_answer(page):
    question, arm = (page.get_by_label(name, exact=True) for name in ("Question", "Arm"))
    answer, q = page.get_by_label("Your answer", exact=True), page.get_by_label("Configuration q")
    ask(page, WRONG)
    question.select_option("pose")
    expect(answer).to_have_value("")
    answer.fill("0.1 0.2 0.3")
    question.select_option("jacobian")
    expect(answer).to_have_value(WRONG)
    arm.select_option("UR10E")
    expect(answer).to_have_value("")
    expect(q).to_have_value("0, −π/2, 0, −π/2, 0, 0")  # the arm's home
    question.select_option("pose")
    arm.select_option("ELBOW")
    expect(answer).to_have_value("0.1 0.2 0.3")
    question.select_option("jacobian")
    expect(answer).to_have_value(WRONG)
    expect(q).to_have_value("0.5, 0.7, -0.4")


@phone
def test_answer_of_another_arm_is_fetched_by_a_button(page):
    ask(page, ELBOW)
    verdict(page, "is right at q")
    page.get_by_label("Arm", exact=True).select_option("STANFORD")
    answer = page.get_by_label("Your answer", exact=True)
    expect(answer).to_have_value("")
    page.get_by_text(
        "Your answer to “Jacobian at a configuration, Elbow arm” stays there."
    ).wait_for()
    page.get_by_role("button", name="Use it here").click()
    expect(answer).to_have_value(ELBOW)
    expect(page.get_by_role("button", name="Use it here")).to_have_count(0)


@wide
def test_configuration_without_an_answer_is_kept(page):
    arm, q = page.get_by_label("Arm", exact=True), page.get_by_label("Configuration q")
    ask(page, "", "0.1, 0.2, 0.3")
    arm.select_option("UR10E")
    arm.select_option("ELBOW")
    expect(q).to_have_value("0.1, 0.2, 0.3")


@wide
def test_cleared_answer_comes_back_by_undo(page):
    ask(page, WRONG)
    page.get_by_label("Arm", exact=True).select_option("UR10E")
    answer = page.get_by_label("Your answer", exact=True)
    answer.fill("1 2 3")
    clear, undo = (page.get_by_role("button", name=name, exact=True) for name in ("Clear", "Undo"))
    clear.click()
    expect(answer).to_have_value("")
    verdict(page, "Type or paste your answer.")
    undo.click()
    expect(answer).to_have_value("1 2 3")
    clear.click()
    answer.fill("4")
    expect(undo).to_have_count(0)
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    expect(answer).to_have_value(WRONG)  # another answer stays


def open_second_tab(page, answer):
    """Ask in the first tab, and return a second tab that shares its storage.

    Both are loaded again where Chromium gave one a storage of its own (`load_with_storage`).
    """
    other = page.context.new_page()
    for _ in range(5):
        ask(page, answer)
        enter(other)
        if read_storage(other, "judge:") == read_storage(page, "judge:"):
            return other
        enter(page)
    raise AssertionError("in five loads, two tabs did not share their storage")


@wide
def test_forgetting_everything_asks_and_reaches_other_tabs(page):
    other = open_second_tab(page, WRONG)
    verdict(other, "check vz")
    forget = page.get_by_role("button", name="Forget everything")
    questions = []

    def answer_question(accepted):
        def answer(dialog):
            questions.append(dialog.message)
            dialog.accept() if accepted else dialog.dismiss()

        page.once("dialog", answer)
        forget.click()

    answer_question(False)
    verdict(page, "check vz")
    answer_question(True)
    page.get_by_text("this browser keeps none of your answers").wait_for()
    assert questions == ["Forget all answers that you typed anywhere in this book?"] * 2
    for tab in (page, other):
        verdict(tab, "An example, with a mistake in it.")
    stored = read_storage(page, "judge:")
    assert list(stored) == ["judge:cleared"]
    other.close()
    load_with_storage(page, stored, lambda: enter(page))
    verdict(page, "An example, with a mistake in it.")


@wide
def test_unreadable_own_table_is_reported_before_an_answer_is_typed(page):
    page.get_by_label("Arm", exact=True).select_option("own")
    table = page.get_by_label("Table", exact=True)
    reading = page.locator(".arm-judge p.reading")
    table.fill("a alpha d theta\n0 0 what? q1")
    reading.get_by_text("what?").wait_for()
    expect(table).to_have_attribute("aria-invalid", "true")
    table.fill("a alpha d theta\n0 0 0.4 q1\n0.3 0 0 q2")
    reading.get_by_text("Read as 2 joints").wait_for()
    expect(table).to_have_attribute("aria-invalid", "false")


@wide
def test_only_arms_with_formulas_are_offered_for_all_branches(page):
    question, arm = (page.get_by_label(name, exact=True) for name in ("Question", "Arm"))
    arm.select_option("PANDA")
    question.select_option("branches")
    offered = arm.locator("option:not([disabled])").evaluate_all("(all) => all.map((o) => o.value)")
    assert offered == ["UR10E", "UR10E_HOMEWORK", "STANFORD", "ELBOW", "own"]
    expect(arm).to_have_value("UR10E")
    question.select_option("jacobian")
    expect(arm.locator("option[disabled]")).to_have_count(0)


@phone
def test_wide_formulas_are_shown_column_by_column(page):
    ask(page, FORMULAS.replace("L*", "a_2*"))
    verdict(page, "is right")
    tables = page.locator(".arm-judge .by-column table")
    expect(tables.locator("caption")).to_have_text(["joint 1", "joint 2", "joint 3"])
    expect(tables.first.locator("tbody th")).to_have_text(["vx", "vy", "vz", "ωx", "ωy", "ωz"])
    expect(tables.locator("math")).to_have_count(12)
    assert page.evaluate(LIST_OVERFLOWING_PARTS) == []
    assert list_serious_findings(page) == []
    page.set_viewport_size({"width": 1000, "height": 700})
    expect(page.locator(".arm-judge table.grid")).to_have_count(1)
    expect(tables).to_have_count(0)


@wide
def test_two_tabs_keep_answers_to_two_questions(page):
    ask(page, WRONG)
    other = page.context.new_page()
    enter(other, "#ask=pose&arm=ELBOW")
    other.get_by_label("Your answer", exact=True).fill("0.1 0.2 0.3")
    page.get_by_label("Configuration q").fill("0.5, 0.7, -0.3")
    stored = read_storage(other, "judge:") | read_storage(page, "judge:")
    load_with_storage(page, stored, lambda: enter(page))
    expect(page.get_by_label("Your answer", exact=True)).to_have_value(WRONG)
    page.get_by_label("Question", exact=True).select_option("pose")
    expect(page.get_by_label("Your answer", exact=True)).to_have_value("0.1 0.2 0.3")


REFUSED = """Object.defineProperty(window, "localStorage", {
  get() { throw new DOMException("refused", "SecurityError"); } })"""


def test_form_works_where_storage_is_refused(browser):
    page = browser.new_page()
    page.add_init_script(REFUSED)
    problems = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    enter(page)
    ask(page, WRONG)
    verdict(page, "check vz")
    page.get_by_role("button", name="Clear", exact=True).click()
    verdict(page, "Type or paste your answer.")
    assert problems == []
    page.close()


def test_chapter_form_keeps_its_answer(chapter):
    page = chapter("02_jacobian")
    place = scroll_to(page.locator(".arm-judge").nth(0))
    answer = place.get_by_label("Your answer", exact=True)
    answer.fill(SIX_COLUMNS)
    stored = read_storage(page, "judge:")
    load_with_storage(page, stored, lambda: chapter("02_jacobian"))
    scroll_to(place)
    expect(answer).to_have_value(SIX_COLUMNS)
    place.locator(".verdict", has_text="The Jacobian of Stanford arm is right").wait_for()


@wide
def test_all_columns_of_the_grid_are_visible(page):
    page.get_by_label("Question", exact=True).select_option("torques")
    page.get_by_role("button", name="Show an example").click()
    page.get_by_label("Question", exact=True).select_option("jacobian")
    for arm in ("PANDA", "UR10E"):
        page.get_by_label("Arm", exact=True).select_option(arm)
        columns = 7 if arm == "PANDA" else 6
        page.get_by_label("Your answer", exact=True).fill("\n".join([" -0.8491" * columns] * 6))
        page.locator(".read thead th", has_text="joint").nth(columns - 1).wait_for()
        box = page.locator(".arm-judge .taken")
        assert box.evaluate("(e) => e.scrollWidth <= e.clientWidth"), arm


@wide
def test_checked_path_is_drawn_beside_the_target_path(page):
    page.get_by_label("Question").select_option("trace")
    page.get_by_role("button", name="Show an example").click()
    verdict(page, "the path is drawn in the opposite direction")
    points = page.locator(".path polyline").evaluate_all("(all) => all.map((e) => e.points.length)")
    assert points == [25, 25]
    page.get_by_label("Question").select_option("jacobian")
    expect(page.locator(".path")).to_have_count(0)


@phone
def test_numbers_are_typed_in_a_grid_on_a_phone(page):
    page.get_by_label("Question").select_option("torques")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    answer = page.get_by_label("Your answer", exact=True)
    for joint, value in (("τ 1", "0"), ("τ 2", "1.5"), ("τ 3", "2,5")):
        page.get_by_label(joint, exact=True).fill(value)
    page.get_by_label("Sign of τ 2").click()
    expect(answer).to_have_value("0, -1.5, 2.5")
    answer.fill("3; 4; 5")
    expect(page.get_by_label("τ 3", exact=True)).to_have_value("5")
    answer.fill("tau_1 = 3")
    page.get_by_label("τ 3", exact=True).wait_for(state="hidden")
    page.get_by_text("Joint values one by one").click()
    expect(page.get_by_label("q 1", exact=True)).to_have_value("0")
    assert page.evaluate(LIST_OVERFLOWING_PARTS) == []
    assert list_serious_findings(page) == []


@both
def test_pasted_text_shows_meaning_of_each_number(page):
    ask(page, f"q = 0.5 0.7 -0.4\nJ =\n{WRONG}")
    verdict(page, "check vz")
    marked = page.locator(".arm-judge .marked")
    marked.locator("pre button").first.wait_for()
    expect(marked.locator("pre .entry")).to_have_count(18)
    wrong = marked.locator("pre .off")
    expect(wrong).to_have_text(["0.3866"], use_inner_text=True)
    wrong.hover()
    marked.get_by_text("0.3866: entry of vz, joint 3, read as 0.3866, wrong").wait_for()
    wrong.focus()
    page.keyboard.press("ArrowLeft")
    marked.get_by_text("0.5925: entry of vz, joint 2, read as 0.5925", exact=True).wait_for()
    expect(marked.locator("pre")).to_have_text(f"q = 0.5 0.7 -0.4 J = {WRONG}")
    assert page.evaluate(LIST_OVERFLOWING_PARTS) == []
    assert list_serious_findings(page) == []


@wide
def test_wrong_entry_is_corrected_in_the_text(page):
    ask(page, WRONG)
    marked = page.locator(".arm-judge .marked")
    marked.locator("pre .off").click()
    page.get_by_label("The number as it should be read").fill("0.2866")
    page.keyboard.press("Enter")
    verdict(page, "is right at q = (0.5, 0.7, -0.4)")
    answer = page.get_by_label("Your answer", exact=True)
    expect(answer).to_have_value(ELBOW)
    marked.get_by_role("button", name="Undo").click()
    expect(answer).to_have_value(WRONG)


@phone
def test_unread_number_is_put_behind_a_hash(page):
    page.get_by_label("Question").select_option("torques")
    page.get_by_label("Arm", exact=True).select_option("UR10E")
    answer = page.get_by_label("Your answer", exact=True)
    torques = "0.5\n1.5\n2.5\n3.5\n4.5\n0.5"
    answer.fill(f"{torques}\n7.67l2")
    verdict(page, "I cannot read")
    marked = page.locator(".arm-judge .marked")
    marked.locator("pre .unread").click()
    page.get_by_role("button", name="This is no entry").click()
    expect(answer).to_have_value(f"{torques}\n# 7.67l2")
    verdict(page, "are not right")


@wide
def test_answer_number_chooses_among_several_answers(page):
    page.get_by_label("Question", exact=True).select_option("torques")
    page.get_by_label("Arm", exact=True).select_option("UR10E")
    answer = page.get_by_label("Your answer", exact=True)
    answer.fill("first\n0.5 1.5 2.5 3.5 4.5 0.5\n\nsecond\n0.6 1.5 2.5 3.5 4.5 0.5")
    verdict(page, "I find several answers that differ")
    page.get_by_role("button", name="My answer is in line 5").click()
    expect(answer).to_have_value(re.compile("\n# 0.5 1.5"))
    verdict(page, "The torques of UR10e are not right")


@wide
def test_wrong_jacobian_and_torques_are_shown_beside_the_right_ones(page):
    ask(page, WRONG)
    verdict(page, "check vz")
    page.get_by_role("link", name="Show it").click()
    explorer = page.locator(".arm-explorer")
    explorer.get_by_text(
        "When joint 3 moves alone, the tip has the velocity (−0.078, −0.043, 0.287); "
        "the typed column says (−0.078, −0.043, 0.387)"
    ).wait_for()
    expect(explorer.locator(".heat .typed")).to_have_text(["typed: 0.387"])
    explorer.get_by_role("button", name="q1").focus()
    explorer.get_by_text("When joint 1 moves alone").wait_for()
    explorer.get_by_role("slider").first.press("ArrowRight")
    expect(explorer.locator(".heat .typed")).to_have_count(0)  # typed for another configuration
    enter(page)
    page.get_by_label("Question", exact=True).select_option("torques")
    page.get_by_role("button", name="Show an example").click()
    page.get_by_role("link", name="Show it").click()
    explorer.get_by_text("−56.32 ✘").wait_for()
    expect(explorer.locator("td.typed")).to_have_count(6)
    assert list_serious_findings(page, ".arm-explorer") == []


def test_shown_mistake_needs_no_webgl_and_no_motion(browser):
    page = browser.new_page(offline=True, reduced_motion="reduce")
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    enter(page)
    ask(page, WRONG)
    page.get_by_role("link", name="Show it").press("Enter")
    explorer = page.locator(".arm-explorer")
    explorer.get_by_text("the typed column says (−0.078, −0.043, 0.387)").wait_for()
    page.go_back()
    page.get_by_label("Question", exact=True).select_option("table")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    page.get_by_label("Your answer", exact=True).fill(SHORT_TABLE)
    page.get_by_role("link", name="Show it").press("Enter")
    explorer.get_by_role("slider", name="From the ghost's table").fill("0.5")
    explorer.get_by_text("its tip is 50.0 mm").wait_for()
    page.close()


SHORT_TABLE = "a (mm) alpha (deg) d (mm) theta\n0 90 500 q1\n400 0 0 q2\n200 0 0 q3"


@wide
def test_printed_form_has_question_answer_verdict_and_marked_numbers(page):
    page.get_by_label("Question", exact=True).select_option("table")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    page.get_by_label("Your answer", exact=True).fill(SHORT_TABLE)
    verdict(page, "a in row 3 is 100 mm too short")
    page.emulate_media(media="print")
    for part in ("Question", "Arm", "Your answer"):
        expect(page.get_by_label(part, exact=True)).to_be_visible()
    expect(page.locator(".verdict")).to_be_visible()
    numbers = page.get_by_label("The text with its numbers marked").locator("button")
    assert [number.is_visible() for number in numbers.all()] == [True] * 12
    expect(page.get_by_role("button", name="Clear")).to_have_count(0)
    page.emulate_media(media="screen")


@both
def test_wrong_table_is_shown_beside_the_right_one(page):
    """A link opens the explorer, where a slider goes from the right table to the typed one."""
    page.get_by_label("Question", exact=True).select_option("table")
    page.get_by_label("Arm", exact=True).select_option("ELBOW")
    show = page.get_by_role("link", name="Show it")
    expect(show).to_have_count(0)
    page.get_by_label("Your answer", exact=True).fill(SHORT_TABLE)
    show.press("Enter")
    explorer = page.locator(".arm-explorer")
    sentence = explorer.get_by_text("Not the same arm as the Elbow arm")
    expect(sentence).to_contain_text("its tip is 100.0 mm and 0.0° away from the ghost’s")
    slider = explorer.get_by_role("slider", name="From the ghost's table to this one")
    length = explorer.get_by_label("Row 3, a", exact=True)
    slider.press("Home")
    expect(length).to_have_value("0.3")
    expect(slider).to_be_visible()
    slider.fill("0.5")
    expect(sentence).to_contain_text("its tip is 50.0 mm")
    expect(slider).to_be_in_viewport()
    expect(explorer.locator(".stage.drawn")).to_be_in_viewport(ratio=0.75)
    expect(page).to_have_url(re.compile("blend=0.5"))
    page.reload()
    expect(sentence).to_contain_text("its tip is 50.0 mm")
    expect(slider).to_have_value("0.5")
    assert list_serious_findings(page, ".arm-explorer") == []
    slider.press("End")
    expect(length).to_have_value("0.2")
    length.fill("0.25")
    expect(slider).to_have_value("1")
    slider.press("Home")
    slider.press("End")
    expect(length).to_have_value("0.25")
