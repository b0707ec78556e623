"""Figures: they draw what the table says, on the axes they are given, the same way every time.

Where their names and arrows stand is held by the chapters' stored figures, which nbval compares.
"""

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from operator import itemgetter

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

from helpers.arm import Joint
from helpers.kinematics import link_frames, skeleton
from helpers.motion import circle, trace
from helpers.plotting import (
    arm_2d,
    arm_drawing,
    joints,
    law_of_cosines,
    lengths,
    moving_picture,
    path_2d,
    regions,
    shoulder_triangles,
    style,
    torque_shares,
    ur_triangle,
)
from helpers.plotting.drawing import seen
from helpers.plotting.style import RED, STYLE, svg
from helpers.robots import ELBOW, PANDA_HOMEWORK, STANFORD, UR10E_HOMEWORK
from tests.laws import ALL_ARMS, ids, joint_vectors

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=ids)


@pytest.fixture(autouse=True)
def _no_window():
    with mpl.rc_context({**STYLE, "backend": "agg"}):
        yield
        plt.close("all")


@every_arm
def test_the_drawn_line_goes_through_every_origin_by_the_tables_steps(arm):
    q = joint_vectors(arm, ())
    T = link_frames(arm, q)
    points = skeleton(arm, T)
    np.testing.assert_allclose(points[::2], T[:, :3, 3], atol=1e-14)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    np.testing.assert_allclose(steps[1::2], np.abs([row.a for row in arm.numeric]), atol=1e-12)
    fixed_d = [k for k, row in enumerate(arm.numeric) if row.kind != "prismatic"]
    np.testing.assert_allclose(
        steps[::2][fixed_d], np.abs([arm.numeric[k].d for k in fixed_d]), atol=1e-12
    )


def test_a_stored_figure_is_short_and_the_same_picture(monkeypatch):
    def once():
        figure, (left, right) = plt.subplots(1, 2)
        left.plot([0, 1, 2], [-1e-9, 1, 3e5], "o", label="$q_1$")
        left.legend()
        right.imshow([[0, 1], [2, 3]])
        return svg(figure)

    short = once()
    for name, nothing in ("_lean", str), ("_with_own_ids", str), ("_to_hundredths", itemgetter(0)):
        monkeypatch.setattr(style, name, nothing)
    long = once()
    assert "\n" not in short
    assert len(short) < 0.85 * len(long)
    (words, numbers), (wanted, exact) = drawn(short), drawn(long)
    assert words == wanted
    assert numbers == pytest.approx(exact, abs=0.005001)
    assert re.findall('<g id="(.*?)"', short) == ["figure_1", "axes_1", "axes_2"]


def drawn(text):
    """What an SVG draws: its elements, their commands and colours; and all their numbers."""
    said = []
    for element in ET.fromstring(text).iterfind(".//{http://www.w3.org/2000/svg}*"):
        if not element.tag.endswith("metadata"):
            said.append(element.tag[28:])
            said += sorted(f"{name[-4:]} {v}" for name, v in element.items() if name != "id")
    made = r"(?s)(?<=href #)(?!DejaVu).*|(?<=url\(#)[\w-]+|(?<=base64,).*"
    said = [re.sub(made, "", one) for one in said]
    number = r"(?<![#\da-z.-])-?\d+(?:\.\d+)?"
    numbers = [float(one) for one in re.findall(number, " ".join(said))]
    return re.sub(r"\s|" + number, "", " ".join(said)), numbers


# Flat figures, and what is drawn from numbers


def points(line):
    return np.transpose(line.get_data() if not hasattr(line, "get_data_3d") else line.get_data_3d())


def through(ax, wanted):
    """Whether one of the lines has all these points among its corners."""
    gaps = (points(line)[:, None] - wanted for line in ax.lines)
    return any((np.linalg.norm(gap, axis=2).min(axis=0) < 1e-9).all() for gap in gaps)


def run_of(steps=8):
    arm = PANDA_HOMEWORK.lock(3)
    q_0 = [0.1, 0.2, 1.4, 0.3, 1.6, 0.2]
    path = circle(link_frames(arm, q_0)[-1, :3, 3] - [0, 0, 0.05], 0.05, "zy", 5.0, steps)
    return trace(arm, q_0, path, method="exact")


