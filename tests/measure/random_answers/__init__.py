"""Generate right answers as people and tools write them, and twins: the same with one mistake."""
