"""Time the homework's 1000 steps by Euler, Runge-Kutta and Newton in each program."""

from functools import partial

import numpy as np
import pinocchio
from kinematics import BARE, BASE_AXES, SIGNS, Pinocchio, make_toolbox_chain

from helpers.motion import circle, trace
from helpers.robots import PANDA

FREE = [0, 1, 3, 4, 5, 6]  # joint 3 is locked
PATH = circle([0.5735, 0, 0.7195], 0.1, "zy", 5.0, 1000)
STEP = 5.0 / 1000
ARM = BARE.lock(3)


class UserLoop:
    """Trace as users do, with a loop around a 6 x 7 Jacobian without column 3."""

    def __init__(self, jacobian_of) -> None:
        self.jacobian_of = jacobian_of

    def compute_rates(self, q: np.ndarray, t: float) -> np.ndarray:
        twist = np.concatenate([PATH.velocity(t), np.zeros(3)])
        return np.linalg.solve(self.jacobian_of(np.insert(q, 2, 0.0))[:, FREE], twist)

    def trace_by_euler(self) -> np.ndarray:
        """Trace by q_{k+1} = q_k + dt J^-1 xi, with tabulated velocities padded at each step."""
        q, trajectory = np.array(PANDA.home), np.empty((len(PATH.times), 7))
        trajectory[0] = q
        for k, v in enumerate(PATH.velocities[:-1]):
            J = self.jacobian_of(q)[:, FREE]
            q[FREE] += STEP * np.linalg.solve(J, np.concatenate([v, np.zeros(3)]))
            trajectory[k + 1] = q
        return np.delete(trajectory, 2, axis=1)

    def trace_by_padded_euler(self) -> np.ndarray:
        """Trace in the same way with twists padded beforehand."""
        q, trajectory = np.array(PANDA.home), np.empty((len(PATH.times), 7))
        trajectory[0] = q
        twists = np.hstack([PATH.velocities, np.zeros_like(PATH.velocities)])
        for k, twist in enumerate(twists[:-1]):
            q[FREE] += STEP * np.linalg.solve(self.jacobian_of(q)[:, FREE], twist)
            trajectory[k + 1] = q
        return np.delete(trajectory, 2, axis=1)

    def trace_by_rk4(self) -> np.ndarray:
        q, trajectory = np.array(ARM.home), np.empty((len(PATH.times), 6))
        trajectory[0] = q
        for k, t in enumerate(PATH.times[:-1]):
            k_1 = self.compute_rates(q, t)
            k_2 = self.compute_rates(q + STEP / 2 * k_1, t + STEP / 2)
            k_3 = self.compute_rates(q + STEP / 2 * k_2, t + STEP / 2)
            k_4 = self.compute_rates(q + STEP * k_3, t + STEP)
            q = q + STEP / 6 * (k_1 + 2 * k_2 + 2 * k_3 + k_4)
            trajectory[k + 1] = q
        return trajectory


