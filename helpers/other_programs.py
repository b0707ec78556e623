"""Write an arm as code of other programs, so that the same numbers can be computed there.

`write_code` writes for the Robotics Toolbox (Python and MATLAB), Modern Robotics, Pinocchio and
SymPy, `write_urdf` writes a robot description. Code ends with the calls that give the pose and the
Jacobians, and says which function of `helpers` gives the same numbers.
"""

from collections.abc import Callable
from xml.sax.saxutils import quoteattr

import numpy as np

from helpers.arm import Arm, Row, require_joints
from helpers.inputs import require_choice
from helpers.kinematics import forward_kinematics, link_frames

__all__ = ["write_code", "write_urdf"]


def write_code(arm: Arm, program: str) -> str:
    """Write an arm as code of another program.

    Args:
        arm: The arm.
        program: "Robotics Toolbox", "MATLAB", "Modern Robotics", "Pinocchio" or "SymPy", in capital
            or small letters.

    Returns:
        The code. It defines q as zeros, the pose T, and Jacobians with the calls for them.

    Example:
        >>> from helpers.robots import ELBOW
        >>> print(write_code(ELBOW, "matlab").splitlines()[0])
        L(1) = Revolute('d', 0.5, 'a', 0, 'alpha', pi/2, 'offset', 0);
    """
    require_joints(arm)
    name = program.lower() if isinstance(program, str) else program
    return _WRITERS[require_choice(name, "program", _WRITERS)](arm)


def write_urdf(arm: Arm) -> str:
    """Write an arm as a robot description (URDF).

    Each row is a joint q_i and a link link_i; the last fixed joint leads to the link "tool". Bodies
    are written with their inertia tensors, which are 0 for point masses.

    Example:
        >>> from helpers.robots import ELBOW
        >>> from helpers.urdf import from_urdf
        >>> from_urdf(write_urdf(ELBOW))
        <Arm Elbow arm: 3 rows, RRR>
    """
    require_joints(arm)
    origin, parts = (0.0, 0.0, 0.0, 0.0), ['<link name="base"/>']
    for i, row in enumerate(arm.rows, 1):
        joint, parent = row.joint, f"link_{i - 1}" if i > 1 else "base"
        a, alpha, d, theta = map(arm.number, row.entries)
        origin_text, origin = _write_origin(origin), (a, alpha, d, theta)
        has_ends = bool(np.isfinite([joint.lower, joint.upper]).all())
        kind = "continuous" if joint.kind == "revolute" and not has_ends else joint.kind
        limit = ""
        if kind != "fixed":
            # URDF requires effort and velocity, where 0 means unknown.
            numbers = {"effort": joint.effort, "velocity": joint.speed}
            texts = [f'{key}="{x if np.isfinite(x) else 0}"' for key, x in numbers.items()]
            texts += [f'lower="{joint.lower}"', f'upper="{joint.upper}"'] if has_ends else []
            limit = f"<limit {' '.join(texts)}/>"
        parts.append(
            f'<joint name="q_{i}" type="{kind}"><parent link="{parent}"/>'
            f'<child link="link_{i}"/>{origin_text}<axis xyz="0 0 1"/>{limit}</joint>'
        )
        parts.append(f'<link name="link_{i}">{_write_inertial(arm, i)}</link>')
    parts.append(
        f'<joint name="flange" type="fixed"><parent link="link_{len(arm.rows)}"/>'
        f'<child link="tool"/>{_write_origin(origin)}</joint><link name="tool"/>'
    )
    body = "\n  ".join(parts)
    return f'<?xml version="1.0"?>\n<robot name={quoteattr(arm.name)}>\n  {body}\n</robot>\n'


def _write_origin(numbers: tuple[float, float, float, float]) -> str:
    """Write Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) as an element <origin>."""
    a, alpha, d, theta = numbers
    lengths = (float(length) for length in (a * np.cos(theta), a * np.sin(theta), d))
    x, y, z = (length if abs(length) > 1e-15 else 0.0 for length in lengths)  # remove round-off
    return f'<origin xyz="{x!r} {y!r} {z!r}" rpy="{alpha!r} 0 {theta!r}"/>'


