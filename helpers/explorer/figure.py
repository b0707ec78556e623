"""The small figures that stand beside the chapters' sentences: live in a running notebook, a stub
that the book's page brings to life."""

from collections.abc import Iterable
from typing import Any

import traitlets
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.checks.arms import arm_data
from helpers.explorer.still import draw_still
from helpers.explorer.stub import RUN_HINT, stub
from helpers.explorer.widget import Live, esm
from helpers.inputs import ArmError, listed, must_be, one_of, shown
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E_HOMEWORK

#: The figures that take any arm, with the arm that each shows unless told otherwise,
ANY_ARM = {
    "columns": UR10E_HOMEWORK,
    "ellipsoid": UR10E_HOMEWORK,
    "hand": UR10E_HOMEWORK,
    "loads": PANDA,
    "matrix": ELBOW,
    "row": UR10E_HOMEWORK,
    "ways": STANFORD,
}
#: and those about one arm of the homework, with any lengths.
ONE_ARM = {"swing": PANDA, "triangles": ELBOW, "winds": PANDA_HOMEWORK}


#: What else a figure may be told, as the chapters' own are.
SETTINGS = ("angle", "column", "fixed", "frames", "lit", "push", "row", "words", "wrench")


class ArmFigure(Live):
    """A small live figure, as the chapters show them beside a sentence.

    Args:
        kind: which figure: any arm's columns, ellipsoid, hand, loads, matrix, row or ways; or
            swing, triangles or winds, which show one arm each, of any lengths.
        arm: the arm to show.
        q: where it stands first, shape (dof,), rad or m; its home unless given.
        joints: numbers of the joints, from 1, that get a lever.
        settings: what else one kind takes: the `row` or `column`, from 1, that it begins with, the
            `wrench` that pushes, its `words`, and others of `SETTINGS`.

    Raises:
        ArmError: there is no such figure or setting, or it does not show this arm, place or joint.
    """

    _esm = esm("figureWidget")

    _spec = traitlets.Dict().tag(sync=True)

    def __init__(
        self,
        kind: str,
        arm: Arm | None = None,
        *,
        q: ArrayLike | None = None,
        joints: Iterable[int] = (),
        **settings: object,
    ) -> None:
        known = ANY_ARM | ONE_ARM
        if not isinstance(kind, str) or kind not in known:
            raise ArmError(f"kind is {shown(kind)}; expected one of {', '.join(sorted(known))}")
        arm = known[kind] if arm is None else arm
        must_be(arm, Arm, "arm")
        own = ONE_ARM.get(kind, arm)
        if _table(arm) != _table(own):
            raise ArmError(f"arm is the {arm.name}; the figure {kind} shows the {own.name}")
        joints = listed(joints, "joints", "numbers of joints, from 1")
        strange = [shown(number) for number in joints if number not in arm.joints]
        if strange:
            own_joints = ", ".join(map(str, arm.joints))
            raise ArmError(f"joints has {', '.join(strange)}; the {arm.name} has {own_joints}")
        for name in settings:
            one_of(name, "setting", SETTINGS)
        spec: dict[str, Any] = {**settings, "figure": kind, "joints": [*map(int, joints)]}
        spec["arm"] = arm_data(arm)
        if q is not None:
            spec["q"] = arm.joint_vector(q).tolist()
        self._arm = arm
        super().__init__(_spec=spec)

    @property
    def _stub(self) -> str:
        options = {key: value for key, value in self._spec.items() if key != "figure"}
        words = f"A live figure of the {self._arm.name}."
        return stub(words + RUN_HINT, options, figure=self._spec["figure"])

    def _still(self) -> str:
        return draw_still(self._arm, self._spec.get("q", self._arm.home))

    def __repr__(self) -> str:
        return f"<ArmFigure {self._spec['figure']} of the {self._arm.name}>"


def _table(arm: Arm) -> list[tuple]:
    return [(row.joint.kind, *row.entries) for row in arm.rows]
