"""Test the explorer: JavaScript against Python, bundles against sources, stubs and traits."""

import hashlib
import json
import math
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from anywidget import AnyWidget

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.checks import compare_tables
from helpers.checks.arms import arm_data
from helpers.explorer import ArmExplorer, ArmFigure, judge
from helpers.explorer.data import arm_from, circle_arm_data
from helpers.explorer.figure import ANY_ARM, ONE_ARM
from helpers.explorer.widget import BUNDLE, widget_module
from helpers.inverse import elbow, stanford, ur
from helpers.kinematics import jacobian, link_frames
from helpers.motion import circle_below, damped, plain_inverse, trace
from helpers.robots import ARMS, ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import gravity_torque, potential_energy, static_torque
from tests.laws import joint_difference
from tests.machines import random_pair
from tests.node import NODE, ask_node, needs_node, needs_packages
from tools.numbering import list_notebooks

ROOT = Path(__file__).parents[1]
SOURCES = ROOT / "page"
SKEW = Arm(
    "skew", (fixed(a=0.1, alpha=0.3), revolute(0.2, 1.1, 0.3, 0.4), prismatic(0.1, -0.7, 0.2, 2.0),
             revolute(0.3, 0.2, -0.1, -1.0), fixed(d=0.1, theta=0.9)),
)  # fmt: skip


SOLVERS = {
    UR10E: ur,
    UR10E_HOMEWORK: ur,
    STANFORD: stanford,
    ELBOW: lambda arm, T, start=None: elbow(arm, T[:3, 3], start),
}
every_arm = pytest.mark.parametrize("arm", [*ARMS, SKEW], ids=lambda arm: arm.name)


def ask(job, **given):
    return ask_node("explorer_numbers.mjs", {"job": job, **given})


def draw_configurations(arm, count=1000):
    """Return random configurations from the whole range of the joints."""
    lower, upper = (np.where(np.isfinite(x), x, s * np.pi) for x, s in zip(arm.limits, (-1, 1),
        strict=True))  # fmt: skip
    return np.random.default_rng(7).uniform(lower, upper, (count, arm.dof))


@needs_node
@every_arm
def test_javascript_kinematics_match_python(arm):
    qs, wrench = draw_configurations(arm), [3.0, -2.0, 5.0, 0.7, -0.4, 0.2]
    answers = ask("numbers", arm=arm_data(arm), qs=qs.tolist(), wrench=wrench)
    J = jacobian(arm, qs)

    def assert_close(key, expected):
        got = np.array([answer[key] for answer in answers])
        np.testing.assert_allclose(got, expected, rtol=0, atol=1e-10)

    assert_close("frames", link_frames(arm, qs))
    assert_close("columns", np.swapaxes(J, -1, -2))
    assert_close("gravity", gravity_torque(arm, qs) if arm.bodies else np.zeros(qs.shape))
    assert_close("push", np.swapaxes(J, -1, -2) @ wrench)
    singular = np.linalg.svd(J, compute_uv=False)
    got = np.array([answer["values"] for answer in answers])[:, : singular.shape[1]]
    np.testing.assert_allclose(got, singular, rtol=0, atol=1e-10)
    if arm.dof == 6:
        assert_close("determinant", np.linalg.det(J))


@needs_node
@pytest.mark.parametrize(
    "file", sorted((ROOT / "tests" / "explorer").glob("*.test.mjs")), ids=lambda file: file.stem
)
def test_javascript_tests_pass(file):
    """States, links, dragging and pasting exist only in JavaScript, and so do their tests."""
    assert NODE, "Node.js is not installed"
    done = subprocess.run(
        [NODE, "--test-reporter=spec", str(file)],
        capture_output=True,
        encoding="utf-8",
        timeout=300,
    )
    assert done.returncode == 0, done.stdout[-6000:] + done.stderr
    assert int(re.search(r"^ℹ pass (\d+)", done.stdout, re.M)[1]) >= 1


ERRATA = (ROOT / "book" / "errata.md").read_text(encoding="utf-8")
LINKED = {
    int(number): [f.replace("&amp;", "&") for f in re.findall(r'explorer\.html(#[^"]*)"', entry)]
    for number, entry in re.findall(r"^### (\d+) ·(.*?)(?=^##)", ERRATA, re.S | re.M)
}


@pytest.fixture(scope="module")
def opened_link():
    """Return the state that each erratum's link opens, by the erratum's number."""
    fragments = {number: links[0] for number, links in LINKED.items() if links}
    arms = [arm_data(arm) for arm in ARMS]
    answers = ask("links", arms=arms, fragments=list(fragments.values()))
    return dict(zip(fragments, answers, strict=True))


