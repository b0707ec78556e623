"""Right answers as people and tools write them, drawn by seed, and twins with one mistake."""
