"""A build backend that builds nothing: it tells whoever has an old Python which one is needed."""

import sys

version = ".".join(map(str, sys.version_info[:2]))
sys.exit(f"This book needs Python 3.11 or newer; this is Python {version} ({sys.executable}).")
