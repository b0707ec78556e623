"""A serial arm out of a robot description (URDF): its joint axes at q = 0, and from them its table.

The chain from one link of the tree to another is read with its limits, speeds, efforts, masses and
centres of mass. Fixed joints are folded in, and so are the masses of whatever is fastened to the
chain at its side. The file is data: only `xml.etree` of the standard library touches it, a document
type (which could hide an entity bomb or another file) is refused, and nothing that it names is
opened. Source of the format: the URDF XML specification,
wiki.ros.org/urdf/XML (elements joint, link and inertial).
"""

from helpers.urdf.chain import from_urdf

__all__ = ["from_urdf"]