def _write_inertial(arm: Arm, i: int) -> str:
    """Write the mass of row i.

    Its link's frame comes before the row's own lengths and angles.
    """
    if not arm.bodies or not arm.number(arm.bodies[i - 1].mass):
        return ""
    body, row = arm.bodies[i - 1], arm.numeric[i - 1]
    c, s, ca, sa = row.cos_theta, row.sin_theta, row.cos_alpha, row.sin_alpha
    R = np.array([[c, -s * ca, s * sa], [s, c * ca, -c * sa], [0, sa, ca]])
    com = [row.a * c, row.a * s, row.d] + R @ [arm.number(x) for x in body.com]
    x, y, z = com.tolist()
    I = (R @ np.array(body.inertia) @ R.T).tolist()
    pairs = {"xx": (0, 0), "xy": (0, 1), "xz": (0, 2), "yy": (1, 1), "yz": (1, 2), "zz": (2, 2)}
    entries = " ".join(f'i{name}="{I[j][k]!r}"' for name, (j, k) in pairs.items())
    return (
        f'<inertial><origin xyz="{x!r} {y!r} {z!r}"/><mass value="{arm.number(body.mass)!r}"/>'
        f"<inertia {entries}/></inertial>"
    )


# Code


def _write_dh_numbers(arm: Arm, row: Row) -> list[str]:
    """Write angles such as pi/2 as formulas, and other entries as numbers."""
    return [
        entry
        if isinstance(entry, str) and not entry.replace("pi", "").strip("-+0123456789*/ .")
        else f"{arm.number(entry):.12g}"  # 12 digits remove round-off
        for entry in row.entries
    ]


def _write_robotics_toolbox(arm: Arm) -> str:
    lines = []
    for i, row in enumerate(arm.rows, 1):
        a, alpha, d, theta = _write_dh_numbers(arm, row)
        note = f"  # row {i} does not move: leave its q at 0" if row.joint.kind == "fixed" else ""
        if row.joint.kind == "prismatic":
            lines.append(f"    PrismaticDH(theta={theta}, a={a}, alpha={alpha}, offset={d}),")
        else:
            lines.append(f"    RevoluteDH(d={d}, a={a}, alpha={alpha}, offset={theta}),{note}")
    moving = [i - 1 for i in arm.joints]
    return "\n".join([
        "import numpy as np",
        "from math import pi",
        "from roboticstoolbox import DHRobot, PrismaticDH, RevoluteDH",
        "",
        "robot = DHRobot([",
        *lines,
        f"], name={arm.name!r})",
        f"moving = {moving}  # columns of the joints that move",
        f"q = np.zeros({len(arm.rows)})",
        "T = robot.fkine(q).A  # kinematics.forward_kinematics(arm, q)",
        "J = robot.jacob0(q)[:, moving]  # kinematics.jacobian(arm, q): tip, base axes, v above w",
        "J_tool = robot.jacobe(q)[:, moving]  # jacobian(arm, q, 'tool')",
        'J_rpy = robot.jacob0_analytical(q, representation="rpy/zyx")[:, moving]  # angle rates',
        "",
    ])  # fmt: skip


def _write_matlab(arm: Arm) -> str:
    lines = []
    for i, row in enumerate(arm.rows, 1):
        a, alpha, d, theta = _write_dh_numbers(arm, row)
        if row.joint.kind == "prismatic":
            fields = f"'theta', {theta}, 'a', {a}, 'alpha', {alpha}, 'offset', {d}"
            lines.append(f"L({i}) = Prismatic({fields});")
        else:
            fields = f"'d', {d}, 'a', {a}, 'alpha', {alpha}, 'offset', {theta}"
            note = f"  % row {i} does not move: leave its q at 0" if i not in arm.joints else ""
            lines.append(f"L({i}) = Revolute({fields});{note}")
    name = arm.name.replace("'", "''")
    return "\n".join([
        *lines,
        f"robot = SerialLink(L, 'name', '{name}');",
        f"moving = {[*arm.joints]};  % columns of the joints that move",
        f"q = zeros(1, {len(arm.rows)});",
        "T = robot.fkine(q)  % kinematics.forward_kinematics(arm, q)",
        "J = robot.jacob0(q); J = J(:, moving)  % kinematics.jacobian(arm, q)",
        "J_tool = robot.jacobe(q); J_tool = J_tool(:, moving)"
        "  % jacobian(arm, q, 'tool')",
        "J_rpy = robot.jacob0(q, 'rpy'); J_rpy = J_rpy(:, moving)  % rates of roll, pitch and yaw",
        "",
    ])  # fmt: skip


def _write_array(array: np.ndarray) -> str:
    """Write a matrix with numbers of 12 decimals, which removes round-off."""
    rows = (", ".join(repr(float(x)) for x in row) for row in array.round(12) + 0.0)
    return "[" + ",\n    ".join(f"[{row}]" for row in rows) + "]"


