"""Keep pytest from importing a slow grammar that no test needs.

nbformat imports jsonschema, which imports rfc3987_syntax where it is installed, to check the format
"iri". That import takes 3 s of processor time, and no schema of a notebook has such a format.
"""

import sys

# None makes the import raise ModuleNotFoundError, as if the package were not installed.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
