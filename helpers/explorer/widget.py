"""The explorer's widget, which shares its joint vector with the page."""

import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import anywidget
import traitlets
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.checks.arms import arm_data
from helpers.explorer.data import arm_from, branches_data, path_data
from helpers.explorer.still import draw_still
from helpers.explorer.stub import RUN_HINT, standing, stub
from helpers.inputs import ArmError, floats, listed, must_be, numbers, shown
from helpers.inverse import Solutions

VIEWS = ("table", "pose", "jacobian", "homework", "trace", "torque", "branches")
UNITS = ("deg", "rad")

TYPED = "Your arm"  # as judge/geometry/arm.js calls an arm whose table was typed in

BUNDLE = Path(__file__).parent / "static" / "explorer.js"


def esm(widget: str = "widget") -> str:
    """The script as the module that a widget loads: each widget of a page takes the same one, with
    one renderer."""
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
        array = floats(value, str(self.name), "numbers")
        if array.ndim != 1:
            raise ArmError(f"{self.name} has shape {array.shape}; expected numbers in a row, (n,)")
        return tuple(array.tolist())


class Live(anywidget.AnyWidget):
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
        from IPython.display import display  # a notebook has it, the page's build need not

        still = {"image/svg+xml": self._still(), "text/plain": f"<still picture of {self!r}>"}
        display(still, raw=True)
        display(self._repr_mimebundle_(), raw=True)


class ArmExplorer(Live):
    """A live instrument for an arm: `q`, `wrench` and `trace` may be read and set while a reader
    moves it.

    Args:
        arm: the arm to show.
        q: where it stands first, shape (dof,), rad or m; its home unless given.
        views: which of table, pose, jacobian, trace, torque, branches to offer, the first one open.
        wrench: force and moment on the tool by the world, at the tip, base axes, shape (6,), N and
            N m.
        trace: joint vectors along a path, shape (N, dof), or an object with such a `q`.
        branches: joint vectors that reach one pose: what a closed form of `helpers.inverse`
            returns, or an array of shape (k, dof).
        reference: the arm behind the table, as a ghost; the arm itself unless given.
        arms: more arms to choose from.
        unit: of the angles shown: deg or rad.
        link: keep the state in the page's address; for a page that holds nothing else.

    Raises:
        ArmError: a count or name does not fit.
    """

    _esm = esm()

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
        self._settled = (
            False  # nothing is dropped while everything is first set, or when the page says it all
        )
        self._arms = _by_name((arm, *listed(arms, "arms", "arms to choose from")))
        spec = {
            "arms": [arm_data(a) for a in self._arms.values()],
            "views": _known("view", views, VIEWS),
            "unit": _known("unit", [unit], UNITS)[0],
            "reference": None if reference is None else arm_data(reference),
            "link": bool(link),
        }
        start = arm.home if q is None else q
        super().__init__(
            _spec=spec, arm_name=arm.name, q=start, wrench=wrench, trace=trace, branches=branches
        )
        self._settled = True

    @property
    def arm(self) -> Arm:
        """The arm shown: the chosen one, or `Your arm` of a typed table."""
        return arm_from(TYPED, self.rows) if self.rows else self._arms[self.arm_name]

    @traitlets.validate("arm_name")
    def _check_name(self, proposal: Mapping[str, Any]) -> str:
        if proposal["value"] not in self._arms:
            raise ArmError(
                f"arm_name is {proposal['value']!r}; expected one of {', '.join(self._arms)}"
            )
        return proposal["value"]

    @traitlets.observe("arm_name", "rows")
    def _on_another_arm(self, change: Mapping[str, Any]) -> None:
        """Put a new arm at its home and drop results of the previous arm."""
        if not self._settled:
            return
        with self.hold_sync():
            if change["name"] == "arm_name":
                self.rows = []
            self.trace = self.branches = None
            self.q = self.arm.home if len(self.arm.home) == self.arm.dof else [0] * self.arm.dof

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Take a state from the page, which is complete if it names another arm."""
        self._settled = False
        try:
            super().set_state(sync_data)
        finally:
            self._settled = True

    @traitlets.validate("q")
    def _check_q(self, proposal: Mapping[str, Any]) -> tuple[float, ...]:
        return tuple(self.arm.joint_vector(proposal["value"]).tolist())

    @traitlets.validate("wrench")
    def _check_wrench(self, proposal: Mapping[str, Any]) -> tuple[float, ...]:
        wanted = "six finite numbers (fx, fy, fz, mx, my, mz)"
        return tuple(numbers(proposal["value"], "wrench", wanted, (6,)).tolist())

    @traitlets.validate("trace")
    def _check_trace(self, proposal: Mapping[str, Any]) -> list[list[float]] | None:
        return path_data(self.arm, proposal["value"])

    @traitlets.validate("branches")
    def _check_branches(self, proposal: Mapping[str, Any]) -> list[dict[str, Any]] | None:
        return branches_data(self.arm, proposal["value"])

    @property
    def _stub(self) -> str:
        state = {"q": self.q, "wrench": self.wrench, "trace": self.trace, "branches": self.branches}
        name = "arm-explorer whole" if self._spec["link"] else "arm-explorer"
        return stub(standing(self.arm, self.q) + RUN_HINT, {**self._spec, **state}, name)

    def _still(self) -> str:
        return draw_still(self.arm, self.q)

    def __repr__(self) -> str:
        return f"<ArmExplorer of the {self.arm_name}>"


def _by_name(arms: Iterable[Arm]) -> dict[str, Arm]:
    named: dict[str, Arm] = {}
    for arm in arms:
        must_be(arm, Arm, "arm")
        if named.setdefault(arm.name, arm) != arm:
            raise ArmError(
                f"two different arms are called {arm.name!r}; expected each to have its name"
            )
    return named


def _known(what: str, given: Iterable[str], known: tuple[str, ...]) -> list[str]:
    given = listed(given, f"{what}s", f"some of {', '.join(known)}")
    unknown = [shown(name) for name in given if not isinstance(name, str) or name not in known]
    if unknown or not given:
        raise ArmError(f"{what} is {', '.join(unknown) or 'none'}; expected {', '.join(known)}")
    return list(given)