def measure_distance(answer):
    return 1000 * math.dist(np.array(answer["pose"])[:3, 3], answer["patch"]["mark"])


@needs_node
def test_all_errata_except_two_link_to_explorer():
    """A picture cannot show slip 5 (a dot too many) or slip 8 (g rounded to 9.8)."""
    assert {number for number, links in LINKED.items() if not links} == {5, 8}
    fragments = [fragment for links in LINKED.values() for fragment in links]
    answers = ask("links", arms=[arm_data(arm) for arm in ARMS], fragments=fragments)
    for fragment, answer in zip(fragments, answers, strict=True):
        assert answer["words"] == "", fragment
        assert {"arm", "q", "view"} <= set(answer["patch"]), fragment


@needs_node
def test_errata_links_place_tip_as_described(opened_link):
    """The distance of the tip from the mark, or an entry of its pose, is computed by hand here."""
    # 582.6 mm is hypot(0.4 cos(1.3323) - 0.3 - 0.3606, 0.5 + 0.4 sin(1.3323) - 0.001 - 0.75).
    assert measure_distance(opened_link[12]) == pytest.approx(582.6, abs=0.1)
    behind, front = (
        np.array(opened_link[13]["patch"]["mark"]),
        np.array(opened_link[13]["pose"])[:3, 3],
    )
    np.testing.assert_allclose(front, behind * (-1, -1, 1), atol=1e-5)
    assert behind[0] < 0 < front[0]
    assert measure_distance(opened_link[20]) == pytest.approx(0.63, abs=0.005)
    above, below = np.array(opened_link[23]["pose"])[2, 3], opened_link[23]["patch"]["mark"][2]
    assert above - 0.5 == pytest.approx(0.5 - below, abs=1e-5)  # shoulder: 0.5 m
    poses = {number: np.array(answer["pose"]) for number, answer in opened_link.items()}
    np.testing.assert_allclose(poses[1][:3, 3], (0, -0.679, 0.649), atol=1e-6)
    assert not opened_link[1]["patch"]["q"], "the arm of the headings has no joint"
    np.testing.assert_allclose(poses[17][:3, 1], (-1, 0, 0), atol=1e-6)
    assert poses[27][0, 3] == pytest.approx(0, abs=1e-6)
    np.testing.assert_allclose(poses[18][:, 0], (1, 0, 0, 0), atol=1e-6)
    np.testing.assert_allclose(poses[26][:3, 3], (0.679, 0, 0.825), atol=1e-6)
    np.testing.assert_allclose(poses[4][3], (0, 0, 0, 1))
    assert np.linalg.norm(poses[4][:3, 3]) > 0.5, "the fourth column is the place"
    centre = poses[11][:3, 3] - (0, 0, 0.1)  # below the start, where the arm draws its circle
    np.testing.assert_allclose(centre, (0, 0.3561, 1.328), atol=1e-4)
    _, phi = opened_link[16]["patch"]["q"][0], math.pi - opened_link[16]["patch"]["q"][1]
    squared = 0.4**2 + 0.3**2 - 2 * 0.4 * 0.3 * math.cos(phi)
    assert np.sum(poses[16][:3, 3] ** 2) == pytest.approx(squared, abs=1e-6)


@needs_node
def test_errata_links_open_described_view(opened_link):
    assert "its tip is 7.8 mm and" in opened_link[2]["table"]
    tips = [ask("numbers", arm=arm, qs=[UR10E_HOMEWORK.home], wrench=[0] * 6)[0]["frames"][-1]
            for arm in (opened_link[9]["patch"]["arm"], arm_data(UR10E_HOMEWORK))]  # fmt: skip
    apart = 1000 * (np.array(tips[0]) - tips[1])[:3, 3]
    assert np.abs(apart[1:]).round(1) == pytest.approx([34.6, 56.8])
    assert opened_link[9]["patch"]["view"] == opened_link[2]["patch"]["view"] == "table"
    for number in (6, 24):
        assert opened_link[number]["patch"]["view"] == "torque"
        assert opened_link[number]["energy"] == pytest.approx(
            potential_energy(PANDA, PANDA.home), abs=1e-9
        )
        assert opened_link[number]["energy"] > 0
        assert len(opened_link[number]["gravity"]) == 7
    kinds = [row["kind"] for row in opened_link[25]["patch"]["arm"]["rows"]]
    assert [k + 1 for k, kind in enumerate(kinds) if kind == "revolute"] == [1, 2, 4, 5, 6, 7]
    assert opened_link[25]["patch"]["view"] == opened_link[3]["patch"]["view"] == "jacobian"
    assert opened_link[3]["patch"]["arm"]["name"] == "Panda (homework)"


