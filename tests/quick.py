"""`pytest -p tests.quick`: every process of a test run starts a second earlier, or two.

nbformat, which nbval imports, imports jsonschema, which imports rfc3987-syntax where it finds it,
and that builds a grammar of all web addresses. No notebook is checked for those: jsonschema goes
without, as it does where rfc3987-syntax is not installed.
"""

import sys

sys.modules["rfc3987_syntax"] = None  # type: ignore[assignment]
