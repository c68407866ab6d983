"""The GitHub Action, the hooks for pre-commit and what docs/howto/ci.md shows, run as far as that goes."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import pytest
import yaml
from cli import kurbel
from conftest import pytest_configure
from places import ROOT
from pre_commit.clientlib import load_manifest
from tools import require

from kurbel import __version__
from kurbel.formats.registry import kinds

GUIDE = (ROOT / "docs" / "howto" / "ci.md").read_text(encoding="utf-8")
ACTION = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
HOOKS = load_manifest(ROOT / ".pre-commit-hooks.yaml")
MANIFEST = """
title = "Tables"
formats = ["csv", "markdown"]
[[chapter]]
title = "Motion"
[[chapter.part]]
run = "table --ratio 1:5 --angle 30"
name = "motion"
"""
WORKFLOW = (ROOT / ".github" / "workflows" / "tests.yml").read_text(encoding="utf-8")
# pip would fetch half of Python: that step was run by hand, and the wheel has a test of its own.
NOT_RUN = {"Install kurbel"}


def environment() -> dict[str, str]:
    """Return the environment of a job, in which python and kurbel are those of the tests."""
    clean = {name: value for name, value in os.environ.items() if "KURBEL" not in name}
    return clean | {"PATH": f"{Path(sys.executable).parent}:{clean['PATH']}"}


def expanded(text: str, inputs: dict[str, str]) -> str:
    """Return what GitHub makes of a value with expressions."""
    values = {f"inputs.{name}": one["default"] for name, one in ACTION["inputs"].items()}
    values |= {"github.action_path": str(ROOT)} | {f"inputs.{name}": one for name, one in inputs.items()}
    return re.sub(r"\$\{\{ (\S+) \}\}", lambda found: values[found[1]], text)


def act(place: Path, **inputs: str) -> subprocess.CompletedProcess[str]:
    """Run the steps of the action in the folder, as GitHub runs bash, up to the one that fails."""
    job = environment() | {"GITHUB_STEP_SUMMARY": str(place / "summary.md")}
    done = None
    for step in ACTION["runs"]["steps"]:
        if "run" in step and step["name"] not in NOT_RUN:
            assert "${{" not in step["run"]
            given = {name: expanded(value, inputs) for name, value in step["env"].items()}
            done = subprocess.run(
                ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]],
                cwd=place, env=job | given, capture_output=True, encoding="utf-8", check=False,
            )  # fmt: skip
            if done.returncode:
                break
    assert done is not None
    return done


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a handbook and a document, both as they should be."""
    folder = tmp_path_factory.mktemp("built")
    (folder / "appendix").mkdir()
    (folder / "appendix" / "handbook.toml").write_text(MANIFEST)
    text = "# Notes\n\n<!-- kurbel: table --ratio 1:5 --angle 30 -->\n<!-- /kurbel -->\n"
    (folder / "the notes.md").write_text(text)
    assert kurbel("handbook", "build", str(folder / "appendix"), "--jobs", "1").code == 0
    assert kurbel("inject", str(folder / "the notes.md")).code == 0
    return folder


@pytest.fixture
def job(built: Path, tmp_path: Path) -> Path:
    """A copy of that folder, to be spoilt."""
    return shutil.copytree(built, tmp_path / "job")


def spoil(file: Path) -> None:
    """Change a digit of the path at 30°."""
    text = file.read_text(encoding="utf-8")
    assert "1590" in text
    file.write_text(text.replace("1590", "1591"), encoding="utf-8")


def test_the_action_passes_where_all_is_fresh(job: Path) -> None:
    done = act(job, folder="appendix\n", files="*.md\n")
    assert (done.returncode, done.stderr) == (0, "")
    assert "what the manifest says" in done.stdout
    assert "the notes.md" in done.stdout
    assert "::error" not in done.stdout
    assert not (job / "summary.md").exists()


def test_the_action_fails_for_what_is_stale_or_wrong_and_marks_the_line(job: Path) -> None:
    """A page and a document that were changed by hand, manifests that were changed, and mistakes."""
    for name, old, new in (("changed", "--angle 30", "--angle 60"), ("wrong", "1:5", "5:1")):
        shutil.copytree(job / "appendix", job / name)
        (job / name / "handbook.toml").write_text(MANIFEST.replace(old, new))
    spoil(job / "appendix" / "pages" / "tables" / "motion.csv")
    spoil(job / "the notes.md")
    (job / "other.md").write_text("\n<!-- kurbel: tabel -->\n<!-- /kurbel -->\n")
    done = act(job, folder="appendix\nchanged\nwrong", files="*.md")
    assert done.returncode == 1
    assert "appendix/pages/tables/motion.csv: differs\n" in done.stdout
    assert re.search(r"^-\|.*1591", done.stdout, re.MULTILINE)
    marks = [line for line in done.stdout.splitlines() if line.startswith("::error")]
    for place in (
        # A header and the row of the one angle.
        "appendix/pages/tables/motion.csv,line=2",
        # Of what a page is no longer made, or cannot be.
        *(
            "changed/handbook.toml,line=7",
            "wrong/handbook.toml,line=7",
            "the notes.md,line=3",
            "other.md,line=2",
        ),
    ):
        assert sum(mark.startswith(f"::error file={place}::") for mark in marks) == 1, place
    assert not any("file=changed/pages" in mark for mark in marks)
    assert any(mark.startswith("::error title=kurbel::the notes.md is stale") for mark in marks)
    assert any(mark.endswith("kurbel handbook build appendix") for mark in marks)
    summary = (job / "summary.md").read_text(encoding="utf-8")
    assert "    appendix/pages/tables/motion.csv: differs\n" in summary


