"""An arm to take by the joint: live in a running notebook and, without a kernel, in the built book."""

from helpers.explorer.widget import ArmExplorer

__all__ = ["ArmExplorer"]