@needs_node
def test_errata_links_count_branches_as_described(opened_link):
    """Four for slip 22, infinitely many for 14, whose joint 1 is free; two shoulders, at angles of
    no quarter turn, for 15."""
    answers = {}
    for number in (14, 15, 22):
        patch = opened_link[number]["patch"]
        assert patch["view"] == "branches"
        answers[number] = ask("verdicts", arm=patch["arm"], qs=[patch["q"]])[0]
    assert answers[22]["counted"].startswith("Four solutions")
    assert answers[14]["counted"].startswith("Infinitely many solutions")
    assert "joint 1 is free" in answers[14]["counted"]
    shoulders = {round(branch["q"][0], 3) for branch in answers[15]["ways"]["list"]}
    assert len(answers[15]["ways"]["list"]) == 4
    assert len(shoulders) == 2
    assert all(abs(abs(angle) - math.pi / 2) > 0.1 for angle in shoulders)


@needs_node
def test_errata_links_trace_as_described(opened_link):
    runs = {
        number: ask("runs", arm=patch["arm"], start=patch["q"], runs=patch["runs"])
        for number, patch in ((n, opened_link[n]["patch"]) for n in (10, 19, 21))
    }
    assert runs[10][0]["failedStep"] == 0
    assert runs[10][1]["failedStep"] is None
    off = {
        number: [round(1000 * run["largestError"], 3) for run in runs[number]]
        for number in (19, 21)
    }
    assert off == {19: [0.127, 0.654], 21: [0.127, 1.145]}
    assert math.degrees(runs[19][1]["largestTilt"]) == pytest.approx(12.3, abs=0.05)
    views = {n: opened_link[n]["patch"]["view"] for n in (7, 10, 11, 19, 21)}
    assert views == {7: "torque", 10: "homework", 11: "homework", 19: "homework", 21: "homework"}


@needs_node
@every_arm
def test_reported_rank_matches_numpy(arm):
    """Some configurations are singular: q = 0, and joints at multiples of a quarter turn."""
    rng = np.random.default_rng(11)
    turns = rng.integers(-2, 3, (12, arm.dof)) * np.pi / 2
    qs = np.vstack([np.zeros(arm.dof), turns, draw_configurations(arm, 12)])
    # The rank counts all rows that the arm can move, or only the linear rows if the arm has fewer
    # joints than those rows.
    movable = np.flatnonzero(
        np.abs(jacobian(arm, draw_configurations(arm, 12))).max(axis=(0, 2)) > 1e-12
    )
    rows = movable if len(movable) <= arm.dof else [0, 1, 2]
    ranks = np.linalg.matrix_rank(jacobian(arm, qs)[:, rows], rtol=1e-6)
    for answer, rank in zip(ask("ranks", arm=arm_data(arm), qs=qs.tolist()), ranks, strict=True):
        assert answer["rank"] == rank
        assert answer["said"]["singular"] == (rank < min(len(rows), arm.dof))


@needs_node
@every_arm
@pytest.mark.parametrize("turns", [False, True])
def test_nearly_lost_directions_match_singular_values(arm, turns):
    """Compare with singular values of the tip's velocity, with the tool free to turn or held.

    In half of the configurations the arm is nearly straight from joint 3 on.
    """
    qs = draw_configurations(arm, 60)
    qs[::2, 2:] *= 0.02
    asked = {"arm": arm_data(arm), "qs": qs.tolist(), "turns": turns}
    for J, found in zip(jacobian(arm, qs), ask("fading", **asked), strict=True):
        still = np.eye(arm.dof)
        if turns:
            _, size, rows = np.linalg.svd(J[3:])
            still = rows[(size > 1e-9).sum() :].T
        u, sizes, _ = np.linalg.svd(J[:3] @ still)
        shares = sizes / sizes[0] if sizes.size == 3 else np.ones(3)
        lost = u[:, shares < 0.1]
        assert [each["share"] for each in found] == pytest.approx(shares[shares < 0.1], abs=1e-9)
        directions = np.reshape([each["direction"] for each in found], (-1, 3)).T
        np.testing.assert_allclose(directions @ directions.T, lost @ lost.T, atol=1e-7)


