"""Figures: they draw what the table says, on the axes they are given, the same way every time."""

import io
import re

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

from helpers.kinematics import link_frames
from helpers.plotting import arm_3d, dh_numbers
from helpers.plotting.arms import skeleton
from helpers.plotting.style import STYLE, svg
from tests.laws import ALL_ARMS, ids, joint_vectors

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=ids)


@pytest.fixture(autouse=True)
def _no_window():
    with mpl.rc_context({**STYLE, "backend": "agg"}):
        yield
        plt.close("all")


def axes_3d():
    return plt.figure().add_subplot(projection="3d")


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


@every_arm
def test_an_arm_is_drawn_inside_its_axes(arm):
    ax = axes_3d()
    assert arm_3d(ax, arm, arm.home) is None
    points = link_frames(arm, arm.home)[:, :3, 3]
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    assert (points >= low - 1e-9).all()
    assert (points <= high + 1e-9).all()
    assert ax.get_zlabel() == "$z$ (m)"


def test_equal_scale_in_space():
    ax = axes_3d()
    arm_3d(ax, ALL_ARMS[0], ALL_ARMS[0].home)
    spans = np.diff([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()]).ravel()
    np.testing.assert_allclose(ax._box_aspect / spans, (ax._box_aspect / spans)[0])


def test_frames_that_coincide_share_a_label():
    ax = axes_3d()
    stanford = next(arm for arm in ALL_ARMS if arm.name == "Stanford arm")
    arm_3d(ax, stanford, stanford.home)
    labels = {text.get_text() for text in ax.texts}
    assert "$x_{3,4,5}$" in labels
    assert not any(label.startswith("$y") for label in labels)


def test_figures_come_out_the_same_twice():
    def once():
        figure = plt.figure()
        dh_numbers(figure.add_subplot(projection="3d"))
        return svg(figure)

    first = once()
    assert first == once()
    assert "<svg" in first
    assert "date" not in first
    assert not re.search(r"[1-9]\d*\.\d{3,}", first)


def test_rounding_keeps_the_picture():
    figure, ax = plt.subplots()
    ax.plot([0, 1], [0, 1])
    raw = io.StringIO()
    figure.savefig(raw, format="svg", bbox_inches="tight")
    assert len(svg(figure)) < len(raw.getvalue())
    assert "scale(0.015625)" in svg(figure)
