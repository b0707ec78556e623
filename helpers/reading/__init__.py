"""What people type or paste, read: formulas, grids of numbers, tables. Nothing is ever evaluated as
code.
"""
