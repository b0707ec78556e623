"""Define the explorer as a notebook widget, whose joint vector Python and the page share."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import anywidget
import traitlets
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.checks.arms import arm_data
from helpers.explorer.data import arm_from, branches_data, circle_arm_data, path_data
from helpers.explorer.still import draw_still
from helpers.explorer.stub import RUN_HINT, describe_configuration, live_html
from helpers.inputs import (
    ArmError,
    finite_array,
    float_array,
    require_type,
    shorten,
    tuple_of_items,
)
from helpers.inverse import Solutions

VIEWS = ("table", "pose", "jacobian", "homework", "trace", "torque", "branches")
UNITS = ("deg", "rad")

TYPED_ARM_NAME = "Your arm"  # the same name as in judge/geometry/arm.js

BUNDLE = Path(__file__).parent / "static" / "explorer.js"


def widget_module(widget: str = "widget") -> str:
    """Return the JavaScript module that anywidget loads for one of the page's widgets.

    The key on `globalThis` makes all widgets of a page share one script and so one renderer.
    """
    script = BUNDLE.read_text(encoding="utf-8")
    key = f"arm-explorer {hashlib.sha256(script.encode()).hexdigest()[:12]}"
    return (
        f"const key = Symbol.for({key!r});\n"
        f"globalThis[key] ??= (() => {{ {script}\nreturn ArmExplorer; }})();\n"
        f"export default () => globalThis[key].{widget}();\n"
    )


class Floats(traitlets.TraitType):
    """Tuple of floats that accepts any array, list or tuple of numbers."""

    def validate(self, obj: object, value: Any) -> tuple[float, ...]:
        array = float_array(value, str(self.name), "numbers")
        if array.ndim != 1:
            raise ArmError(f"{self.name} has shape {array.shape}; expected numbers in a row, (n,)")
        return tuple(array.tolist())


class LiveWidget(anywidget.AnyWidget):
    """A figure that is live in a running notebook and on the book's pages.

    A cell that ends in one has two outputs: a still picture, for GitHub and for notebooks opened
    without a kernel, and the live figure with an HTML stub that a page brings to life.
    """

    _stub: Any

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        live: Any = super()._repr_mimebundle_(**kwargs)
        live = live[0] if isinstance(live, tuple) else live
        return {**(live or {}), "text/plain": repr(self), "text/html": self._stub}

    def _still(self) -> str:
        """Return the still picture as SVG text."""
        raise NotImplementedError

    def _ipython_display_(self) -> None:
        from IPython.display import display  # not needed to build pages

        still = {"image/svg+xml": self._still(), "text/plain": f"<still picture of {self!r}>"}
        display(still, raw=True)
        display(self._repr_mimebundle_(), raw=True)


class ArmExplorer(LiveWidget):
    """A live explorer of an arm.

    `q`, `wrench` and `trace` can be read and set while a reader moves the arm.

    Args:
        arm: The arm to show.
        q: The first joint vector, shape (dof,), rad or m; the arm's home if None.
        views: Names of the views to offer, of `VIEWS`; the first one is open.
        wrench: Force and moment of the world on the tool at its tip, in base axes, shape (6,), N
            and N m.
        trace: Joint vectors along a path, shape (N, dof), or an object with such a `q`.
        branches: Joint vectors that reach one pose: the result of a closed form of
            `helpers.inverse`, or an array of shape (k, dof).
        reference: The arm that the table view shows as a ghost; `arm` itself if None.
        arms: More arms to choose from.
        unit: Unit of the angles shown: "deg" or "rad".
        link: Whether the page's address keeps the state; for a page with nothing but the explorer.

    Raises:
        ArmError: A shape or a name does not fit the arm.
    """

    _esm = widget_module()

    _spec = traitlets.Dict().tag(sync=True)
    q = Floats().tag(sync=True)
    wrench = Floats().tag(sync=True)
    trace = traitlets.Any(None, allow_none=True).tag(sync=True)
    branches = traitlets.Any(None, allow_none=True).tag(sync=True)
    arm_name = traitlets.Unicode().tag(sync=True)
    rows: traitlets.List = traitlets.List().tag(sync=True)

    def __init__(
        self,
        arm: Arm,
        q: ArrayLike | None = None,
        *,
        views: Iterable[str] = VIEWS,
        wrench: ArrayLike = (0, 0, 0, 0, 0, 0),
        trace: Any = None,
        branches: Solutions | ArrayLike | None = None,
        reference: Arm | None = None,
        arms: Iterable[Arm] = (),
        unit: str = "deg",
        link: bool = False,
    ) -> None:
        # False while a whole state is set, so that a new arm keeps the results set with it.
        self._is_settled = False
        self._arms: dict[str, Arm] = {}
        for shown_arm in (arm, *tuple_of_items(arms, "arms", "arms to choose from")):
            require_type(shown_arm, Arm, "arm")
            if self._arms.setdefault(shown_arm.name, shown_arm) != shown_arm:
                raise ArmError(
                    f"two different arms are called {shown_arm.name!r}; expected each to have its"
                    " name"
                )
        views = _require_choices("view", views, VIEWS)
        to_data = circle_arm_data if "homework" in views else arm_data
        spec = {
            "arms": [to_data(a) for a in self._arms.values()],
            "views": views,
            "unit": _require_choices("unit", [unit], UNITS)[0],
            "reference": None if reference is None else arm_data(reference),
            "link": bool(link),
        }
        start = arm.home if q is None else q
        super().__init__(
            _spec=spec, arm_name=arm.name, q=start, wrench=wrench, trace=trace, branches=branches
        )
        self._is_settled = True

    @property
    def arm(self) -> Arm:
        """The shown arm, which is the chosen arm or `Your arm` of a typed table."""
        return arm_from(TYPED_ARM_NAME, self.rows) if self.rows else self._arms[self.arm_name]

    @traitlets.validate("arm_name")
    def _check_name(self, proposal: Mapping[str, Any]) -> str:
        if proposal["value"] not in self._arms:
            raise ArmError(
                f"arm_name is {proposal['value']!r}; expected one of {', '.join(self._arms)}"
            )
        return proposal["value"]

    @traitlets.observe("arm_name", "rows")
    def _on_another_arm(self, change: Mapping[str, Any]) -> None:
        """Set a new arm to its home and remove the results of the previous arm."""
        if not self._is_settled:
            return
        with self.hold_sync():
            if change["name"] == "arm_name":
                self.rows = []
            self.trace = self.branches = None
            self.q = self.arm.home if len(self.arm.home) == self.arm.dof else [0] * self.arm.dof

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Set the traits to a state from the page. A state with another arm must be complete."""
        self._is_settled = False
        try:
            super().set_state(sync_data)
        finally:
            self._is_settled = True

    @traitlets.validate("q")
    def _check_q(self, proposal: Mapping[str, Any]) -> tuple[float, ...]:
        return tuple(self.arm.joint_vector(proposal["value"]).tolist())

    @traitlets.validate("wrench")
    def _check_wrench(self, proposal: Mapping[str, Any]) -> tuple[float, ...]:
        expected = "six finite numbers (fx, fy, fz, mx, my, mz)"
        return tuple(finite_array(proposal["value"], "wrench", expected, (6,)).tolist())

    @traitlets.validate("trace")
    def _check_trace(self, proposal: Mapping[str, Any]) -> list[list[float]] | None:
        return path_data(self.arm, proposal["value"])

    @traitlets.validate("branches")
    def _check_branches(self, proposal: Mapping[str, Any]) -> list[dict[str, Any]] | None:
        return branches_data(self.arm, proposal["value"])

    @property
    def _stub(self) -> str:
        state = {"q": self.q, "wrench": self.wrench, "trace": self.trace, "branches": self.branches}
        class_name = "arm-explorer whole" if self._spec["link"] else "arm-explorer"
        return live_html(
            describe_configuration(self.arm, self.q) + RUN_HINT, {**self._spec, **state}, class_name
        )

    def _still(self) -> str:
        return draw_still(self.arm, self.q)

    def __repr__(self) -> str:
        return f"<ArmExplorer of the {self.arm_name}>"


def _require_choices(noun: str, names: Iterable[str], choices: tuple[str, ...]) -> list[str]:
    """Return the names.

    Raises ArmError if there is none, or if a name is not among the choices.
    """
    names = tuple_of_items(names, f"{noun}s", f"some of {', '.join(choices)}")
    unknown = [shorten(name) for name in names if not isinstance(name, str) or name not in choices]
    if unknown or not names:
        raise ArmError(f"{noun} is {', '.join(unknown) or 'none'}; expected {', '.join(choices)}")
    return list(names)
