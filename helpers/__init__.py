"""Compute with robot arms from DH tables, for all notebooks of the book."""

__version__ = "5.0.0"  # CITATION.cff and CHANGELOG.md name it too; a test holds them equal
