"""Test the catalogue of arms against numbers typed independently from the makers' pages."""

import inspect
import re
from dataclasses import FrozenInstanceError
from math import pi

import numpy as np
import pytest

from helpers import robots
from helpers.arm import Arm, revolute
from helpers.kinematics import forward_kinematics, link_frames
from helpers.robots import (
    ARMS,
    ELBOW,
    PANDA,
    PANDA_HOMEWORK,
    PLANAR_ARMS,
    STANFORD,
    UR10E,
    UR10E_HOMEWORK,
    find_arm,
    restore_lengths,
)
from tests.corpus.arms import CATALOGUE, LIMITS
from tests.laws import slow_modified_frames

# a_{i-1}, alpha_{i-1} and d_i of Franka's modified table.
FRANKAS_ROWS = [
    revolute(a, alpha, d)
    for a, alpha, d in [
        *((0, 0, 0.333), (0, "-pi/2", 0), (0, "pi/2", 0.316), (0.0825, "pi/2", 0)),
        *((-0.0825, "-pi/2", 0.384), (0, "pi/2", 0), (0.088, "pi/2", 0)),
    ]
]
SIGNS = np.array([1, -1, 1, -1, 1, 1, -1])  # q_maker = SIGNS * q for the Panda

# Masses and centres of Gaz et al. (2019), in the frames of Franka's modified table.
GAZ_MASSES = (4.970684, 0.646926, 3.228604, 3.587895, 1.225946, 1.666555, 0.735522)
GAZ_CENTRES = (
    (0.003875, 0.002081, -0.04762), (-0.003141, -0.02872, 0.003495), (0.027518, 0.039252,
    -0.066502),
    (-0.05317, 0.104419, 0.027454), (-0.011953, 0.041065, -0.038437), (0.060149, -0.014117,
    -0.010517),
    (0.010517, -0.004252, 0.061597),
)  # fmt: skip


def centres(arm, q):
    """Return each body's centre of mass in the base frame."""
    T = link_frames(arm, q)[1:]
    points = [[*(arm.number(c) for c in body.com), 1] for body in arm.bodies]
    return np.einsum("nij,nj->ni", T, points)[:, :3]


def test_panda_masses_match_gaz_2019():
    assert tuple(body.mass for body in PANDA.bodies) == GAZ_MASSES
    for q in np.random.default_rng(1).uniform(*PANDA.limits, size=(20, 7)):
        frames = slow_modified_frames(FRANKAS_ROWS, SIGNS * q)[1:]
        expected = [T @ [*c, 1] for T, c in zip(frames, GAZ_CENTRES, strict=True)]
        np.testing.assert_allclose(centres(PANDA, q), np.array(expected)[:, :3], atol=1e-14)


def test_pen_length_moves_the_tip():
    for arm in (PANDA, PANDA_HOMEWORK, UR10E, UR10E_HOMEWORK):
        with_pen, bare = (
            forward_kinematics(a, arm.home)[:3, 3] for a in (arm, arm.with_values(l_pen=0))
        )
        np.testing.assert_allclose(np.linalg.norm(with_pen - bare), 0.1, atol=1e-15)


def test_pen_length_does_not_move_masses():
    for arm in (PANDA, UR10E):
        bare = arm.with_values(l_pen=0)
        np.testing.assert_allclose(centres(arm, arm.home), centres(bare, arm.home), atol=1e-15)


def test_homework_panda_differs_only_in_a_3():
    assert dict(PANDA_HOMEWORK.values) == {**dict(PANDA.values), "a_3": 0.088}
    assert PANDA_HOMEWORK.rows == PANDA.rows
    np.testing.assert_allclose(PANDA.home, [0, 0, 0, pi / 2, 0, pi, 0])