@pytest.mark.parametrize(("plane", "columns"), [("xz", [0, 2]), ("yx", [1, 0])])
def test_a_flat_arm_is_the_arm_in_space_seen_from_the_side(plane, columns):
    _, ax = plt.subplots()
    arm_2d(ax, ELBOW, [0.3, 0.4, -0.9], plane)
    T = link_frames(ELBOW, [0.3, 0.4, -0.9])
    assert through(ax, T[:, columns, 3])
    assert ax.get_xlabel() == f"${plane[0]}$ (m)"


def test_regions_are_told_apart_by_more_than_colour():
    _, ax = plt.subplots()
    regions(ax, [0, 1, 2], [0, 1, 2], np.eye(3), {0: "no", 1: "yes"}, colours=("#000", "#fff"))
    key = ax.get_legend()
    assert [text.get_text() for text in key.get_texts()] == ["no", "yes"]
    assert len({patch.get_hatch() for patch in key.get_patches()}) == 2
    for spot in np.random.default_rng(0).uniform(-0.5, 2.5, (200, 2)):  # no gap between them
        drawn = [patch.get_path().contains_point(spot) for patch in ax.patches]
        one, other = np.rint(spot)
        assert drawn == [one != other, one == other]


def test_both_shoulders_have_right_triangles_to_the_point():
    _, ax = plt.subplots()
    shoulder_triangles(ax, (0.3, 0.2), 0.1, ("left", "right"), ("d", "r"))
    assert ax.patches[0].get_radius() == 0.1
    assert [text.get_text() for text in ax.texts] == ["d", "r", "left", "d", "r", "right"]
    ends = [line.get_xydata() for line in ax.lines if len(line.get_xydata()) == 3]
    turns = [0.3 * foot[1] - 0.2 * foot[0] for _, foot, _ in ends]
    assert turns[0] > 0 > turns[1], "left stands counter-clockwise of the point"
    for axis, foot, point in ends:
        np.testing.assert_allclose(axis, [0, 0])
        np.testing.assert_allclose(point, [0.3, 0.2])
        np.testing.assert_allclose(np.linalg.norm(foot), 0.1)
        np.testing.assert_allclose((point - foot) @ foot, 0, atol=1e-15)


def test_the_ur_s_triangle_is_drawn_to_its_lengths():
    q = [0.4, 1.2, 1.6, 1.0, 0.9, 0.3]
    _, ax = plt.subplots()
    ur_triangle(ax, UR10E_HOMEWORK, q)
    links = next(line.get_xydata() for line in ax.lines if len(line.get_xydata()) == 4)
    steps = np.linalg.norm(np.diff(links, axis=0), axis=1)
    np.testing.assert_allclose(steps, [0.6127, 0.5716, 0.1157], atol=1e-12)
    np.testing.assert_allclose(links[0], [0, 0.128], atol=1e-12)
    lean, bend = np.degrees(q[1:3])
    arcs = [(patch.theta1, patch.theta2) for patch in ax.patches]
    np.testing.assert_allclose(arcs, [(90 - lean, 90), (90 - lean, 90 - lean + bend)], atol=1e-9)


def test_the_triangle_has_the_arms_angles():
    _, ax = plt.subplots()
    law_of_cosines(ax, ELBOW, [0.7, 0.8, -1.1])
    x, y, z = link_frames(ELBOW, [0.7, 0.8, -1.1])[-1, :3, 3]
    bearing = np.degrees(np.arctan2(z - 0.5, np.hypot(x, y)))
    lift, bend = np.degrees([0.8, 1.1])
    arcs = sorted((patch.theta1, patch.theta2) for patch in ax.patches)
    wanted = [(0, lift), (bearing, lift), (lift - bend, lift), (lift + 180, lift + 360 - bend)]
    np.testing.assert_allclose(arcs, sorted(wanted))