class LockedPinocchio:
    """Trace with Pinocchio's fastest calls, joint 3 locked in its model."""

    def __init__(self, pin: Pinocchio) -> None:
        self.signs = SIGNS[FREE]
        self.model = pinocchio.buildReducedModel(pin.model, [3], SIGNS * PANDA.home)
        self.data, self.frame = self.model.createData(), self.model.getFrameId("panda_link8")

    def compute_jacobian(self, x: np.ndarray) -> np.ndarray:
        return pinocchio.computeFrameJacobian(self.model, self.data, x, self.frame, BASE_AXES)

    def trace_by_euler(self) -> np.ndarray:
        x, trajectory = self.signs * ARM.home, np.empty((len(PATH.times), 6))
        trajectory[0] = x
        moves = STEP * np.hstack([PATH.velocities, np.zeros_like(PATH.velocities)])
        jacobian, solve = self.compute_jacobian, np.linalg.solve
        for k, move in enumerate(moves[:-1]):
            x = x + solve(jacobian(x), move)
            trajectory[k + 1] = x
        return trajectory * self.signs

    def trace_by_rk4(self) -> np.ndarray:
        x, trajectory = self.signs * ARM.home, np.empty((len(PATH.times), 6))
        trajectory[0] = x
        moves = [PATH.velocity(PATH.times[:-1] + share * STEP) for share in (0.0, 0.5, 1.0)]
        moves = [STEP * np.hstack([v, np.zeros_like(v)]) for v in moves]
        jacobian, solve = self.compute_jacobian, np.linalg.solve
        for k, (begin, middle, end) in enumerate(zip(*moves, strict=True)):
            d_1 = solve(jacobian(x), begin)
            d_2 = solve(jacobian(x + 0.5 * d_1), middle)
            d_3 = solve(jacobian(x + 0.5 * d_2), middle)
            d_4 = solve(jacobian(x + d_3), end)
            x = x + (d_1 + 2 * (d_2 + d_3) + d_4) / 6
            trajectory[k + 1] = x
        return trajectory * self.signs

    def trace_by_newton(self, ahead: bool) -> np.ndarray:
        """Trace by Newton's method at each step to 1e-13.

        Args:
            ahead: Start from the extrapolation of the last three steps, not from the last step.
        """
        x, trajectory = self.signs * ARM.home, np.empty((len(PATH.times), 6))
        trajectory[0] = x
        start_rotation = self.compute_jacobian_and_pose(x)[1].rotation
        for k, position in enumerate(PATH.positions[1:], 1):
            if ahead and k > 2:
                x = 3 * (trajectory[k - 1] - trajectory[k - 2]) + trajectory[k - 3]
            for _ in range(30):
                J, pose = self.compute_jacobian_and_pose(x)
                error = np.empty(6)
                error[:3] = position - pose.translation
                turn = start_rotation @ pose.rotation.T
                error[3] = 0.5 * (turn[2, 1] - turn[1, 2])
                error[4] = 0.5 * (turn[0, 2] - turn[2, 0])
                error[5] = 0.5 * (turn[1, 0] - turn[0, 1])
                if np.abs(error).max() < 1e-13:
                    break
                x = x + np.linalg.solve(J, error)
            trajectory[k] = x
        return trajectory * self.signs

    def compute_jacobian_and_pose(self, x: np.ndarray) -> tuple[np.ndarray, pinocchio.SE3]:
        J = self.compute_jacobian(x)  # also updates the joint placements
        return J, pinocchio.updateFramePlacement(self.model, self.data, self.frame)


def trace_with_helpers(method: str) -> np.ndarray:
    return trace(ARM, ARM.home, PATH, method=method).q


def list_cases(Case):
    pin = Pinocchio()
    of_pinocchio = UserLoop(lambda q: pin.compute_jacobian(SIGNS * q) * SIGNS)
    of_toolbox, locked = UserLoop(make_toolbox_chain().jacob0), LockedPinocchio(pin)
    euler = {
        "the loop with Pinocchio, as users write it": of_pinocchio.trace_by_euler,
        "the same, twists padded beforehand": of_pinocchio.trace_by_padded_euler,
        "the same, joint 3 locked in the model, nothing else left in the loop": (
            locked.trace_by_euler
        ),
        "the loop with roboticstoolbox, as users write it": of_toolbox.trace_by_euler,
    }
    rk4 = {
        "the loop with Pinocchio, as users write it": of_pinocchio.trace_by_rk4,
        "the same at its best": locked.trace_by_rk4,
    }
    exact = {
        "Newton's method with Pinocchio, in one pass over the links": partial(
            locked.trace_by_newton, False
        ),
        "the same, begun where the last three steps lead": partial(locked.trace_by_newton, True),
    }
    for name, peers in (("euler", euler), ("rk4", rk4), ("exact", exact)):
        yield Case(f"{name} trace, 1 000 steps", partial(trace_with_helpers, name), peers, 1e-9, 9)