@needs_node
@pytest.mark.parametrize(
    ("arm", "q", "isolated", "free"),
    [
        (STANFORD, [0.3, 0.6, 0.5, 0.2, 0, -0.4], 4, [3, 5]),
        (UR10E, [0.3, -1, 1.2, 0.2, 0, 0.4], 4, [1, 2, 3, 5]),
        (ELBOW, [0.2, math.pi / 2, 0], 0, [0]),
        (ELBOW, [0.2, 1.9, -0.9], None, []),
        (UR10E, UR10E.home, 1, []),
    ],
    ids=["Stanford", "UR10e", "elbow on axis 1", "elbow", "stretched"],
)
def test_infinite_branch_families_are_not_counted(arm, q, isolated, free):
    """In closed form, a solution is in a family if it changes with the value of the free joint."""
    answer = ask("verdicts", arm=arm_data(arm), qs=[list(q)])[0]
    families, branches = answer["ways"]["families"], answer["ways"]["list"]
    assert all(family["moving"] == free for family in families)
    assert bool(families) == bool(free)
    assert answer["counted"].startswith("Infinitely many solutions") == bool(free)
    if isolated is not None:
        assert len(branches) - len(families) == isolated
    target = link_frames(arm, q)[-1]
    here, there = (SOLVERS[arm](arm, target, np.full(arm.dof, value)) for value in (0.2, 0.5))
    moves = (joint_difference(arm, here.q, there.q) > 1e-3)[here.valid]
    assert moves.any() == bool(free), "what the closed form says"


@needs_node
def test_table_message_agrees_with_compare_tables():
    """The pairs are those of tests.machines; test_tables.py compares them with a numeric search."""
    pairs = [random_pair(seed) for seed in range(300)]
    both = [[arm_data(one) for one in pair] for pair in pairs]
    is_same = [message.startswith("The same arm") for message in ask("tables", pairs=both)]
    assert is_same == [compare_tables(*pair).figures.get("same machine", False) for pair in pairs]


RUNS = [
    ({}, {"rates": plain_inverse()}),
    ({"steps": 100}, {"rates": plain_inverse()}),
    ({"steps": 100, "method": "rk4"}, {"rates": plain_inverse(), "method": "rk4"}),
    (
        {"steps": 100, "rates": "damped", "damping": 0.05, "gain": 3.0},
        {"rates": damped(0.05), "gain": 3.0},
    ),
]


@needs_node
@pytest.mark.parametrize(("asked", "expected"), RUNS, ids=lambda value: "")
def test_homework_trajectory_matches_python(asked, expected):
    run = {"steps": 1000, "locked": 2, **asked}
    answer = ask("runs", arm=arm_data(PANDA_HOMEWORK), start=PANDA_HOMEWORK.home, runs=[run])[0]
    locked = PANDA_HOMEWORK.lock(3)
    path = circle_below(locked, locked.home, 0.1, "zy", 5, run["steps"])
    traced = trace(locked, locked.home, path, **expected)
    ends = np.delete(answer["path"][-1], 2)
    np.testing.assert_allclose(ends, traced.q[-1], atol=1e-9)
    assert answer["largestError"] == pytest.approx(traced.report.position_error, rel=1e-6)


@needs_node
def test_ur10e_circle_fails_jumps_or_is_damped():
    wall = {"normal": "y", "seconds": 20}
    pseudo, damping = {**wall, "rates": "pseudo"}, {**wall, "rates": "damped"}
    runs = [wall, pseudo, {**pseudo, "cutoff": 0.01}, damping, {**damping, "gain": 5}]
    broken, *others = ask("runs", arm=arm_data(UR10E_HOMEWORK), start=[0] * 6, runs=runs)
    assert broken["failedStep"] == 0
    assert others[0]["fastestRate"] == pytest.approx(6.57, abs=0.005)
    largest = [round(1000 * run["largestError"], 1) for run in others]
    assert largest == [3.5, 46.0, 11.0, 2.6]


@needs_node
def test_torques_along_path_match_python():
    path, push = [list(PANDA.home), [0.1, -0.4, 0.3, 1.6, 0.2, 1.9, 0.4]], [-5, 0, 0, 0, 0, 0]
    found = ask("torques", arm=arm_data(PANDA), path=path, wrench=push)
    np.testing.assert_allclose(found, static_torque(PANDA, path, push), atol=1e-9)


@needs_node
def test_failed_trace_blames_arm_only_if_singular():
    for arm, run, stuck in (
        (PANDA_HOMEWORK, {"mistake": "z_i", "locked": 2}, False),
        (UR10E_HOMEWORK, {"normal": "y"}, True),
    ):
        (found,) = ask("runs", arm=arm_data(arm), start=arm.home, runs=[run])
        assert (found["failedStep"], found["isSingular"]) == (0, stuck)
        kept = arm.lock(3) if arm is PANDA_HOMEWORK else arm
        assert (np.linalg.matrix_rank(jacobian(kept, kept.home)) < 6) == stuck


