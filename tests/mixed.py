"""Define a test arm with a locked joint and a slide, and turn machines of the corpus into arms."""

import math

from helpers.arm import Arm, Body, fixed, prismatic, revolute
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from tests.corpus.machine import Machine

H = math.pi / 2
MIXED = Machine([("R", 0.1, H, 0.3, 0), ("F", 0.05, -0.4, 0.12, H), ("P", 0, H, 0.2, 0),
                 ("R", 0.3, 0.6, 0.15, 1)])  # fmt: skip
HEAVY = [(2.5, 0.1, -0.05, 0.08), (0.0, 0.1, 0.1, 0.1), (1.7, -0.06, 0.12, 0.03),
         (0.9, 0.04, 0.07, -0.11)]  # fmt: skip
_KNOWN = {"PANDA": PANDA, "UR10E": UR10E, "UR10E_HOMEWORK": UR10E_HOMEWORK, "ELBOW": ELBOW,
          "STANFORD": STANFORD, "PANDA.lock(3)": PANDA.lock(3)}  # fmt: skip
_ROWS = {"R": revolute, "P": prismatic, "F": fixed}


def make_arm(machine):
    """Return the catalogue's arm of this machine's name, or a new arm of its rows."""
    rows = [_ROWS[kind](a, alpha, d, theta) for kind, a, alpha, d, theta in machine.rows]
    return _KNOWN.get(machine.name) or Arm("your arm", rows)


def add_masses(machine, links):
    """Return the arm with one (mass, x, y, z) per link, in kg and m."""
    return make_arm(machine).with_bodies([Body(mass, tuple(c)) for mass, *c in links])