def test_ur10e_masses_match_data_sheet():
    """The numbers are from Universal Robots, DH parameters for kinematics and dynamics."""
    bare = UR10E.with_values(l_pen=0)
    assert [body.mass for body in UR10E.bodies] == [7.369, 13.051, 3.989, 2.1, 1.98, 0.615]
    expected = [
        [0.021, 0, 0.027], [0.38, 0, 0.158], [0.24, 0, 0.068], [0, 0.007, 0.018], [0, 0.007, 0.018],
        [0, 0, -0.026],
    ]  # fmt: skip
    np.testing.assert_allclose([[bare.number(c) for c in b.com] for b in UR10E.bodies], expected)


@pytest.mark.parametrize("name", CATALOGUE)
def test_rows_match_independent_tables(name):
    """The tables of tests/corpus were typed independently."""
    arm = getattr(robots, name.partition(".")[0])
    arm = arm.lock(3) if name.endswith("lock(3)") else arm
    kinds, numbers = zip(*((kind, row) for kind, *row in CATALOGUE[name].rows), strict=True)
    assert tuple(row.joint.kind[0].upper() for row in arm.rows) == kinds
    found = [[arm.number(entry) for entry in row.entries] for row in arm.rows]
    np.testing.assert_allclose(found, numbers, atol=1e-15)


@pytest.mark.parametrize("name", [name for name in CATALOGUE if hasattr(robots, name)])
def test_limits_match_independent_numbers(name):
    """LIMITS of tests/corpus/arms.py was typed independently."""
    joints = [row.joint for row in getattr(robots, name).rows]
    actual = [(joint.lower, joint.upper, joint.speed, joint.effort) for joint in joints]
    unlimited = [(-np.inf, np.inf, np.inf, np.inf)] * len(joints)
    np.testing.assert_allclose(actual, LIMITS.get(name, unlimited), rtol=1e-15)


def test_catalogue_has_unique_arms_in_menu_order():
    """The homework's arms, in the order of the menus; an arm added later comes after them."""
    assert ARMS[:6] == (PANDA, PANDA_HOMEWORK, UR10E, UR10E_HOMEWORK, STANFORD, ELBOW)
    assert len({arm.name for arm in ARMS}) == len({hash(arm) for arm in ARMS}) == len(ARMS)


def test_every_arm_is_public_and_documented():
    """The catalogue's source lists each arm in `__all__` and has a comment above it."""
    documented = re.findall(
        r"^#: .*\n(?:#: .*\n)*(\w+) = ", inspect.getsource(robots), re.MULTILINE
    )
    public = {name: getattr(robots, name) for name in robots.__all__}
    names = {name for name, what in public.items() if not callable(what)}
    assert {*documented} == names, "expected a comment #: above each arm"
    arms = {what for what in public.values() if isinstance(what, Arm)}
    assert {*ARMS, *PLANAR_ARMS} == arms, "expected each arm in __all__, and in ARMS or PLANAR_ARMS"


@pytest.mark.parametrize("arm", [*ARMS, *PLANAR_ARMS], ids=lambda arm: arm.name)
def test_arm_has_name_source_and_valid_home(arm):
    assert find_arm(arm.name.upper()) is arm
    assert arm.source
    lower, upper = arm.limits
    assert ((lower <= arm.home) & (arm.home <= upper)).all()
    with pytest.raises(FrozenInstanceError):
        arm.values = ()


def test_every_arm_has_an_independent_table():
    """A new arm of the catalogue also needs its source's table, typed again, in tests/corpus."""
    names = {name for name, arm in vars(robots).items() if isinstance(arm, Arm)}
    missing = sorted(names - {*CATALOGUE})
    assert not missing, f"type the rows of {', '.join(missing)} in CATALOGUE of the corpus"


def test_length_of_zero_is_restored_with_a_warning():
    with pytest.warns(UserWarning, match="a_2 other than 0; it goes on with a_2 = 0.4 m"):
        arm = restore_lengths(ELBOW.with_values(a_2=0, a_3=0.2), ["a_2", "a_3"])
    assert arm == ELBOW.with_values(a_3=0.2)