def test_a_traced_path_is_drawn_beside_the_wanted_one():
    run = run_of()
    _, ax = plt.subplots()
    path_2d(ax, run)
    run = replace(run, poses=run.poses + 0.01)
    path_2d(ax, run)
    assert through(ax, run.path.positions[:, 1:])
    assert through(ax, run.poses[:, 1:3, 3])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$y$ (m)", "$z$ (m)")


def test_joints_beyond_their_range_are_red_and_ranges_are_shaded():
    run = run_of()
    lower, upper = run.arm.limits
    outside = run.q.copy()
    outside[3, 0] = upper[0] + 0.1
    _, grid = plt.subplots(2, 3)
    joints(grid, replace(run, q=outside))
    (red,) = (line for line in grid[0, 0].lines if line.get_color() == RED)
    np.testing.assert_array_equal(np.flatnonzero(np.isfinite(red.get_ydata())), [3])
    (band,) = grid[0, 0].patches
    np.testing.assert_allclose(
        [band.get_y(), band.get_y() + band.get_height()], np.degrees([lower[0], upper[0]])
    )
    assert grid[0, 2].get_title() == "joint 4 (°)"
    assert through(grid[0, 1], np.column_stack([run.t, np.degrees(run.q[:, 1])]))
    assert grid[1, 0].get_xlabel() == "$t$ (s)"
    free = replace(run, arm=_without_limits(run.arm))
    _, other = plt.subplots(2, 3)
    joints(other, free)
    assert not other[0, 0].patches


def _without_limits(arm):
    return replace(arm, rows=[replace(row, joint=Joint(row.joint.kind)) for row in arm.rows])


def test_the_moving_picture_holds_every_pose_and_respects_the_wish_for_less_motion():
    picture = ET.fromstring(moving_picture(run_of(), ("yz", "xz"), frames=4))
    space = {"s": "http://www.w3.org/2000/svg"}
    moves = picture.findall(".//s:animate[@attributeName='points']", space)
    assert [len(move.get("values").split(";")) for move in moves] == [5, 5]
    assert {move.get("dur") for move in moves} == {"5s"}
    assert "prefers-reduced-motion" in picture.find("s:style", space).text
    stills = picture.findall(".//s:g[@class='still']/s:polyline[1]", space)
    first = [move.get("values").split(";")[0] for move in moves]
    assert [still.get("points") for still in stills] == first


def test_the_moving_picture_draws_only_while_the_tip_moves():
    """Half the time at rest, then half the time on a straight line: the ink comes in the second
    half, evenly."""
    run = run_of()
    times = np.array([0.0, 5.0, 6.25, 7.5, 8.75, 10.0])
    poses = np.tile(run.poses[0], (6, 1, 1))
    poses[:, 1, 3] = [0, 0, 0.1, 0.2, 0.3, 0.4]
    paused = replace(
        run,
        path=replace(run.path, times=times),
        q=run.q[[0] * 6],
        q_dot=run.q[[0] * 6],
        poses=poses,
    )
    picture = ET.fromstring(moving_picture(paused, ("yz", "xz"), frames=8))
    ink, _ = picture.findall(".//{*}animate[@attributeName='stroke-dashoffset']")
    rest = np.array(ink.get("values").split(";"), dtype=float)
    np.testing.assert_allclose(rest / rest[0], [1, 1, 1, 1, 1, 0.75, 0.5, 0.25, 0], atol=1e-3)
    assert ink.get("dur") == "10s"


def test_shares_of_the_limits_run_from_the_least_to_the_most_torque():
    _, ax = plt.subplots()
    tau = np.array([[-8.7, 0, 0, 0, 0, 0, 0], [17.4, 43.5, 0, 0, 6, 12, 0], [0, 0, 0, 0, 0, 0, -6]])
    torque_shares(ax, PANDA_HOMEWORK, {"one": tau, "half": tau / 2})
    bars = np.array(
        [[(bar.get_y(), bar.get_y() + bar.get_height()) for bar in run] for run in ax.containers]
    )
    wanted = np.array([(-10, 20), (0, 50), (0, 2), (0, 2), (0, 50), (0, 100), (-50, 0)])
    np.testing.assert_allclose(bars[0], wanted, atol=1e-12)
    np.testing.assert_allclose(bars[1, [0, 6]], [(-5, 10), (-25, 0)], atol=1e-12)
    assert {line.get_ydata()[0] for line in ax.lines} == {-100, 100}
    assert [words.get_text() for words in ax.get_legend().get_texts()] == ["one", "half"]
    boundless = _without_limits(PANDA_HOMEWORK)
    torque_shares(ax, boundless, {"none": tau})
    assert {bar.get_height() for bar in ax.containers[2]} == {2}


