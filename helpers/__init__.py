"""Compute with robot arms from DH tables, for all notebooks of the book."""