@needs_node
@every_arm
def test_copied_table_reads_back_as_same_arm(arm):
    """Python reads the copied table without a setting."""
    q = draw_configurations(arm, 1)[0]
    back = Arm.from_table(ask("copied", arm=arm_data(arm)))
    assert [row.joint.kind for row in back.rows] == [row.joint.kind for row in arm.rows]
    np.testing.assert_allclose(link_frames(back, q), link_frames(arm, q), atol=1e-8)


@needs_node
@pytest.mark.parametrize("arm", [PANDA_HOMEWORK.lock(3), PANDA], ids=lambda arm: str(arm.dof))
def test_traced_circle_matches_formula(arm):
    traced = ask("circle", arm=arm_data(arm), q=arm.home, normal="x", radius=0.1)
    T = link_frames(arm, traced["path"])[:, -1]
    start = T[0, :3, 3]
    angle = 2 * np.pi * np.arange(181) / 180
    circle = start + 0.1 * np.stack([0 * angle, np.sin(angle), np.cos(angle) - 1], axis=-1)
    np.testing.assert_allclose(T[:, :3, 3], circle, atol=1e-8)
    np.testing.assert_allclose(T[:, :3, :3], np.broadcast_to(T[0, :3, :3], (181, 3, 3)), atol=1e-8)
    if arm.dof == 6:  # with joint 3 locked, joints 5 and 7 make a full turn
        turned = np.array(traced["path"][-1]) - traced["path"][0]
        np.testing.assert_allclose(np.abs(turned[[3, 5]]), 2 * np.pi, atol=1e-6)


@needs_node
def test_traced_circle_stops_at_workspace_boundary():
    """The trace must stop where the path is farther than a_2 + a_3 from the shoulder."""
    traced = ask("circle", arm=arm_data(ELBOW), q=ELBOW.home, normal="x", radius=0.35)
    far = np.linalg.norm(np.array(traced["wantedPath"]) - (0, 0, 0.5), axis=1)
    end = len(traced["path"])
    assert far[:end].max() < 0.7 + 1e-3 < far[end]
    assert np.abs(np.diff(traced["path"], axis=0)).max() < 0.2


@needs_node
@pytest.mark.parametrize("arm", SOLVERS, ids=lambda arm: arm.name)
def test_branches_match_closed_forms(arm):
    for q in draw_configurations(arm, 10):
        known = SOLVERS[arm](arm, link_frames(arm, q)[-1])
        known = np.array(known.q[known.valid])
        found = np.array(ask("ways", arm=arm_data(arm), q=q.tolist()))
        gaps = joint_difference(arm, known[:, None], found[None])
        assert gaps.shape[0] == gaps.shape[1]
        assert gaps.min(axis=0).max() < 1e-7
        assert gaps.min(axis=1).max() < 1e-7


@needs_packages
def test_bundles_are_up_to_date(tmp_path):
    subprocess.run(
        [NODE, "page/build.js", str(tmp_path)], cwd=ROOT, check=True, capture_output=True
    )
    made = {script.relative_to(tmp_path) for script in tmp_path.rglob("*.js")}
    stored = {*BUNDLE.parent.glob("*.js"), ROOT / "helpers" / "checks" / "judge.js"}
    assert {ROOT / "helpers" / name for name in made} == stored
    for name in made:
        same = (ROOT / "helpers" / name).read_bytes() == (tmp_path / name).read_bytes()
        assert same, f"{name}: run `make bundles`"


@every_arm
def test_arm_survives_round_trip_to_browser(arm):
    back = arm_from(arm.name, json.loads(json.dumps(arm_data(arm)))["rows"])
    qs = draw_configurations(arm, 5)
    np.testing.assert_array_equal(link_frames(back, qs), link_frames(arm, qs))
    np.testing.assert_array_equal(back.limits, arm.limits)
    np.testing.assert_array_equal(back.effort_limits, arm.effort_limits)
    assert [body.mass for body in back.bodies] == [arm.number(body.mass) for body in arm.bodies]
    if arm.bodies:
        np.testing.assert_array_equal(gravity_torque(back, qs), gravity_torque(arm, qs))


@pytest.fixture
def explorer():
    return ArmExplorer(PANDA, arms=ARMS)


