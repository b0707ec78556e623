"""List search words of readers and the expected first result of each.

A result is a regular expression for ``page: section``. The list was written before the search was
built.
"""

SEARCHES = {
    # named in the request for the search
    "UR10e Jacobian": r"answers/ur10e.*: Jacobian|02_jacobian: The UR10e",
    "8 IK solutions": r"05_.*: (The UR10e by hand|Eight arms)",
    "why does my circle fail": r"check_your_homework: My circle|03_.*: (A mistake atlas|Tracing)",
    "elbow up": r"05_.*: |glossary: elbow",
    "slip 19": r"errata: 19 ",
    # tables
    "Panda DH table": r"01_.*: The Panda|answers/panda.*: Table",
    "UR10e DH table": r"01_.*: The UR10e|answers/ur10e.*: Table",
    "modified DH": r"01_.*: The maker.*modified|glossary: modified DH|conventions: ",
    "Craig convention": r"conventions: |glossary: modified DH|01_.*: The maker.*modified",
    "how to place the frames": r"01_.*: Placing the frames",
    "is my table wrong": r"01_.*: Is my table wrong|check_your_homework: Your table",
    "Stanford arm table": r"01_.*: The Stanford|answers/stanford.*: Table",
    "homogeneous transform": r"glossary: homogeneous|01_.*: ",
    # Jacobians
    "lock joint 3": r"02_.*: The Panda|01_.*: Joint 3 locked|answers/panda_joint_3.*|errata: 3 ",
    "singularities": r"02_.*: (Where an arm is|How near)",
    "singular pose": r"02_.*: (Where an arm is|How near|Into)|glossary: singular",
    "cross product": r"02_.*: Method 1|where: Jacobians",
    "prismatic joint jacobian": r"02_.*: The Stanford|glossary: prismatic",
    "manipulability": r"02_.*: How near|glossary: manip",
    "rank of the jacobian": r"02_.*|errata: 10 ",
    "euler angle rates": r"02_.*: Rates of |glossary: ",
    "compare_jacobian": r"check_your_homework: Your Jacobian|api: compare_jacobian",
    # circles
    "damped least squares": r"03_.*: |glossary: damped",
    "pseudo-inverse": r"03_.*: |glossary: pseudo",
    "euler step size error": r"03_.*: (How the error|The Euler)",
    "joint limits": r"03_.*: (The joints that|The way out)|robot_data|check_.*: A joint turns",
    "feedback gain": r"03_.*: Feedback",
    # torques
    "gravity torque": r"04_.*|glossary: gravity|answers/.*: Gravity",
    "centre of mass": r"04_.*: Where the masses|glossary: centre of mass|errata: 7 ",
    "center of mass frame": r"04_.*: Where the masses|glossary: centre of mass|errata: 7 ",
    "payload": r"04_.*: What a payload",
    "sign of the force": r"04_.*|conventions: Wrenches|02_.*: The same matrix for forces",
    "does the energy add up": r"04_.*: Does the energy",
    # inverse kinematics
    "ik": r"05_.*: |glossary: inverse|check_.*: My inverse|where: Inverse",
    "wrist center": r"05_.*: A spherical wrist|glossary: wrist",
    "atan2": r"05_.*: |errata: 13 ",
    "Stanford inverse kinematics": r"05_.*: A spherical wrist|where: Inverse",
    "target out of reach": r"05_.*: Where branches|glossary: (reach|workspace)",
    # the rest
    "UR10 lengths": r"errata: 9 |robot_data: |01_.*: The maker",
    "mm or m": r"errata: 26 ",
    "my own robot": r"check_your_homework: An arm of your own",
    "URDF": r"api: .*urdf|check_your_homework: An arm of your own",
    "grade a class": r"instructors: ",
    "product of exponentials": r"conventions: From a table",
}
