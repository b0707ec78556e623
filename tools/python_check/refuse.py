"""Refuse to build with a Python that is too old."""

import sys

version = ".".join(map(str, sys.version_info[:2]))
sys.exit(f"This book needs Python 3.11 or newer; this is Python {version} ({sys.executable}).")
