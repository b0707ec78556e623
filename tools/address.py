"""Say once where the repository is: `python tools/address.py https://github.com/OWNER/NAME`.

The address goes into the book's settings, from which the pages take their buttons, and into the
two files that others read without building anything.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
# A name that ends in .git is how the repository is cloned, not where it is.
ADDRESS = re.compile(r"https://github\.com/([\w-]+)/(?!\.+$)([\w.-]+)(?<!\.git)", re.ASCII)
SETTING = re.compile(r'(?m)^(repository:\n  url: )"([^"]*)"')


def setting(root: Path = ROOT) -> str:
    """The repository's address in the book's settings; empty if there is none."""
    return SETTING.search((root / "book/_config.yml").read_text(encoding="utf-8"))[2]


def pages(address: str) -> str:
    """Where GitHub publishes the book of this repository."""
    owner, name = ADDRESS.fullmatch(address).groups()
    site = f"{owner.lower()}.github.io"
    return f"https://{site}/" if name.lower() == site else f"https://{site}/{name}/"


def write(address: str, root: Path = ROOT) -> None:
    """Write the address wherever it must stand, in place of an earlier one; an empty one takes it
    away. ValueError, with nothing written, for what is none."""
    if address and not ADDRESS.fullmatch(address):
        raise ValueError(f"{address!r}: expected https://github.com/OWNER/NAME, without .git")
    _change(root / "book/_config.yml", lambda text: SETTING.sub(rf'\g<1>"{address}"', text))
    lines = f"repository-code: {address}\nurl: {pages(address)}\n" if address else ""
    _change(root / "CITATION.cff", lambda text: _without(text, r"repository-code|url") + lines)
    urls = f'\n[project.urls]\nBook = "{pages(address)}"\nSource = "{address}"\n' if address else ""
    _change(
        root / "pyproject.toml",
        lambda text: re.sub(
            r"(?ms)(?:\n\[project\.urls\]\n.*?)?(?=\n\[project\.optional-dependencies\])",
            urls,
            text,
            count=1,
        ),
    )


def _without(text: str, keys: str) -> str:
    return re.sub(rf"(?m)^(?:{keys}): .*\n", "", text)


def _change(path: Path, change) -> None:
    path.write_text(change(path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("say: python tools/address.py https://github.com/OWNER/NAME")
    try:
        write(sys.argv[1])
    except ValueError as error:
        sys.exit(str(error))
