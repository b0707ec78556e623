"""Forward kinematics and Jacobians of the Panda."""

import sysconfig
from functools import partial
from pathlib import Path

import casadi
import numpy as np
import pinocchio
import roboticstoolbox as rtb

from helpers.arm import NumericRow
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import PANDA

SIGNS = np.array([1, -1, 1, -1, 1, 1, -1])
HALF_TURN = np.diag([1.0, -1.0, -1.0, 1.0])
BLOCK = 1000
BARE = PANDA.with_values(l_pen=0)  # the peers' tip is the flange


def ets() -> rtb.ETS:
    """The table as roboticstoolbox's elementary transforms."""
    chain = rtb.ETS()
    for row in BARE.rows:
        a, alpha, d = (BARE.number(e) for e in (row.a, row.alpha, row.d))
        chain = chain * rtb.ET.Rz() * rtb.ET.tz(d) * rtb.ET.tx(a) * rtb.ET.Rx(alpha)
    return chain


def link(row: NumericRow, c, s) -> list[list]:
    """A row's transform, its joint turned by the angle with this cosine and sine."""
    ca, sa = row.cos_alpha, row.sin_alpha
    return [
        [c, -s * ca, s * sa, row.a * c],
        [s, c * ca, -c * sa, row.a * s],
        [0, sa, ca, row.d],
        [0, 0, 0, 1],
    ]


def casadi_functions() -> tuple[casadi.Function, casadi.Function]:
    """The table as CasADi expressions: the pose, and the Jacobian with columns z x (o_n - o) over
    z."""
    q, T, frames = casadi.SX.sym("q", 7), casadi.SX.eye(4), []
    for k, row in enumerate(BARE.numeric):
        frames.append(T)
        T = T @ casadi.vertcat(
            *(casadi.horzcat(*line) for line in link(row, casadi.cos(q[k]), casadi.sin(q[k])))
        )
    columns = [
        casadi.vertcat(casadi.cross(F[:3, 2], T[:3, 3] - F[:3, 3]), F[:3, 2]) for F in frames
    ]
    return casadi.Function("pose", [q], [T]), casadi.Function(
        "jacobian", [q], [casadi.horzcat(*columns)]
    )


class Pinocchio:
    """Pinocchio's own Panda, called once per configuration."""

    def __init__(self) -> None:
        site = Path(sysconfig.get_paths()["purelib"])
        urdf = (
            site / "cmeel.prefix/share/example-robot-data/robots/panda_description/urdf/panda.urdf"
        )
        model = pinocchio.buildModelFromUrdf(str(urdf))
        fingers = [model.getJointId(f"panda_finger_joint{k}") for k in (1, 2)]
        self.model = pinocchio.buildReducedModel(model, fingers, pinocchio.neutral(model))
        self.data, self.frame = self.model.createData(), self.model.getFrameId("panda_link8")

    def poses(self, q: np.ndarray) -> np.ndarray:
        found = np.empty((len(q), 4, 4))
        for k, maker in enumerate(q * SIGNS):
            pinocchio.forwardKinematics(self.model, self.data, maker)
            found[k] = pinocchio.updateFramePlacement(self.model, self.data, self.frame).homogeneous
        return found @ HALF_TURN

    def jacobians(self, q: np.ndarray) -> np.ndarray:
        found, axes = np.empty((len(q), 6, 7)), pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        for k, maker in enumerate(q * SIGNS):
            found[k] = pinocchio.computeFrameJacobian(
                self.model, self.data, maker, self.frame, axes
            )
        return found * SIGNS


def mapped(function: casadi.Function):
    """A CasADi function over a batch, in blocks (faster than a map over it all), as (batch, rows,
    columns)."""
    over = function.map(BLOCK)
    rows, columns = function.size_out(0)

    def work(q):
        found = np.empty((len(q), rows, columns))
        for start in range(0, len(q), BLOCK):
            part = over(q[start : start + BLOCK].T).full()
            found[start : start + BLOCK] = part.T.reshape(-1, columns, rows).transpose(0, 2, 1)
        return found

    return work


def cases(Case):
    pin, chain = Pinocchio(), ets()
    pose, jac = (mapped(function) for function in casadi_functions())
    poses = {
        "CasADi Function.map": pose,
        "Pinocchio, in a loop": pin.poses,
        "roboticstoolbox ETS.fkine": chain.eval,
    }
    jacobians = {
        "CasADi Function.map": jac,
        "Pinocchio, in a loop": pin.jacobians,
        "roboticstoolbox ETS.jacob0, in a loop": lambda q: np.array([chain.jacob0(x) for x in q]),
    }
    for size, rounds in ((1000, 31), (1_000_000, 1)):
        q = np.random.default_rng(0).uniform(*PANDA.limits, size=(size, 7))
        count = f"{size:,}".replace(",", " ")
        for name, ours, peers in (
            ("FK", forward_kinematics, poses),
            ("Jacobian", jacobian, jacobians),
        ):
            works = {peer: partial(work, q) for peer, work in peers.items()}
            yield Case(f"{name}, {count} poses", partial(ours, BARE, q), works, 1e-12, rounds)