def test_figure_shows_widget_and_stub():
    figure = ArmFigure("ellipsoid", q=UR10E_HOMEWORK.home, joints=[3, 5])
    shown = figure._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in shown
    assert shown["text/plain"] == "<ArmFigure ellipsoid of the UR10e (homework)>"
    kind, options = re.search(
        r'data-figure="(\w+)"><p>.*</p><script type="application/json">(.*)</script>',
        shown["text/html"],
    ).groups()
    assert kind == "ellipsoid"
    options = json.loads(options)
    assert options == {"joints": [3, 5], "arm": arm_data(UR10E_HOMEWORK), "q": [0.0] * 6}
    assert ArmFigure("swing")._spec == {"figure": "swing", "joints": [], "arm": arm_data(PANDA)}
    kinds = (SOURCES / "src" / "more" / "kinds.js").read_text(encoding="utf-8")
    known = re.search(r"^export const FIGURES = \{([^}]*)\}", kinds, re.M)[1]
    assert re.findall(r"^  (\w+):", known, re.M) == sorted(ANY_ARM | ONE_ARM)


def test_stored_notebooks_hold_stubs_not_widgets():
    stubs = 0
    for path in list_notebooks():
        notebook = json.loads(path.read_text(encoding="utf-8"))
        assert "widgets" not in notebook["metadata"]
        for cell in notebook["cells"]:
            for output in cell.get("outputs", []):
                data = output.get("data", {})
                assert "application/vnd.jupyter.widget-view+json" not in data, "run `make refresh`"
                stubs += "arm-explorer" in "".join(data.get("text/html", ""))
    assert stubs


def test_arm_name_is_escaped_in_stub():
    name = '</script><img src=x onerror="alert(1)">'
    html = ArmExplorer(Arm(name, (revolute(a=1),)))._repr_mimebundle_()["text/html"]
    assert html.count("</script>") == 1
    assert "<img" not in html[: html.index("<script")]


def test_explorer_accepts_closed_form_solutions():
    q = [0.4, -1.2, 1.3, -1.2, -1.2, 0.3]
    found = ur(UR10E, link_frames(UR10E, q)[-1])
    explorer = ArmExplorer(UR10E, q, branches=found)
    assert [branch["label"] for branch in explorer.branches] == list(found.branches)
    np.testing.assert_allclose([branch["q"] for branch in explorer.branches], found.q, atol=1e-5)
    beyond = ArmExplorer(ELBOW, branches=elbow(ELBOW, [3, 3, 3]))
    assert beyond.branches == []
    with pytest.raises(ArmError, match="expected one"):
        explorer.branches = ur(UR10E, link_frames(UR10E, [q, q])[:, -1])


def test_explorer_spec_holds_chosen_options():
    """The expected keys are those that page/src reads."""
    all_views = ["table", "pose", "jacobian", "homework", "trace", "torque", "branches"]
    panda = arm_data(PANDA)
    circle = {"normal": "x", "seconds": 5, "rates": "inverse", "locked": 2}
    assert ArmExplorer(PANDA)._spec == {
        "arms": [{**panda, "circle": circle}], "views": all_views, "unit": "deg",
        "reference": None, "link": False
    }  # fmt: skip
    chosen = ArmExplorer(
        PANDA, views=["pose"], reference=ELBOW, arms=[ELBOW], unit="rad", link=True
    )
    assert chosen._spec == {
        "arms": [panda, arm_data(ELBOW)], "views": ["pose"], "unit": "rad",
        "reference": arm_data(ELBOW), "link": True
    }  # fmt: skip


def test_circle_is_exported_for_the_homeworks_arms():
    ur10e = {"normal": "y", "seconds": 20, "rates": "pseudo"}
    penless = UR10E.with_values(l_pen=0)
    renamed = replace(UR10E, name="arm of a reader")
    arms = (UR10E, penless, renamed)
    assert [circle_arm_data(arm).get("circle") for arm in arms] == [ur10e] * 3
    namesake = Arm("UR10e", UR10E.rows, UR10E.values)
    arms = (ELBOW, PANDA.lock(3), namesake)
    assert [circle_arm_data(arm).get("circle") for arm in arms] == [None] * 3


def test_circle_of_missing_joint_is_rejected():
    with pytest.raises(ArmError, match="the circle locks joint 3; expected one of the 2 joints"):
        Arm("two joints", UR10E.rows[:2], UR10E.values, circle=PANDA.circle)


def test_two_arms_of_one_name_are_rejected():
    with pytest.raises(ArmError, match="two different arms are called 'Panda'"):
        ArmExplorer(PANDA, arms=[PANDA.lock(3)])


