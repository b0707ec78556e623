"""An answer judged: its credit and the checkers' words."""
