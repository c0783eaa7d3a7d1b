"""The two set-up commands: they start on an old Python, find a finished environment, and give each failure its sentence."""

from __future__ import annotations

import ast
import errno
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

FOLDER = Path(__file__).resolve().parents[2] / "packaging"
NAMES = ("environment", "launcher", "package_index", "progress", "system_libraries")


@pytest.fixture
def modules(monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, ModuleType]]:
    monkeypatch.syspath_prepend(str(FOLDER))
    yield {name: __import__(name) for name in NAMES}
    for name in NAMES:
        sys.modules.pop(name, None)


@pytest.fixture
def checkout(modules: dict[str, ModuleType], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A folder with a space in its name that stands for the checkout."""
    root = tmp_path / "my impronta"
    for folder in ("packaging", "scanner_core", "app", "resources"):
        (root / folder).mkdir(parents=True)
    for file in ("pyproject.toml", "README.md", "LICENSE", "app/main.py"):
        (root / file).touch()
    (root / "packaging" / "constraints.txt").write_text("numpy==2.4.6\n")
    monkeypatch.setattr(modules["environment"], "ROOT", root)
    monkeypatch.setattr(modules["environment"], "CONSTRAINTS", root / "packaging" / "constraints.txt")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "user"))
    return root


def _finish(environment: ModuleType, folder: Path, extras: list[str]) -> None:
    found = environment.Environment(folder)
    found.python.parent.mkdir(parents=True)
    found.python.touch()
    found.command.touch()
    found.stamp.write_text(json.dumps({"digest": environment.digest(folder), "extras": extras}))


@pytest.mark.parametrize("script", ["start.py", "check.py"])
def test_an_old_python_gets_as_far_as_the_sentence(script: str) -> None:
    ast.parse((FOLDER / script).read_text(encoding="utf-8"), feature_version=(3, 6))


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device", "disk is full"),
        ("WARNING: Retrying ... NewConnectionError(...)\nERROR: No matching distribution found for numpy", "cannot be reached"),
        ("WARNING: Retrying ... SSLError(SSLCertVerificationError(1, 'CERTIFICATE_VERIFY_FAILED'))", "does not trust"),
        ("ERROR: No matching distribution found for vtk==9.7.2", "no ready-made package"),
        ("ERROR: something nobody thought of", "something nobody thought of"),
    ],
)
def test_each_failed_installation_has_its_sentence(modules: dict[str, ModuleType], tmp_path: Path, said: str, expected: str) -> None:
    sentence = modules["package_index"].explain(said.splitlines(), tmp_path, tmp_path / "log")
    assert expected in sentence
    assert "run this command again" in sentence


def test_a_finished_environment_is_found_again(modules: dict[str, ModuleType], checkout: Path) -> None:
    environment = modules["environment"]
    _finish(environment, checkout / ".venv", ["test"])
    assert environment.find(frozenset()) == (environment.Environment(checkout / ".venv"), True)
    assert environment.find(frozenset({"test"}))[1]
    assert not environment.find(frozenset({"other"}))[1]


def test_other_pins_or_another_place_ask_for_a_new_installation(modules: dict[str, ModuleType], checkout: Path) -> None:
    environment = modules["environment"]
    _finish(environment, checkout / ".venv", [])
    (checkout / "packaging" / "constraints.txt").write_text("numpy==2.4.7\n")
    assert not environment.find(frozenset())[1]


def test_a_damaged_stamp_asks_for_a_new_installation(modules: dict[str, ModuleType], checkout: Path) -> None:
    environment = modules["environment"]
    _finish(environment, checkout / ".venv", [])
    environment.Environment(checkout / ".venv").stamp.write_text('{"digest": ')
    assert not environment.find(frozenset())[1]


def test_a_checkout_that_cannot_be_written_to_gets_its_environment_elsewhere(
    modules: dict[str, ModuleType], checkout: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    environment = modules["environment"]
    monkeypatch.setattr(environment, "_writable", lambda folder: checkout not in (folder, *folder.parents))
    found, complete = environment.find(frozenset())
    assert not complete
    assert checkout not in found.folder.parents
    with environment._installable() as source:
        assert source != checkout
        assert (source / "app" / "main.py").exists()


def test_too_little_room_is_said_before_anything_is_written(modules: dict[str, ModuleType], checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    environment = modules["environment"]
    usage = type("Usage", (), {"free": 500_000_000})
    monkeypatch.setattr(environment.shutil, "disk_usage", lambda folder: usage)
    with pytest.raises(modules["progress"].SetupError, match="500 MB left"):
        environment.create(environment.Environment(checkout / ".venv"))


def test_a_full_disk_while_the_environment_is_made(modules: dict[str, ModuleType], checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    environment = modules["environment"]

    def full(*arguments: object, **options: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(environment.Path, "mkdir", full)
    with pytest.raises(modules["progress"].SetupError, match="is full"):
        environment.create(environment.Environment(checkout / ".venv"))


def test_a_user_without_rights_gets_the_one_command(
    modules: dict[str, ModuleType], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    libraries, launcher = modules["system_libraries"], modules["launcher"]
    monkeypatch.setattr(libraries.shutil, "which", lambda program: f"/usr/bin/{program}")
    monkeypatch.setattr(libraries, "can_install", lambda: False)
    launcher._system_packages(["libegl1"], [])
    assert "sudo apt-get update && sudo apt-get install -y --no-install-recommends libegl1" in capsys.readouterr().err
    with pytest.raises(modules["progress"].SetupError, match=r"install .* python3-venv"):
        launcher._system_packages(["python3-venv"], ["python3-venv"])


@pytest.mark.parametrize(
    ("arguments", "display", "expected"),
    [([], True, []), ([], False, ["demo"]), (["demo", "--json"], True, ["demo", "--json"]), (["info", "a b.ply"], False, ["info", "a b.ply"])],
)
def test_what_is_started(
    modules: dict[str, ModuleType], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, arguments: list[str], display: bool, expected: list[str]
) -> None:
    launcher = modules["launcher"]
    ready = modules["environment"].Environment(tmp_path)
    ran: list[list[str]] = []
    monkeypatch.setattr(launcher, "_set_up", lambda extras, programs: (ready, True))
    monkeypatch.setattr(launcher.system_libraries, "display_answers", lambda: display)
    monkeypatch.setattr(launcher, "_run", lambda command, variables, folder=None: ran.append(command) or 0)
    monkeypatch.setattr(launcher, "_become", lambda command, variables, folder=None: ran.append(command) or 0)
    assert launcher.start(arguments) == 0
    assert ran == [[str(ready.command), *expected]]


@pytest.mark.parametrize(
    ("arguments", "tools"),
    [([], ["ruff", "mypy", "pytest"]), (["-m", "long"], ["pytest"]), (["--lint", "tests/core"], ["ruff", "mypy", "pytest"])],
)
def test_what_is_checked(
    modules: dict[str, ModuleType], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, arguments: list[str], tools: list[str]
) -> None:
    launcher = modules["launcher"]
    ran: list[list[str]] = []
    monkeypatch.setattr(launcher, "_set_up", lambda extras, programs: (modules["environment"].Environment(tmp_path), True))
    monkeypatch.setattr(launcher, "_screen", lambda window_possible: [])
    monkeypatch.setattr(launcher, "_run", lambda command, variables, folder=None: ran.append(command) or 0)
    monkeypatch.setattr(launcher, "_become", lambda command, variables, folder=None: ran.append(command) or 0)
    assert launcher.check(arguments) == 0
    assert [command[2] for command in ran] == tools
    assert "--lint" not in ran[-1]


def test_a_style_fault_stops_the_check(modules: dict[str, ModuleType], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    launcher = modules["launcher"]
    ran: list[list[str]] = []
    monkeypatch.setattr(launcher, "_set_up", lambda extras, programs: (modules["environment"].Environment(tmp_path), True))
    monkeypatch.setattr(launcher, "_screen", lambda window_possible: [])
    monkeypatch.setattr(launcher, "_run", lambda command, variables, folder=None: ran.append(command) or 1)
    assert launcher.check([]) == 1
    assert len(ran) == 1