def test_what_inputs_and_documents_say_is_no_command(job: Path) -> None:
    hostile = "$(touch evil)\n`touch evil`\n; touch evil\n' touch evil '\n-h"
    spoil(job / "the notes.md")
    text = (job / "the notes.md").read_text(encoding="utf-8")
    begin = text.index("-->") + 3
    (job / "the notes.md").write_text(f"{text[:begin]}\n::error::100%25\n{text[begin:]}", encoding="utf-8")
    done = act(job, folder=hostile, files=f"{hostile}\nthe notes.md")
    assert done.returncode == 1
    assert not (job / "evil").exists()
    # GitHub cuts the blanks off a line, and sees no command before the token.
    shown, stopped = [], ""
    for line in done.stdout.splitlines():
        if found := re.fullmatch(r"::stop-commands::(\w{32})", line):
            stopped = f"::{found[1]}::"
        elif line == stopped:
            stopped = ""
        elif not stopped:
            shown.append(line)
    assert shown
    assert all(re.match(r"::error (title=kurbel|file=[\w ./]+,line=\d+)::", line) for line in shown)
    assert not any(line.startswith("::error::") for line in shown)


def test_an_action_without_anything_to_check_fails(job: Path) -> None:
    done = act(job)
    assert (done.returncode, done.stderr) == (2, "")
    assert "name a handbook" in done.stdout


def test_every_input_of_the_action_is_used_and_described() -> None:
    text = (ROOT / "action.yml").read_text(encoding="utf-8")
    for name, one in ACTION["inputs"].items():
        assert re.search(rf"inputs\.{name}\b", text), name
        assert f"| `{name}` |" in GUIDE
        assert one["description"]
    assert {step["shell"] for step in ACTION["runs"]["steps"] if "run" in step} == {"bash"}
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert set(ACTION["inputs"]["extras"]["default"].split(",")) <= set(extras["optional-dependencies"])


def test_hooks_take_the_documents_that_inject_knows() -> None:
    inject = next(hook for hook in HOOKS if hook["id"] == "kurbel-inject")
    suffixes = [suffix for _, kind in kinds() for suffix in kind.suffixes]
    assert all(re.search(inject["files"], f"notes{suffix}") for suffix in suffixes)
    assert all(re.search(inject["files"], f"NOTES{suffix.upper()}") for suffix in suffixes)
    assert not re.search(inject["files"], "md.py")


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: str(hook["id"]))
def test_a_hook_runs_what_it_says(hook: dict[str, Any], job: Path) -> None:
    assert f"`{hook['id']}`" in GUIDE
    program, *words = hook["entry"].split()
    target = job / "the notes.md" if hook["pass_filenames"] else job / "appendix"
    assert program == "kurbel"
    assert kurbel(*words, str(target)).code == 0


def snippet(heading: str, language: str) -> str:
    """Return the first block of code in a section of the guide."""
    section = GUIDE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    found = re.search(rf"```{language}\n(.*?)```", section, re.DOTALL)
    assert found
    return found[1]


def made(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [require("make"), *words], cwd=folder, env=environment(), capture_output=True, encoding="utf-8",
        check=False,
    )  # fmt: skip


def test_the_rules_for_make_build_once_and_check(job: Path) -> None:
    (job / "Makefile").write_text(snippet("Make", "make"), encoding="utf-8")
    assert "kurbel handbook build appendix" in made(job).stdout
    assert ": 0 written" in made(job).stderr
    assert made(job, "check").returncode == 0
    spoil(job / "appendix" / "pages" / "tables" / "motion.csv")
    assert made(job, "check").returncode == 2
    # A build that fails is not taken for done.
    (job / "appendix" / "handbook.toml").write_text(MANIFEST.replace("1:5", "5:1"))
    assert made(job).returncode == 2
    assert made(job).returncode == 2


