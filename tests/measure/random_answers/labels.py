"""Names of joints, quantities, rows and columns as people type them."""

from random import Random

SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")

#: Styles of the label of joint i, with weights. {n} is the number, {z} the number from zero,
#: {s} the subscript. People type tau1 and q1 most; numbering alone and words for joints come next.
_TORQUE = {
    "tau{n}": 12, "tau_{n}": 12, "τ{n}": 8, "τ{s}": 9, "τ_{n}": 7,
    "T{n}": 5, "t{n}": 2, "tau[{z}]": 4,
    "tau({n})": 4, "Tau {n}": 2, "torque {n}": 3, "Torque_{n}": 2, "M{n}": 2, "g_{n}": 1,
}  # fmt: skip
_ANGLE = {
    "q{n}": 14, "q_{n}": 12, "q{s}": 6, "θ{n}": 9, "θ{s}": 9, "θ_{n}": 6, "theta{n}": 10,
    "theta_{n}": 6, "th{n}": 3, "t{n}": 2, "q[{z}]": 4, "q({n})": 4, "Theta {n}": 2, "Angle {n}": 2,
}  # fmt: skip
_JOINT = {
    "joint {n}": 8, "Joint {n}": 12, "joint{n}": 6, "joint_{n}": 6, "J{n}": 10, "j{n}": 3,
    "({n})": 6,
    "{n}.": 5, "{n})": 5, "{n}": 10, "#{n}": 3, "Axis {n}": 2, "A{n}": 2, "panda_joint{n}": 2,
}  # fmt: skip
_LATEX = {
    "torque": (r"\tau_{n}", r"\tau_{{{n}}}"),
    "angle": (r"\theta_{n}", "q_{n}", r"\theta_{{{n}}}"),
}
_UR_NAMES = (
    "shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
    "wrist_1_joint", "wrist_2_joint", "wrist_3_joint",
)  # fmt: skip
_UR_WORDS = ("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3")


def draw_labels(
    rng: Random,
    family: str,
    kinds: tuple[str, ...],
    joints: tuple[int, ...],
    arm: str,
    *,
    numbering: bool,
):
    """Draw one label for each joint; return (style, labels).

    Args:
        family: class of the layout.
        kinds: "torque", "angle" or "length" for each joint.
        joints: joint numbers.
        arm: name of the arm.
        numbering: whether a bare number, as in (1), can be a label here.
    """
    quantity = "torque" if "torque" in kinds else "angle"
    if family == "latex":
        style = rng.choice(_LATEX[quantity])
        return style, [_fill(_slide(style, kind), n) for kind, n in zip(kinds, joints, strict=True)]
    if arm.startswith("UR") and len(joints) == 6 and rng.random() < 0.1:
        names = rng.choice((_UR_NAMES, _UR_WORDS))
        return "maker's names", list(names)
    table = _TORQUE if quantity == "torque" else _ANGLE
    table = table if rng.random() < 0.7 else _JOINT
    if not numbering:
        table = {style: weight for style, weight in table.items() if style[0].isalpha()}
    style = rng.choices(list(table), list(table.values()))[0]
    style = style.replace("panda", arm.split()[0].lower())
    return style, [_fill(_slide(style, kind), n) for kind, n in zip(kinds, joints, strict=True)]


def _slide(style: str, kind: str) -> str:
    """Replace theta by d in the label of a prismatic joint."""
    if kind != "length":
        return style
    for name in (r"\theta", "theta", "Theta ", "θ", "th", "Angle "):
        if style.startswith(name):
            return "d" + style.removeprefix(name)
    return style


def _fill(style: str, number: int) -> str:
    return style.format(n=number, z=number - 1, s=str(number).translate(SUBSCRIPTS))


#: Headings of the rows of a Jacobian.
JACOBIAN_ROWS = (
    ("vx", "vy", "vz", "wx", "wy", "wz"),
    ("v_x", "v_y", "v_z", "ω_x", "ω_y", "ω_z"),
    ("vx", "vy", "vz", "ωx", "ωy", "ωz"),
    ("x", "y", "z", "rx", "ry", "rz"),
    ("1", "2", "3", "4", "5", "6"),
    ("ẋ", "ẏ", "ż", "ωx", "ωy", "ωz"),
)
ROW_STEMS = {
    "branches": (
        "Solution {n}",
        "Sol {n}",
        "{n}",
        "Branch {n}",
        "({n})",
        "{n})",
        "q^({n})",
        "#{n}",
    ),
    "trace": ("{z}", "{n}", "step {z}"),
    "torques": ("Pose {n}", "{n}", "q{n}", "pose {n}", "({n})"),
}