def test_changing_arm_resets_configuration_and_results(explorer):
    explorer.trace, explorer.branches = [[0] * 7, [1] * 7], [[0] * 7]
    explorer.arm_name = "Elbow arm"
    assert (explorer.q, explorer.trace, explorer.branches) == (ELBOW.home, None, None)
    rows = arm_data(STANFORD)["rows"]
    explorer.rows = rows
    assert (explorer.arm.name, explorer.q) == ("Your arm", (0.0,) * 6)
    explorer.arm_name = "Panda"
    assert (explorer.rows, explorer.arm, explorer.q) == ([], PANDA, PANDA.home)
    with pytest.raises(ArmError, match=r"^arm_name is 'Puma'; expected one of Panda, "):
        explorer.arm_name = "Puma"
    state = {"arm_name": "Elbow arm", "q": [0.1, 0.2, 0.3], "trace": [[0] * 3, [1] * 3]}
    explorer.set_state(state)  # the page sends the arm with its configuration and trace
    assert (explorer.q, explorer.trace) == ((0.1, 0.2, 0.3), state["trace"])
    explorer.arm_name = "UR10e"
    assert (explorer.q, explorer.trace) == (UR10E.home, None)


@pytest.mark.parametrize(
    ("count", "kept"),
    [(2, [0, 1]), (181, range(181)), (182, [*range(91), *range(92, 182)]), (361, range(0, 361, 2))],
)
def test_long_trace_is_thinned_to_181_points(count, kept):
    explorer = ArmExplorer(ELBOW, trace=np.arange(count)[:, None] + [0, 0.000001, 0.12345678])
    assert explorer.trace == [[k, k, k + 0.12346] for k in kept]
    words = r"Elbow arm: the trace has shape \(1, 3\); expected \(N, 3\), N ≥ 2"
    with pytest.raises(ArmError, match=words):
        explorer.trace = [[0, 0, 0]]


def test_branches_are_rounded():
    q = [0.123456, 0, -0.0000001]
    rounded = [0.12346, 0, 0]
    explorer = ArmExplorer(ELBOW, branches=np.array([q]))
    assert str(explorer.branches) == str([{"q": [0.12346, 0.0, 0.0]}])
    explorer.branches = [{"label": "up", "q": q}]
    assert explorer.branches == [{"label": "up", "q": rounded}]
    words = r"branches are 3; expected a closed form's answer, or joint vectors \(k, dof\)"
    with pytest.raises(ArmError, match=words):
        explorer.branches = 3
    with pytest.raises(ArmError, match=r"the branches are those of \(2,\) poses; expected one"):
        explorer.branches = elbow(ELBOW, [[0.3, 0.2, 0.6]] * 2)


def test_arm_with_some_masses_missing_has_no_bodies():
    rows = arm_data(PANDA)["rows"]
    assert len(arm_from("whole", rows).bodies) == 7
    del rows[2]["body"]
    assert arm_from("part", rows).bodies == ()


def test_placeholder_describes_arm_and_configuration():
    arm = Arm("Ä", (revolute(a=1), revolute(a=0.5)))
    html = [ArmExplorer(arm, [0.12345, -1e-9], link=link)._stub for link in (True, False)]
    assert html[0].startswith('<div class="arm-explorer whole"><p>')
    assert html[1].startswith('<div class="arm-explorer"><p>')
    for text in html:
        assert "<p>Ä at q_1 = 0.123, q_2 = 0. Run the cell to move it.</p><script" in text
        assert '"arms":[{"name":"Ä","home":[0.0,0.0],' in text
        assert '"q":[0.12345,-1e-09],"wrench":[0.0,0.0,0.0,0.0,0.0,0.0],"trace":null' in text


def test_figure_placeholder_is_valid_html():
    arm = Arm('Ä & "B"', (revolute(a=1),))
    html = ArmFigure("columns", arm)._stub
    start, data = html.removesuffix("</script></div>").split('<script type="application/json">')
    place = ElementTree.fromstring(f"{start}</div>")
    assert place.attrib == {"class": "arm-explorer", "data-figure": "columns"}
    assert [(p.tag, p.text) for p in place] == [
        ("p", 'A live figure of the Ä & "B". Run the cell to move it.')
    ]
    assert json.loads(data) == {"joints": [], "arm": arm_data(arm)}
    assert ": " not in data


def test_live_figure_shows_a_still_picture_first(monkeypatch):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda data, raw: shown.append(data))
    for live in (ArmFigure("ways"), ArmExplorer(ELBOW)):
        live._ipython_display_()
    for still, stub in (shown[:2], shown[2:]):
        assert ElementTree.fromstring(still["image/svg+xml"]).tag.endswith("svg")
        assert stub["text/html"].startswith('<div class="arm-explorer')


