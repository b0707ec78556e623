"""What only the instructor knows: seeds and signatures from a course secret.

Both are HMAC-SHA-256 (RFC 2104): who lacks the secret can neither draw another student's numbers
nor change a stored sheet unnoticed, however many sheets were seen.
"""

import hashlib
import hmac
import json
from pathlib import Path
from typing import Any

from helpers.inputs import ArmError, shown

_FEWEST = 16  # bytes: fewer could be guessed


def read_secret(path: str | Path) -> bytes:
    """The secret in a file, without the white space around it.

    Raises ArmError for a file that is not there and for a secret of fewer than 16 bytes.
    """
    try:
        secret = Path(path).read_bytes().strip()
    except OSError as error:
        raise ArmError(
            f"secret file {str(path)!r} cannot be read ({error.strerror}); expected a file of"
            f" {_FEWEST} bytes or more, such as `python -c 'import secrets;"
            " print(secrets.token_hex())'` prints"
        ) from None
    if len(secret) < _FEWEST:
        raise ArmError(
            f"the secret in {str(path)!r} has {len(secret)} bytes; expected {_FEWEST} or more"
        )
    return secret


def seed(secret: bytes, student: str, course: str) -> str:
    """The seed of a student's sheet: 64 hexadecimal digits."""
    if not isinstance(student, str) or not student:
        raise ArmError(f"student id is {shown(student)}; expected a word")
    return _mac(secret, "seed", course, student)


def signature(secret: bytes, student: str, content: Any) -> str:
    """What shows that a stored sheet is the one that was drawn: 64 hexadecimal digits."""
    return _mac(secret, "sheet", student, json.dumps(content, sort_keys=True))


def is_signed(secret: bytes, student: str, content: Any, given: str) -> bool:
    """Whether a signature belongs to this student's content, compared in constant time."""
    return hmac.compare_digest(signature(secret, student, content), str(given))


def _mac(secret: bytes, *parts: str) -> str:
    """Each part goes in with its length, so that no two lists of parts look alike."""
    text = b"".join(b"%d:%s" % (len(part), part) for part in (p.encode() for p in parts))
    return hmac.new(secret, text, hashlib.sha256).hexdigest()
