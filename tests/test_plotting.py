"""Test that figures draw what the table says, on the given axes and reproducibly.

nbval compares the chapters' stored figures, which covers the places of names and arrows.
"""

import xml.etree.ElementTree as ET
from dataclasses import replace
from io import BytesIO

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

from helpers.kinematics import link_frames, skeleton, tip
from helpers.motion import circle, trace
from helpers.plotting import (
    animate_trace,
    draw_arm,
    draw_wrist_triangles,
    plot_arm,
    plot_regions,
)
from helpers.plotting.drawing import project_points
from helpers.plotting.style import STYLE, format_svg
from helpers.robots import ELBOW, PANDA_HOMEWORK
from tests.laws import ALL_ARMS, arm_id, joint_vectors

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)


@pytest.fixture(autouse=True)
def _no_window():
    with mpl.rc_context({**STYLE, "backend": "agg"}):
        yield
        plt.close("all")


@every_arm
def test_skeleton_passes_through_frame_origins(arm):
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


def list_views(text):
    found = ET.fromstring(text).iterfind("{*}view")
    return [[int(side) for side in view.get("viewBox").split()] for view in found]


def test_svg_views_cover_each_drawn_pixel_once():
    """The figure has labels outside their axes, a 3D plot, a colour bar and a common legend."""
    figure = plt.figure(figsize=(8, 5))
    flat, space, heat, bare = (
        figure.add_subplot(2, 2, k, projection="3d" if k == 2 else None) for k in range(1, 5)
    )
    flat.plot([0, 1], label="both")
    flat.set(title="a title that is wider than its axes are", ylabel="an axis")
    space.plot([0, 1], [0, 1], [0, 1])
    figure.colorbar(heat.contourf([[0, 1], [2, 3]]), ax=heat)
    bare.set_axis_off()
    bare.plot([0, 1], "o", clip_on=False)
    figure.legend(loc="outside upper center")
    boxes = list_views(format_svg(figure))
    assert len(boxes) == 5
    figure.set_layout_engine("none")  # keep the layout of the first drawing
    file = BytesIO()
    figure.savefig(file, dpi=72, bbox_inches="tight")  # one pixel for each point (1/72 inch)
    file.seek(0)
    ink = plt.imread(file)[..., 3] > 0
    assert ink.sum() > 10_000
    seen = np.zeros(ink.shape, int)
    for left, top, wide, high in boxes:
        rows, columns = slice(top, top + high), slice(left, left + wide)
        assert ink[rows, columns].any()
        seen[rows, columns] += 1
    assert not ink[seen == 0].any(), "all is in a view"
    assert not ink[seen > 1].any(), "and in one alone"


@pytest.mark.parametrize("rows", [1, 7])
def test_single_column_figure_has_no_views(rows):
    figure, _ = plt.subplots(rows, 1, figsize=(5.6, 7), sharex=True)
    assert list_views(format_svg(figure)) == []


# Flat figures


def points(line):
    return np.transpose(line.get_data() if not hasattr(line, "get_data_3d") else line.get_data_3d())


def passes_through(ax, expected):
    """Return whether one of the lines has all these points among its corners."""
    gaps = (points(line)[:, None] - expected for line in ax.lines)
    return any((np.linalg.norm(gap, axis=2).min(axis=0) < 1e-9).all() for gap in gaps)


def run_of(steps=8):
    arm = PANDA_HOMEWORK.lock(3)
    q_0 = [0.1, 0.2, 1.4, 0.3, 1.6, 0.2]
    path = circle(link_frames(arm, q_0)[-1, :3, 3] - [0, 0, 0.05], 0.05, "zy", 5.0, steps)
    return trace(arm, q_0, path, method="exact")


@pytest.mark.parametrize(("plane", "columns"), [("xz", [0, 2]), ("yx", [1, 0])])
def test_arm_2d_is_projection_of_arm(plane, columns):
    _, ax = plt.subplots()
    plot_arm(ax, ELBOW, [0.3, 0.4, -0.9], plane)
    T = link_frames(ELBOW, [0.3, 0.4, -0.9])
    assert passes_through(ax, T[:, columns, 3])
    assert ax.get_xlabel() == f"${plane[0]}$ (m)"


