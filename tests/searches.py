"""List searches of readers, and what must come first for each.

A result is a regular expression for ``page: section``: this page must come first, with this section
among the three that are shown of it. The first two lists were written before the code that they
test.
"""

SEARCHES = {
    # searches that the request for this feature named
    "UR10e Jacobian": r"answers/ur10e.*: Jacobian|02_jacobian: The UR10e",
    "8 IK solutions": r"05_.*: (The UR10e|Eight arms)",
    "why does my circle fail": r"check_your_homework: My circle|03_.*: (A mistake atlas|Tracing)",
    "elbow up": r"05_.*: |glossary: elbow",
    "slip 19": r"(errata|02_.*|03_.*): (Slip )?19 ?",
    # tables
    "Panda DH table": r"01_.*: The Panda|answers/panda.*: Table",
    "UR10e DH table": r"01_.*: The UR10e|answers/ur10e.*: Table",
    "modified DH": r"01_.*: The maker.*modified|glossary: modified DH|conventions: ",
    "Craig convention": r"conventions: |further/other_jacobians: From a table in Craig"
    r"|glossary: modified DH|01_.*: The maker.*modified",
    "how to place the frames": r"01_.*: Placing the frames",
    "is my table wrong": r"01_.*: Is my table wrong|check_your_homework: Your table",
    "Stanford arm table": r"01_.*: The Stanford|answers/stanford.*: Table",
    "homogeneous transform": r"glossary: homogeneous|01_.*: ",
    # Jacobians
    "lock joint 3": (
        r"02_.*: The Panda|01_.*: The Panda with joint 3|answers/panda_joint_3.*"
        r"|errata: 3 "
    ),
    "singularities": r"02_.*: (Where an arm is|How near)",
    "singular pose": r"02_.*: (Where an arm is|How near|Into)|glossary: singular",
    "cross product": r"02_.*: Method 1|where: Jacobians",
    "prismatic joint jacobian": r"02_.*: The Stanford|glossary: prismatic",
    "manipulability": r"02_.*: How near|glossary: manip",
    "rank of the jacobian": r"02_.*|errata: 10 ",
    "euler angle rates": r"further/other_jacobians: Rates of |glossary: ",
    "jacobain": r"02_.*|glossary: Jacobian",  # misspelt
    "compare_jacobian": r"check_your_homework: Your Jacobian|api: compare_jacobian",
    # circles
    "damped least squares": r"03_.*: |glossary: damped",
    "pseudo-inverse": r"03_.*: |glossary: pseudo",
    "euler step size error": r"03_.*: (How the error|The Panda.s circle traced)",
    "joint limits": (
        r"03_.*: (The Panda.s joints|The real Panda|Rates that)|robot_data"
        r"|check_.*: A joint|glossary: joint limit"
    ),
    "feedback gain": r"03_.*: Feedback",
    # torques
    "gravity torque": r"04_.*|glossary: gravity|answers/.*: Gravity",
    "centre of mass": r"04_.*: Where the masses|glossary: centre of mass|errata: 7 ",
    "center of mass frame": r"04_.*: Where the masses|glossary: centre of mass|errata: 7 ",
    "payload": r"further/dynamics: What a payload",
    "sign of the force": r"04_.*|conventions: Wrenches|02_.*: The same matrix for forces",
    "does the energy add up": r"04_.*: Does the energy",
    # inverse kinematics
    "ik": r"05_.*: |glossary: inverse|check_.*: My inverse|where: Inverse",
    "wrist center": r"05_.*: The Stanford arm: position|glossary: wrist",
    "atan2": r"glossary: atan2|05_.*: |errata: 13 ",
    "Stanford inverse kinematics": r"05_.*: The Stanford arm: position|where: Inverse",
    "target out of reach": r"05_.*: The elbow arm.s reach|glossary: (reach|workspace)",
    # other topics
    "UR10 lengths": r"errata: 9 |robot_data: |01_.*: (The maker|Slip 9)",
    "mm or m": r"intro: Before you start|check_your_homework: ",
    "my own robot": r"(own_arm|check_your_homework): An arm of your own",
    "URDF": r"api: .*urdf|own_arm: A robot description",
    "grade a class": r"instructors: ",
    "product of exponentials": r"conventions: From a table",
}