def test_still_picture_shows_the_configuration_of_the_figure():
    pictures = {ArmFigure("matrix", q=q)._still() for q in ([0, 0, 0], [0, 0, 1], [0, 0, 1])}
    assert len(pictures) == 2


def test_widgets_share_script_keyed_by_its_hash():
    script = BUNDLE.read_text(encoding="utf-8")
    key = f"arm-explorer {hashlib.sha256(script.encode()).hexdigest()[:12]}"
    for code, widget in [
        (widget_module(), "widget"),
        (widget_module("figureWidget"), "figureWidget"),
    ]:
        first, rest = code.split("\n", 1)
        assert first == f"const key = Symbol.for('{key}');"
        assert rest.startswith(f"globalThis[key] ??= (() => {{ {script[:500]}")
        ends = f"{script[-500:]}\nreturn ArmExplorer; }})();\n"
        assert rest.endswith(f"{ends}export default () => globalThis[key].{widget}();\n")


@pytest.mark.parametrize("live", [({"live": 1}, {}), {"live": 1}, None])
def test_display_adds_stub_to_widget_bundle(monkeypatch, live):
    """As a bundle with its metadata, a bundle, or nothing where no front end can show it."""
    for widget in (ArmExplorer(ELBOW), ArmFigure("matrix")):
        monkeypatch.setattr(AnyWidget, "_repr_mimebundle_", lambda self, **_: live)
        shown = widget._repr_mimebundle_()
        assert shown.pop("text/html") == widget._stub
        assert shown.pop("text/plain") == repr(widget)
        assert shown == ({"live": 1} if live else {})


def judges_data(given=None):
    start, end = judge.form_html(given)
    script, tail = end[: end.index("</script>")], end[end.index("</script>") :]
    assert tail == "</script></div>"
    assert script.startswith('<script type="application/json">{"arms":[')
    return start, json.loads(script.split(">", 1)[1])


def test_placeholder_of_the_form_lists_arms_and_examples():
    start, data = judges_data()
    assert start == '<div class="arm-judge">'
    assert set(data) == {"arms", "examples"}
    assert [example["ask"] for example in data["examples"]] == [
        "jacobian", "torques", "table", "branches", "pose", "trace"
    ]  # fmt: skip
    arms = [PANDA.lock(3), PANDA_HOMEWORK.lock(3), *ARMS]
    for arm, entry in zip(arms, data["arms"], strict=True):
        assert entry["rows"] == arm_data(arm)["rows"]
        assert entry["values"] == [[name, value] for name, value in arm.values.items()]
        assert eval(entry["key"], vars(judge.robots)) == arm
        locked = "lock" in entry["key"]
        name = arm.name if not locked else "Panda" if arm is arms[0] else "Panda (homework)"
        assert entry["title"] == (f"{arm.name}, joint 3 locked" if locked else name)
        assert entry["explorer"] == arm.name
        assert entry.get("locked") == (3 if locked else None)


def test_placeholder_of_a_chapter_form_has_one_question():
    start, data = judges_data({"ask": "table", "arm": "UR10E, PANDA", "q": "</script>"})
    assert start == '<div class="arm-judge small">'
    assert [arm["title"] for arm in data.pop("arms")] == ["UR10e", "Panda"]
    assert data == {"given": {"ask": "table", "q": "</script>"}}
    _, data = judges_data({"ask": "table", "table": "0 0 1 q1"})
    assert data == {"arms": [], "given": {"ask": "table", "table": "0 0 1 q1", "arm": "own"}}
    for call in ("NOBODY", "ARMS", "NOBODY.lock(3)"):
        words = f"no arm is called {call!r}; expected one of {', '.join(judge.CALLS)}"
        with pytest.raises(ArmError, match=re.escape(words)):
            judge.form_html({"arm": call})


def test_judge_trace_example_is_the_reversed_circle():
    asked = judge.trace_example()
    q = np.array([[float(x) for x in row.split()] for row in asked.pop("answer").split("\n")])
    assert asked == {"ask": "trace", "arm": "UR10E_HOMEWORK", "q": "0.3, -0.6, 1.4, -0.8, 0.9, 0.2"}
    T = link_frames(UR10E_HOMEWORK, q)[:, -1]
    angle = np.arange(25)[:, None] * np.pi / 12
    circle = np.sin(angle) * [0, -0.1, 0] + (np.cos(angle) - 1) * [0, 0, 0.1]
    np.testing.assert_allclose(T[:, :3, 3] - T[0, :3, 3], circle, atol=3e-4)
    np.testing.assert_allclose(T[:, :3, :3], [T[0, :3, :3]] * 25, atol=3e-4)