def _write_modern_robotics(arm: Arm) -> str:
    # Screw axes (w, v) of the joints at q = 0 in the base frame.
    frames, screws = link_frames(arm, np.zeros(arm.dof)), []
    for i, is_revolute in zip(arm.joints, arm.turning, strict=True):
        z, point = frames[i - 1, :3, 2], frames[i - 1, :3, 3]
        screws.append([*z, *np.cross(point, z)] if is_revolute else [0, 0, 0, *z])
    return "\n".join([
        "import numpy as np",
        "import modern_robotics as mr",
        "",
        f"M = np.array({_write_array(forward_kinematics(arm, np.zeros(arm.dof)))})",
        f"Slist = np.array({_write_array(np.array(screws).T)})",
        f"q = np.zeros({arm.dof})",
        "T = mr.FKinSpace(M, Slist, q)  # kinematics.forward_kinematics(arm, q)",
        "J_space = mr.JacobianSpace(Slist, q)  # w above v, v of the point at the base's origin",
        "Blist = mr.Adjoint(mr.TransInv(M)) @ Slist",
        "J_body = mr.JacobianBody(Blist, q)  # w above v, of the tip in its own axes",
        "R = T[:3, :3]",
        "J = np.vstack([R @ J_body[3:], R @ J_body[:3]])  # kinematics.jacobian(arm, q)",
        "J_tool = J_body[[3, 4, 5, 0, 1, 2]]  # jacobian(arm, q, 'tool')",
        "",
    ])  # fmt: skip


def _write_pinocchio(arm: Arm) -> str:
    return "\n".join([
        "import numpy as np",
        "import pinocchio as pin",
        "",
        f"URDF = '''{write_urdf(arm)}'''",
        "model = pin.buildModelFromXML(URDF)",
        "data = model.createData()",
        f"q = np.zeros({arm.dof})",
        "# A joint without limits has two numbers in Pinocchio: its cosine and its sine.",
        "full = pin.neutral(model)",
        "for joint, value in zip(list(model.joints)[1:], q):",
        "    number = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]",
        "    full[joint.idx_q : joint.idx_q + joint.nq] = number",
        "pin.framesForwardKinematics(model, data, full)",
        'tool = model.getFrameId("tool", pin.BODY)',
        "T = data.oMf[tool].homogeneous  # kinematics.forward_kinematics(arm, q)",
        "J = pin.computeFrameJacobian(",
        "    model, data, full, tool, pin.LOCAL_WORLD_ALIGNED",
        ")  # kinematics.jacobian(arm, q)",
        "J_tool = pin.computeFrameJacobian(",
        "    model, data, full, tool, pin.LOCAL",
        ")  # kinematics.jacobian(arm, q, 'tool')",
        "J_space = pin.computeFrameJacobian(",
        "    model, data, full, tool, pin.WORLD",
        ")  # v above w, v of the point at the base's origin",
        "g = pin.computeGeneralizedGravity(model, data, full)  # statics.gravity_torque(arm, q)",
        "",
    ])  # fmt: skip


def _write_sympy(arm: Arm) -> str:
    rows = []
    for i, row in enumerate(arm.rows, 1):
        a, alpha, d, theta = (str(entry) for entry in row.entries)
        if row.joint.kind == "revolute":
            theta = f"q_{i} + {theta}" if theta != "0" else f"q_{i}"
        if row.joint.kind == "prismatic":
            d = f"q_{i} + {d}" if d != "0" else f"q_{i}"
        rows.append(f"    ({a}, {alpha}, {d}, {theta}),")
    symbols = [f"q = {', '.join(arm.variables)}, = sp.symbols({list(arm.variables)!r})"]
    if arm.values:
        symbols.append(f"{', '.join(arm.values)}, = sp.symbols({list(arm.values)!r})")
    return "\n".join([
        "import sympy as sp",
        "from sympy import pi",
        "",
        *symbols,
        "rows = [  # a, alpha, d, theta",
        *rows,
        "]",
        "",
        "",
        "def link(a, alpha, d, theta):",
        "    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)",
        "    return sp.Matrix(",
        "        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s],"
        " [0, sa, ca, d], [0, 0, 0, 1]]",
        "    )",
        "",
        "",
        "T = sp.eye(4)  # symbolic.forward_kinematics(arm)",
        "for row in rows:",
        "    T = T * link(*row)",
        "R = T[:3, :3]",
        "columns = []  # symbolic.jacobian(arm)",
        "for variable in q:",
        "    S = R.diff(variable) * R.T",
        "    columns.append(sp.Matrix([*T[:3, 3].diff(variable), S[2, 1], S[0, 2], S[1, 0]]))",
        "J = sp.Matrix.hstack(*columns)",
        f"numbers = {dict(arm.values)!r}  # J.subs(numbers) has the arm's lengths",
        "",
    ])  # fmt: skip


_WRITERS: dict[str, Callable[[Arm], str]] = {
    "robotics toolbox": _write_robotics_toolbox,
    "matlab": _write_matlab,
    "modern robotics": _write_modern_robotics,
    "pinocchio": _write_pinocchio,
    "sympy": _write_sympy,
}
