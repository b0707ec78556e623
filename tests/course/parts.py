"""Mark numbers of a part with a number of decimals, and pack files into a zip."""

import io
import zipfile

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


def make_zip(files):
    """Return a zip of files, which are given by their names."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return packed.getvalue()