def test_regions_differ_in_hatch():
    _, ax = plt.subplots()
    plot_regions(ax, [0, 1, 2], [0, 1, 2], np.eye(3), {0: "no", 1: "yes"}, colours=("#000", "#fff"))
    key = ax.get_legend()
    assert [text.get_text() for text in key.get_texts()] == ["no", "yes"]
    assert len({patch.get_hatch() for patch in key.get_patches()}) == 2
    for spot in np.random.default_rng(0).uniform(-0.5, 2.5, (200, 2)):  # the regions leave no gap
        drawn = [patch.get_path().contains_point(spot) for patch in ax.patches]
        one, other = np.rint(spot)
        assert drawn == [one != other, one == other]


def test_moving_picture_draws_only_while_tip_moves():
    """The tip rests for half the time, then moves evenly: the line must grow in the second half."""
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
    picture = ET.fromstring(animate_trace(paused, ("yz", "xz"), frames=8))
    ink, _ = picture.findall(".//{*}animate[@attributeName='stroke-dashoffset']")
    rest = np.array(ink.get("values").split(";"), dtype=float)
    np.testing.assert_allclose(rest / rest[0], [1, 1, 1, 1, 1, 0.75, 0.5, 0.25, 0], atol=1e-3)
    assert ink.get("dur") == "10s"


# Projections


@pytest.mark.parametrize("view", ["xz", "yz", "xy", "zy", (30, 18), (-60, 90), (200, -40)])
def test_view_is_a_rotation(view):
    right, up, towards = project_points(np.eye(3), view).T
    product = np.stack([right, up, towards]) @ project_points(np.eye(3), view)
    np.testing.assert_allclose(product, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(np.cross(right, up), towards, atol=1e-15)


def test_view_direction_matches_azimuth_and_elevation():
    """From azimuth 0, y points to the right; from 90 degrees, -x does; z points up."""
    np.testing.assert_allclose(project_points([0, 1, 0], (0, 20))[:2], [1, 0], atol=1e-15)
    np.testing.assert_allclose(project_points([1, 0, 0], (90, 20))[0], -1, atol=1e-15)
    assert project_points([0, 0, 1], (37, 20))[1] > 0
    assert project_points([1, 0, 0], (0, 20))[2] > 0
    np.testing.assert_allclose(project_points([1, 2, 3], "xz"), [1, 3, -2])


@every_arm
def test_arm_drawing_follows_skeleton(arm):
    q, (_, ax) = joint_vectors(arm, ()), plt.subplots()
    draw_arm(ax, arm, q, (30, 18))
    T = link_frames(arm, q)
    np.testing.assert_allclose(
        ax.lines[0].get_xydata(), project_points(skeleton(arm, T), (30, 18))[:, :2]
    )
    assert len(ax.patches) == 2 * arm.dof


def test_wrist_triangles_have_the_twists_as_sides():
    _, ax = plt.subplots()
    draw_wrist_triangles(ax, (60, 50), 70)
    corners = [line.get_xydata()[0] for line in ax.lines if line.get_marker() == "o"]
    on_sphere = [np.append(p, np.sqrt(1 - p @ p)) for p in corners]
    fifth, mirrored, fourth, sixth = on_sphere
    for axis in (fifth, mirrored):
        np.testing.assert_allclose(np.degrees(np.arccos([axis @ fourth, axis @ sixth])), [60, 50])
    assert np.degrees(np.arccos(fourth @ sixth)) == pytest.approx(70)


def test_plot_arm_draws_in_space_on_3d_axes():
    ax = plt.figure().add_subplot(projection="3d")
    plot_arm(ax, PANDA_HOMEWORK, PANDA_HOMEWORK.home)
    last = np.ravel([line.get_data_3d() for line in ax.lines][-1])
    np.testing.assert_allclose(last, tip(PANDA_HOMEWORK, PANDA_HOMEWORK.home))
    assert ax.get_zlabel() == "$z$ (m)"
