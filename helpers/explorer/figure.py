"""Small live figures of arms, which the chapters show beside a sentence."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import traitlets
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.checks.arms import arm_data
from helpers.explorer.still import draw_still
from helpers.explorer.stub import RUN_HINT, live_html
from helpers.explorer.widget import LiveWidget, widget_module
from helpers.inputs import ArmError, require_choice, require_type, shorten, tuple_of_items
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E_HOMEWORK

#: Figures that show any arm, each with its default arm.
ANY_ARM = {
    "columns": UR10E_HOMEWORK,
    "ellipses": ELBOW,
    "ellipsoid": UR10E_HOMEWORK,
    "hand": UR10E_HOMEWORK,
    "loads": PANDA,
    "matrix": ELBOW,
    "row": UR10E_HOMEWORK,
    "ways": STANFORD,
}
#: Figures that show only this arm, possibly with other lengths.
ONE_ARM = {"swing": PANDA, "triangles": ELBOW, "winds": PANDA_HOMEWORK}

#: Names of all other settings of figures; each kind of figure uses some of them.
SETTINGS = ("angle", "column", "fixed", "frames", "lit", "push", "row", "words", "wrench")


class ArmFigure(LiveWidget):
    """A small live figure, which the chapters show beside a sentence.

    Args:
        kind: The figure: columns, ellipsoid, hand, loads, matrix, row or ways, which show any arm;
            ellipses, which shows an arm of three joints that turn; or swing, triangles or winds,
            which show one arm of any lengths.
        arm: The arm to show; the figure's default arm if None.
        q: The first joint vector, shape (dof,), rad or m; the arm's home if None.
        joints: Numbers of the joints, from 1, that the figure lets move.
        settings: Settings of one kind of figure: the `row` or `column`, from 1, shown first, the
            `wrench` at the tool, its `words`, and others of `SETTINGS`.

    Raises:
        ArmError: No such figure or setting exists, or the figure does not show this arm,
            configuration or joint.
    """

    _esm = widget_module("figureWidget")

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
        default_arms = ANY_ARM | ONE_ARM
        if not isinstance(kind, str) or kind not in default_arms:
            raise ArmError(
                f"kind is {shorten(kind)}; expected one of {', '.join(sorted(default_arms))}"
            )
        arm = default_arms[kind] if arm is None else arm
        require_type(arm, Arm, "arm")
        if kind == "ellipses" and not (arm.dof == 3 and arm.turning.all()):
            raise ArmError(f"arm is {arm!r}; the figure ellipses shows three joints that turn")
        shown_arm = ONE_ARM.get(kind, arm)
        if _table_symbols(arm) != _table_symbols(shown_arm):
            raise ArmError(f"arm is the {arm.name}; the figure {kind} shows the {shown_arm.name}")
        joints = tuple_of_items(joints, "joints", "numbers of joints, from 1")
        unknown = [shorten(number) for number in joints if number not in arm.joints]
        if unknown:
            arm_joints = ", ".join(map(str, arm.joints))
            raise ArmError(f"joints has {', '.join(unknown)}; the {arm.name} has {arm_joints}")
        for name in settings:
            require_choice(name, "setting", SETTINGS)
        spec: dict[str, Any] = {**settings, "figure": kind, "joints": [*map(int, joints)]}
        spec["arm"] = arm_data(arm)
        if q is not None:
            spec["q"] = arm.joint_vector(q).tolist()
        self._arm = arm
        super().__init__(_spec=spec)

    @property
    def _stub(self) -> str:
        options = {key: value for key, value in self._spec.items() if key != "figure"}
        text = f"A live figure of the {self._arm.name}."
        return live_html(text + RUN_HINT, options, figure=self._spec["figure"])

    def _still(self) -> str:
        return draw_still(self._arm, self._spec.get("q", self._arm.home))

    def __repr__(self) -> str:
        return f"<ArmFigure {self._spec['figure']} of the {self._arm.name}>"


def _table_symbols(arm: Arm) -> list[tuple]:
    return [(row.joint.kind, *row.entries) for row in arm.rows]
