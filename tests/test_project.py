"""The project around the code: correct pages, pinned dependencies, nothing that holds on one machine only."""

from __future__ import annotations

import ast
import os
import re
import sys
import tomllib
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
PAGES = ("README.md", "README.pt-BR.md", "CONTRIBUTING.md")
FOLDERS = ("app", "robots", "lessons", "static", "tests", ".ci")
SINGLE_FILES = (*PAGES, "LICENSE", "Makefile", "constraints.txt", "pyproject.toml", ".gitignore")
# Character classes, so that the patterns do not match themselves.
OF_ONE_MACHINE = re.compile(
    r"/[h]ome/\w|/[U]sers/\w|/[r]oot/|[A-Z]:\\[U]sers"  # a user's folder
    r"|[p]ythonhosted|[p]ypi\.|--[i]ndex-url|--[f]ind-links|[r]egistry\.\w+\.\w"  # where packages came from
)
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
CONSTRAINTS = (ROOT / "constraints.txt").read_text("utf-8").splitlines()


def declared(*extras: str) -> list[Requirement]:
    lists = [PROJECT["dependencies"], *(PROJECT["optional-dependencies"][extra] for extra in extras)]
    return [Requirement(line) for lines in lists for line in lines]


def text_files() -> Iterator[tuple[Path, str]]:
    found = [file for folder in FOLDERS for file in (ROOT / folder).rglob("*") if "__pycache__" not in file.parts]
    for file in [*found, *(ROOT / name for name in SINGLE_FILES)]:
        content = file.read_bytes() if file.is_file() else b"\0"
        if b"\0" not in content:
            yield file, content.decode("utf-8")


def code_blocks(page: str) -> list[str]:
    """The commands of a page, without the explanations beside them."""
    blocks = re.findall(r"(?ms)^```\w*\n(.*?)^```", (ROOT / page).read_text("utf-8"))
    return [re.split(r"\s{2,}", line)[0] for block in blocks for line in block.splitlines()]


def links(page: str) -> set[str]:
    return set(re.findall(r"\]\(([^)#]+)\)", (ROOT / page).read_text("utf-8")))


@pytest.mark.parametrize("page", PAGES)
def test_every_command_of_a_page_exists(page: str) -> None:
    targets = set(re.findall(r"(?m)^([a-z-]+):", (ROOT / "Makefile").read_text("utf-8")))
    subcommands = {file.stem for file in (ROOT / "app" / "helicoide" / "commands").glob("[a-z]*.py")}
    text = (ROOT / page).read_text("utf-8")
    assert set(re.findall(r"(?m)(?:^|`)make ([a-z-]+)", text)) <= targets
    assert set(re.findall(r"(?:bin/|`)helicoide ([a-z]+)", text)) <= subcommands


@pytest.mark.parametrize("page", PAGES)
def test_every_link_of_a_page_leads_to_a_file(page: str) -> None:
    for link in links(page):
        assert (ROOT / link).is_file(), link


def test_both_readmes_say_the_same() -> None:
    english, portuguese = PAGES[:2]
    assert code_blocks(english) == code_blocks(portuguese)
    assert links(english) - {portuguese} == links(portuguese) - {english}
    depths = [re.findall(r"(?m)^#+ ", (ROOT / page).read_text("utf-8")) for page in (english, portuguese)]
    assert depths[0] == depths[1]


def test_pages_makefile_and_project_name_the_same_pythons() -> None:
    versions = [line.rpartition(" ")[2] for line in PROJECT["classifiers"]]
    first, last = versions[0], versions[-1]
    beyond = f"3.{int(last.partition('.')[2]) + 1}"
    assert PROJECT["requires-python"] == f">={first},<{beyond}"
    for page, to in (("README.md", "to"), ("README.pt-BR.md", "ao"), ("Makefile", "to")):
        assert f"{first} {to} {last}" in (ROOT / page).read_text("utf-8"), page


def test_pictures_are_light() -> None:
    for picture in (ROOT / "static" / "pictures").iterdir():
        assert picture.stat().st_size < 400_000, picture


def test_constraints_are_versions_and_nothing_else() -> None:
    for line in CONSTRAINTS:
        assert re.fullmatch(r"[A-Za-z0-9._-]+==\d[A-Za-z0-9.]*", line), line
    names = [canonicalize_name(line.split("==")[0]) for line in CONSTRAINTS]
    assert len(names) == len(set(names))


def test_constraints_cover_every_dependency_and_what_it_brings() -> None:
    pinned = {canonicalize_name(line.split("==")[0]) for line in CONSTRAINTS}
    to_see, seen = declared("test"), set[str]()
    while to_see:
        requirement = to_see.pop()
        name = canonicalize_name(requirement.name)
        assert name in pinned, f"{name} is not in constraints.txt"
        if str(requirement) in seen:
            continue
        seen.add(str(requirement))
        for line in metadata.requires(name) or ():
            brought = Requirement(line)
            extras = ("", *requirement.extras)
            if brought.marker is None or any(brought.marker.evaluate({"extra": extra}) for extra in extras):
                to_see.append(brought)


def imported(file: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module.split(".")[0]


def test_what_the_app_imports_is_declared() -> None:
    names = {canonicalize_name(requirement.name) for requirement in declared()}
    makers = metadata.packages_distributions()  # lacks packages that are one compiled file; these have its name
    for file in (ROOT / "app").rglob("*.py"):
        for module in set(imported(file)) - sys.stdlib_module_names - {"helicoide"}:
            assert names & {canonicalize_name(maker) for maker in makers.get(module, [module])}, (
                f"{file.name} imports {module}"
            )


def test_nothing_of_one_machine_is_written_down() -> None:
    for file, text in text_files():
        found = OF_ONE_MACHINE.search(text)
        assert found is None, f"{file.relative_to(ROOT)}: {found}"


def test_ci_runs_what_a_person_runs() -> None:
    script = ROOT / ".ci" / "run"
    assert os.access(script, os.X_OK)
    assert script.read_text("utf-8").splitlines()[-1] == "exec make test"
