"""Define other published numbers of the homework's arms, which students use by mistake.

A maker may count a joint the other way, a report may simplify the masses, and robots of nearly the
same name have other lengths. The judge names such a mistake; its own code knows no arm.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from helpers.arm import Arm, Body
from helpers.inputs import require_type
from helpers.robots import PANDA, UR10E, UR10E_HOMEWORK

__all__ = ["find_variants"]


@dataclass(frozen=True)
class Namesake:
    """A robot with a similar name, whose numbers students use by mistake.

    Args:
        name: Its name.
        lengths: Its values for symbols of the arm's table, in m.
        masses: Its masses, one for each row, in kg; none where they are unknown.
    """

    name: str
    lengths: Mapping[str, float]
    masses: Sequence[float] = ()


@dataclass(frozen=True)
class LumpedModel:
    """A report's model of an arm with some links lumped into one body.

    Args:
        report: The report, as a sentence names it.
        links: Numbers of the links that are lumped.
        bodies: One `Body` for each row.
        gravity: The report's g, in m/s².
    """

    report: str
    links: Sequence[int]
    bodies: Sequence[Body]
    gravity: float


@dataclass(frozen=True)
class Variants:
    """Other published numbers of an arm, which students mix with those of its table.

    Args:
        maker_signs: 1 for each row whose joint the maker counts as the table does, else -1.
        published_centres: Centres of mass as published, in the publication's frames, in m.
        lumped: A report's simpler model.
        namesakes: Robots of nearly the same name.
    """

    maker_signs: Sequence[int] = ()
    published_centres: Sequence[Sequence[float]] = ()
    lumped: LumpedModel | None = None
    namesakes: Sequence[Namesake] = ()


_PANDA_VARIANTS = Variants(
    maker_signs=(1, -1, 1, -1, 1, 1, -1),
    # Centres of Gaz et al. (2019), in the frames of the maker's modified table.
    published_centres=(
        (0.003875, 0.002081, -0.04762),
        (-0.003141, -0.02872, 0.003495),
        (0.027518, 0.039252, -0.066502),
        (-0.05317, 0.104419, 0.027454),
        (-0.011953, 0.041065, -0.038437),
        (0.060149, -0.014117, -0.010517),
        (0.010517, -0.004252, 0.061597),
    ),
    # In the homework's report on the Panda, links 2 and 3 are a single uniform bar.
    lumped=LumpedModel(
        "the Panda report",
        (2, 3),
        (
            PANDA.bodies[0],
            Body(0.646926 + 3.228604, (0, 0, "d_3/2")),
            Body(0, (0, 0, 0)),
            *PANDA.bodies[3:],
        ),
        9.8,
    ),
)

_LENGTHS = ("d_1", "a_2", "a_3", "d_4", "d_5", "d_6")
# Universal Robots' table of DH parameters: lengths (m) and masses (kg) of the UR10.
_UR10 = dict(zip(_LENGTHS, (0.1273, 0.612, 0.5723, 0.163941, 0.1157, 0.0922), strict=True))
_UR10_MASSES = (7.1, 12.7, 4.27, 2.0, 2.0, 0.365)
_UR10_DRAWN = {name: UR10E_HOMEWORK.values[name] for name in _LENGTHS}  # as drawn in its manual
_UR10E_LENGTHS = {name: UR10E.values[name] for name in _LENGTHS}

_VARIANTS = (
    (PANDA, _PANDA_VARIANTS),
    (
        UR10E,
        Variants(
            namesakes=(
                Namesake("UR10", _UR10_DRAWN, _UR10_MASSES),
                Namesake("UR10", _UR10, _UR10_MASSES),
            )
        ),
    ),
    (UR10E_HOMEWORK, Variants(namesakes=(Namesake("UR10e", _UR10E_LENGTHS),))),
)


def find_variants(arm: Arm) -> Variants:
    """Find other published numbers of an arm, by the symbols in its table.

    Locked joints make no difference, and other values only to the namesakes: an arm with lengths
    of its own has none. An arm outside the catalogue has no variants.

    Example:
        >>> from helpers.robots import PANDA
        >>> find_variants(PANDA.lock(3)).maker_signs
        (1, -1, 1, -1, 1, 1, -1)
    """
    require_type(arm, Arm, "arm")
    table = [(row.a, row.alpha, row.d) for row in arm.rows]
    for known, variants in _VARIANTS:
        if table == [(row.a, row.alpha, row.d) for row in known.rows]:
            namesakes = [
                namesake
                for namesake in variants.namesakes
                if all(arm.values[name] == known.values[name] for name in namesake.lengths)
            ]
            return replace(variants, namesakes=namesakes)
    return Variants()
