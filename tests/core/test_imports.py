"""The architecture as a test: who may import whom, how long a file may be, and what never stands in a tracked file."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
NEVER_IN_CORE = {"PySide6", "shiboken6", "qtpy", "pyvista", "pyvistaqt", "app", "tests"}
HEAVY = {"PySide6", "pyvista", "vtkmodules", "numpy", "scipy", "cv2"}
NEVER_IN_APP = {"scipy", "cv2", "serial", "tests"}  # what is computed or driven belongs to the core
LONGEST_FILE = 450


def _sources(*folders: str) -> list[Path]:
    return sorted(path for folder in folders for path in (ROOT / folder).rglob("*.py"))


def _name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def _imports(path: Path) -> Iterator[tuple[int, str]]:
    """Line and full name of everything that a file imports, also inside functions and by name."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{_name(path)}:{node.lineno}: imports are absolute"
            yield node.lineno, node.module or ""
        elif isinstance(node, ast.Call) and ast.unparse(node.func) in ("import_module", "importlib.import_module", "__import__"):
            yield from ((node.lineno, str(argument.value)) for argument in node.args[:1] if isinstance(argument, ast.Constant))


def _offences(folder: str, forbidden: set[str]) -> list[str]:
    return [f"{_name(path)}:{line} imports {name}" for path in _sources(folder) for line, name in _imports(path) if name.split(".")[0] in forbidden]


def test_the_core_names_neither_qt_nor_pyvista_nor_app() -> None:
    assert _offences("scanner_core", NEVER_IN_CORE) == []
    windows = [path for path in _sources("scanner_core") if any("pyplot" in name for _, name in _imports(path))]
    assert windows == []  # pyplot opens windows and keeps global state; matplotlib's figures alone do not


def test_the_window_leaves_numerics_and_devices_to_the_core() -> None:
    assert _offences("app", NEVER_IN_APP) == []
    linear_algebra = [_name(path) for path in _sources("app") if re.search(r"\bnp\.linalg\b|\bnumpy\.linalg\b", path.read_text(encoding="utf-8"))]
    assert linear_algebra == []


def test_resources_import_nothing_of_the_project() -> None:
    assert _offences("resources", {"app", "scanner_core", "PySide6"}) == []


def test_every_core_module_imports_without_qt() -> None:
    modules = [".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__") for path in _sources("scanner_core")]
    program = (
        "import importlib, sys\n"
        f"for name in {modules!r}: importlib.import_module(name)\n"
        f"print(sorted({{name.split('.')[0] for name in sys.modules}} & {NEVER_IN_CORE!r}))"
    )
    answer = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.strip() == "[]"


def test_the_command_is_cheap_to_spawn() -> None:
    """The worker process imports the main module again; at module level it may load nothing heavy."""
    program = f"import sys, app.__main__; print(sorted({{name.split('.')[0] for name in sys.modules}} & {HEAVY!r}))"
    answer = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
    assert answer.stdout.strip() == "[]"


def test_only_one_file_touches_the_interactor() -> None:
    using = {_name(path) for path in _sources("app") if "QtInteractor" in path.read_text(encoding="utf-8")}
    assert using <= {"app/views/interactor.py"}


def test_no_file_is_too_long() -> None:
    sources = _sources("scanner_core", "app", "resources", "packaging", "tests")
    lengths = {_name(path): len(path.read_text(encoding="utf-8").splitlines()) for path in sources}
    assert {name: length for name, length in lengths.items() if length > LONGEST_FILE} == {}


def test_packaging_is_no_package() -> None:
    assert not (ROOT / "packaging" / "__init__.py").exists(), "it would shadow the library `packaging`"


@pytest.mark.parametrize("folder", ["scanner_core", "app", "resources"])
def test_every_folder_with_modules_is_a_package(folder: str) -> None:
    without = {_name(path.parent) for path in _sources(folder) if not (path.parent / "__init__.py").exists()}
    assert without == set()


def _texts() -> Iterator[tuple[str, str]]:
    folders = ("scanner_core", "app", "resources", "packaging", "tests", ".ci")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts]
    for path in [*files, *(path for path in ROOT.iterdir() if path.is_file() and path.suffix in (".md", ".toml", ".txt", ".cfg"))]:
        try:
            yield _name(path), path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue


def test_no_registry_host_and_no_path_of_one_machine_is_named() -> None:
    # put together here, so that this file does not contain what it looks for
    hosts = [".".join(parts) for parts in (("pypi", "org"), ("files", "pythonhosted", "org"), ("deb", "debian", "org"), ("registry", "npmjs", "org"))]
    places = ["/" + place + "/" for place in ("work", "opt", "root", "home/[a-z]+")]
    pattern = re.compile("|".join([*(re.escape(host) for host in hosts), *(rf"(?<![\w.\-/~}}]){place}" for place in places)]))
    found = [f"{name}: {match.group()}" for name, text in _texts() if (match := pattern.search(text))]
    assert found == []


def test_constraints_pin_every_dependency() -> None:
    lines = (ROOT / "packaging" / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [line for line in lines if line and not line.startswith("#")]
    assert [line for line in pins if not re.fullmatch(r"[A-Za-z0-9_.\-]+==[0-9][0-9A-Za-z.]*", line)] == []
    pinned = {_normal(line.split("==")[0]) for line in pins}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = [requirement for extra in project.get("optional-dependencies", {}).values() for requirement in extra]
    wanted = {_normal(re.split(r"[<>=!;\[ ]", requirement)[0]) for requirement in [*project["dependencies"], *extras]}
    assert wanted <= pinned


def _normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