def test_the_job_for_gitlab_runs_and_keeps_what_differs(job: Path) -> None:
    (one,) = yaml.safe_load(snippet("GitLab", "yaml")).values()
    script = "\n".join(one["script"])

    def run() -> int:
        return subprocess.run(
            ["sh", "-e", "-c", script], cwd=job, env=environment(), capture_output=True, check=False
        ).returncode

    assert run() == 0
    spoil(job / "appendix" / "pages" / "tables" / "motion.csv")
    assert run() == 1
    assert [*map(Path, one["artifacts"]["paths"])] == [Path("stale.diff")]
    assert "+1:5,30,0.1590" in (job / "stale.diff").read_text(encoding="utf-8")


def test_the_workflow_of_the_guide_uses_inputs_that_there_are() -> None:
    (work,) = yaml.safe_load(snippet("GitHub", "yaml"))["jobs"].values()
    assert set(work["steps"][-1]["with"]) <= set(ACTION["inputs"])
    hooks = yaml.safe_load(snippet("pre-commit", "yaml"))["repos"][0]["hooks"]
    assert {hook["id"] for hook in hooks} <= {hook["id"] for hook in HOOKS}


def test_versions_of_kurbel_in_the_documentation_are_that_of_the_package() -> None:
    for page in (ROOT / "docs").rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        named = {*re.findall(r"(?:kurbel(?:@v|:|==)|rev: v)(\d+\.\d+\.\d+)", text)}
        assert named <= {__version__}, f"sed -i 's/{named}/{__version__}/' {page.relative_to(ROOT)}"


@pytest.mark.slow  # two whole handbooks, built and checked
def test_the_pages_of_the_workflow_are_built_by_what_it_runs(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "examples", tmp_path / "examples", ignore=shutil.ignore_patterns("pages"))
    steps = yaml.safe_load(WORKFLOW)["jobs"]["pages"]["steps"]
    lines = [step["run"] for step in steps if "run" in step and step["name"] not in NOT_RUN]
    for line in lines:
        subprocess.run(["bash", "-eo", "pipefail", "-c", line], cwd=tmp_path, env=environment(), check=True)
    assert "Zusammenstellung 112" in (tmp_path / "page.html").read_text(encoding="utf-8")
    kept = steps[-1]["with"]["path"].split()
    assert len(kept) == 3
    assert all((tmp_path / path).exists() for path in kept)


def test_the_guide_shows_the_job_of_the_workflow() -> None:
    assert f"```yaml\njobs:\n{WORKFLOW[WORKFLOW.index('  pages:') :]}```\n" in GUIDE


def test_the_tests_of_the_workflow_are_those_of_every_other_ci() -> None:
    steps = yaml.safe_load(WORKFLOW)["jobs"]["tests"]["steps"]
    program, script = steps[-1]["run"].split()
    assert program == "bash"
    assert (ROOT / script).is_file()


def test_actions_of_others_are_pinned_by_hash() -> None:
    folder = ROOT / ".github" / "workflows"
    paths = (ROOT / "action.yml", *sorted(folder.iterdir()))
    files = (GUIDE, *(path.read_text(encoding="utf-8") for path in paths))
    used = re.findall(r"uses: (\S+)(.*)", "\n".join(files))
    others = [(name, comment) for name, comment in used if not name.startswith("OWNER/")]
    assert {name.partition("@")[0] for name, _ in others} == {
        f"actions/{name}" for name in ("checkout", "setup-python", "upload-artifact")
    }
    for name, comment in others:
        assert re.fullmatch(r"actions/[a-z-]+@[0-9a-f]{40}", name) and re.fullmatch(
            r" # v\d+(\.\d+)+", comment
        )


def test_in_ci_nothing_is_promoted(monkeypatch: pytest.MonkeyPatch) -> None:
    for ci, promoting, refused in (("true", "1", True), ("true", "", False), ("0", "1", False)):
        monkeypatch.setenv("CI", ci)
        monkeypatch.setenv("KURBEL_PROMOTE", promoting)
        with pytest.raises(pytest.UsageError) if refused else nullcontext():
            pytest_configure()


@pytest.mark.parametrize(
    ("target", "line"),
    [
        ("docs", "docs/generate/website.py build/site --playground"),
        ("golden", "git diff --stat --patch -- tests docs README.md examples/notes.md"),
    ],
)
def test_make_does_what_its_targets_promise(target: str, line: str) -> None:
    make = ["make", "--dry-run", "--always-make", target]
    done = subprocess.run(make, cwd=ROOT, env=environment(), capture_output=True, text=True, check=True)
    assert any(one.endswith(line) for one in done.stdout.splitlines())


def test_the_root_holds_nothing_that_a_program_left() -> None:
    if not (ROOT / ".git").exists():
        pytest.skip("need a checkout of git")
    listed = subprocess.run(["git", "ls-files", ":/*"], cwd=ROOT, capture_output=True, text=True, check=True)
    packed = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["hatch"]["build"]
    known = {*packed["targets"]["sdist"]["include"], "pyproject.toml", ".gitignore"}
    assert {line.partition("/")[0] for line in listed.stdout.splitlines()} <= known
