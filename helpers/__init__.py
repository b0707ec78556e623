"""What the book's notebooks share: one table for each arm, and everything that follows from it."""
