"""Mark the numbers of a part after rounding them to a number of decimals."""

import numpy as np

from course.marking import mark_part

MEASURED = ("numbers", "rotation", "jacobian", "torques")


def list_measured_parts(own):
    """List the parts of a sheet whose answers are numbers."""
    return [part for part in own.parts.values() if part.kind in MEASURED]


def as_text(numbers, digits):
    """Write numbers as text with this number of decimals."""
    return np.vectorize(lambda x: f"{x:.{digits}f}")(numbers).tolist()


def mark_text(own, part, numbers, digits):
    """Mark numbers that are written with this number of decimals."""
    return mark_part(own, part.name, as_text(numbers, digits))