# The drawing board


def texts(ax):
    return [text.get_text() for text in ax.texts if text.get_text()]


@pytest.mark.parametrize("view", ["xz", "yz", "xy", "zy", (30, 18), (-60, 90), (200, -40)])
def test_a_view_is_a_rotation(view):
    right, up, towards = seen(np.eye(3), view).T
    np.testing.assert_allclose(np.stack([right, up, towards]) @ seen(np.eye(3), view), np.eye(3),
                               atol=1e-15)  # fmt: skip
    np.testing.assert_allclose(np.cross(right, up), towards, atol=1e-15)


def test_a_view_looks_from_where_it_says():
    """From an azimuth of 0 one sees y to the right, from 90 degrees -x; high up is up."""
    np.testing.assert_allclose(seen([0, 1, 0], (0, 20))[:2], [1, 0], atol=1e-15)
    np.testing.assert_allclose(seen([1, 0, 0], (90, 20))[0], -1, atol=1e-15)
    assert seen([0, 0, 1], (37, 20))[1] > 0
    assert seen([1, 0, 0], (0, 20))[2] > 0
    np.testing.assert_allclose(seen([1, 2, 3], "xz"), [1, 3, -2])


@every_arm
def test_an_arm_is_drawn_through_its_table(arm):
    q, (_, ax) = joint_vectors(arm, ()), plt.subplots()
    arm_drawing(ax, arm, q, (30, 18))
    T = link_frames(arm, q)
    np.testing.assert_allclose(ax.lines[0].get_xydata(), seen(skeleton(arm, T), (30, 18))[:, :2])
    assert len(ax.patches) == 2 * arm.dof


def test_lengths_are_the_table_s():
    _, ax = plt.subplots()
    steps = {"d_1": (-0.2, 0), "a_2": (-0.2, 0), "d_4": (0, 0.1), "d_6": (0, 0.1)}
    lengths(ax, UR10E_HOMEWORK, UR10E_HOMEWORK.home, "yz", steps)
    wanted = ["$d_{1} = 128$", "$a_{2} = 612.7$", "$d_{4} = 163.9$", r"$d_{6}+l_{pen} = 192.2$"]
    assert [text.replace(" + ", "+") for text in texts(ax)] == wanted
    arrows = [text for text in ax.texts if not text.get_text()]
    drawn = [np.hypot(*np.subtract(arrow.xy, arrow.xyann)) for arrow in arrows]
    np.testing.assert_allclose(drawn, [0.128, 0.6127, 0.1639, 0.1922], atol=1e-12)
    _, ax = plt.subplots()
    lengths(ax, STANFORD, STANFORD.home, "yz", {"d_3": (0.1, 0), "d_2": (0, -0.1)})
    assert texts(ax) == ["$q_{3} = 500$", "$d_{2} = 154$"]


@pytest.mark.parametrize("view", ["xz", "xy", (-40, 35)])
def test_a_joints_outline_begins_at_one_corner_whatever_the_last_digit(view):
    def corners(q):
        _, ax = plt.subplots()
        arm_drawing(ax, ELBOW, q, view)
        plt.close(ax.figure)
        return [np.round(patch.get_xy(), 6) + 0.0 for patch in ax.patches]

    q = np.radians([0, 50, -75])
    rng = np.random.default_rng(0)
    for _ in range(20):
        for once, again in zip(corners(q), corners(q + rng.uniform(-2e-16, 2e-16, 3)), strict=True):
            np.testing.assert_array_equal(once, again)