# Students' searches: from titles of questions on public sites and the tasks of the homework.
STUDENT_SEARCHES = {
    # tables
    "dh parameters": r"01_dh_tables: ",
    "how to assign frames for dh": r"01_dh_tables: .*[Ff]rames",
    "panda dh table": r"01_dh_tables: The Panda",
    "standard vs modified dh": r"further/your_table: Standard and modified|conventions: Tables",
    "which way does z axis point": r"01_dh_tables: ",
    "forward kinematics": r"01_dh_tables: |glossary: forward",
    "transformation matrix from base to end effector": r"01_dh_tables: ",
    "is my dh table correct": r"01_.*: Is my table wrong|check_.*: (Your table|My table)",
    "a3 0.0825 or 0.088": r"errata: 2 |01_dh_tables: The Panda",
    "pen length": r"01_dh_tables: ",
    # Jacobians
    "jacobian": r"02_jacobian: ",
    "6x6": r"02_jacobian: The Panda",
    "panda lock joint 3 jacobian": r"02_jacobian: The Panda",
    "delete row or column": r"02_jacobian: The Panda|errata: 3 ",
    "jacobian of prismatic joint": r"02_jacobian: The Stanford",
    "how to find singularities": r"02_jacobian: Where an arm is singular",
    "singular matrix error": r"check_.*: My circle fails|02_jacobian: |03_.*: The UR10e",
    "angular velocity vs euler angle rates": r"further/other_jacobians: Rates of Euler",
    "z0 to z6 or z1 to z7": r"errata: 19 |02_jacobian: |where: Jacobians",
    "det(J) = 0": r"02_jacobian: (Where an arm is|How near|A block)",
    # the circle
    "why is my circle not closing": r"check_your_homework: My circle does not close",
    "euler integration drift": (
        r"03_circle_tracing: (The Panda.s circle traced|How the error"
        r"|Feedback)"
    ),
    "how many steps N": (
        r"03_circle_tracing: (How the error|The Panda.s circle traced"
        r"|Exercise 3.1)"
    ),
    "ur10e home position singular": r"03_circle_tracing: The UR10e|02_jacobian: The UR10e",
    "pinv": r"03_circle_tracing: The UR10e",
    "joint limits exceeded": r"check_your_homework: A joint turns|03_circle_tracing: ",
    "pen tilts": r"check_your_homework: My circle looks round",
    # torques
    "torque from gravity": r"04_static_torque: ",
    "tau = g - J^T F": r"04_static_torque: |02_jacobian: The same matrix",
    "center of mass of panda links": r"04_static_torque: Where the masses|robot_data: ",
    "my torques are wrong": r"check_your_homework: (My torques|Your torques)",
    "5 N force on the wall": r"04_static_torque: ",
    # inverse kinematics
    "inverse kinematics": r"05_inverse_kinematics: ",
    "how many solutions does ur10e have": r"05_inverse_kinematics: (The UR10e|Eight)",
    "elbow up elbow down": r"05_inverse_kinematics: ",
    "arctan or atan2": r"glossary: atan2|05_inverse_kinematics: |errata: 13 ",
    # other arms, other programs
    "ur5": r"own_arm: ",
    "kuka": r"own_arm: ",
    "robotics toolbox matlab": r"other_programs: |conventions: ",
    "check my answer": r"check_your_homework: ",
}

# Terms and students' names for them: the first result must be the definition in the glossary.
TERM_SEARCHES = {
    "quaternion": r"glossary: quaternion",
    "gimbal lock": r"glossary: gimbal lock",
    "workspace": r"glossary: workspace",
    "reachable workspace": r"glossary: workspace",
    "skew symmetric matrix": r"glossary: skew-symmetric matrix",
    "theta offset": r"glossary: joint offset",
    "velocity of end effector": r"glossary: twist",
    "what is a slip": r"glossary: slip",
    "adjoint": r"glossary: adjoint",
    "null space": r"glossary: null space",
    "twist": r"glossary: twist",
    "tool center point": r"glossary: tip",
    "mass matrix": r"glossary: inertia matrix",
    "Newton-Raphson": r"glossary: Newton.s method",
    "home position": r"glossary: home configuration",
    "rotation matrix": r"glossary: rotation matrix",
    "space Jacobian": r"glossary: body Jacobian",
    "velocity limit": r"glossary: joint limit",
    "degrees of freedom": r"glossary: degree of freedom",
    "configuration": r"glossary: configuration",
    "pose": r"glossary: pose",
    "T07": r"01_dh_tables: ",
}
