"""What installs a missing library names where kurbel came from, never its bare name."""

from __future__ import annotations

import json
import re
import sys
from dataclasses import dataclass

import pytest
from places import ROOT

from kurbel.reading import environment


@dataclass
class Installed:
    """A distribution as an installer leaves it."""

    noted: object
    requires: tuple[str, ...] = ("click>=8.2", "typst>=0.15; extra == 'pdf'", "pint>=0.24 ; extra == 'units'")

    def read_text(self, name: str) -> str | None:
        assert name == "direct_url.json"
        return None if self.noted is None else json.dumps(self.noted)


@pytest.mark.parametrize(
    ("noted", "words"),
    [
        ({"url": "file:///books/kurbel", "dir_info": {"editable": True}}, "--editable '/books/kurbel[pdf]'"),
        ({"url": "file:///my%20books/kurbel", "dir_info": {}}, "'/my books/kurbel[pdf]'"),
        (
            {"url": "https://host/kurbel.git", "vcs_info": {"vcs": "git", "commit_id": "4e1d"}},
            "'kurbel[pdf] @ git+https://host/kurbel.git@4e1d'",
        ),
        (
            {"url": "file:///w/kurbel-1-py3-none-any.whl", "archive_info": {}},
            "'kurbel[pdf] @ file:///w/kurbel-1-py3-none-any.whl'",
        ),
        (None, "'typst>=0.15'"),
    ],
)
def test_the_hint_names_where_kurbel_came_from(
    noted: object, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.metadata.distribution", lambda name: Installed(noted))
    assert environment.how_to_install("pdf") == f"{sys.executable} -m pip install {words}"


def test_without_pip_it_is_uv(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(environment, "find_spec", lambda name: None)
    monkeypatch.setattr("importlib.metadata.distribution", lambda name: Installed(None))
    assert environment.how_to_install("units") == f"uv pip install --python {sys.executable} 'pint>=0.24'"


def test_windows_has_double_quotes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kurbel.reading.environment.os.name", "nt")
    assert environment._quoted("C:\\Program Files\\kurbel[pdf]") == '"C:\\Program Files\\kurbel[pdf]"'
    assert environment._quoted("--editable") == "--editable"


def test_nothing_tells_to_install_the_bare_name() -> None:
    folders = ("src", "docs", "examples", "templates")
    files = [ROOT / "README.md", ROOT / "action.yml"]
    files += [path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in TEXT]
    for path in files:
        text = path.read_text(encoding="utf-8")
        for line in text.splitlines():
            if "install" in line:
                assert not BARE.search(line), (path, line)


# install kurbel, install 'kurbel[pdf]', install kurbel==0.1.0; not kurbel[pdf] @ https://…
BARE = re.compile(r"install\s+(?:-\S+\s+)*['\"]?kurbel(?:\[[\w,]*\])?(?!\s*@)(?:==|['\"`\s]|$)")
TEXT = {".py", ".md", ".toml", ".txt", ".yml"}
