"""Where the rig stands: a preset and what was calibrated of it here, or a laboratory's own rig file."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from app.controllers.rig_snapshot import PRESETS
from scanner_core.errors import ImprontaError

if TYPE_CHECKING:
    from scanner_core.devices.aim_settings import AimSettings
    from scanner_core.devices.rig import RigConfig
    from scanner_core.metrology.history import SphereTrend
    from scanner_core.optics.calibration import StereoCalibration

Tell = Callable[[BaseException], None]

KNOWN = 12
"""Own rig files that are remembered."""


class RigFiles:
    """Reads rigs and keeps their calibrations.  Presets are calibrated into `folder`, an own rig into its own file."""

    def __init__(self, folder: Path, known: list[str], tell: Tell) -> None:
        """`known` are the paths of own rig files, the last one opened first; the list is kept up to date in place."""
        self._folder, self.known, self._tell = folder, known, tell
        self._filed: dict[str, RigConfig] = {}
        self._aimed: dict[str, AimSettings] = {}
        self._writing = threading.Lock()

    def remember(self, name: str) -> None:
        """In the GUI thread: an own rig file goes to the front of the list."""
        if name not in PRESETS:
            self.known[:] = [name, *(other for other in self.known if other != name)][:KNOWN]

    def forget(self, name: str) -> None:
        """In the GUI thread: it is no longer listed; the file stays."""
        self.known[:] = [other for other in self.known if other != name]

    def read(self, name: str) -> RigConfig:
        """A preset as it was calibrated here, or else as it was shipped; or a rig file; with what was set for it while aiming.

        Raises
        ------
        UsageError
            E-RIG-01.
        """
        from scanner_core.devices.aim_settings import read_aim

        config = self._filed[name] = self._read(name)
        self._aimed.pop(name, None)
        try:
            settings = read_aim(self._aim_path(name))
        except ImprontaError as fault:
            self._tell(fault)
            return config
        if settings is None:
            return config
        self._aimed[name] = settings
        return settings.applied(config)

    def aimed(self, name: str) -> AimSettings | None:
        """What is set for a rig while aiming; of one that was read what its file says, None for one that was not."""
        filed = self._filed.get(name)
        return self._aimed.get(name) or (None if filed is None else self._own(filed))

    def filed(self, name: str) -> RigConfig | None:
        """A rig that was read, as its own file has it."""
        return self._filed.get(name)

    def hold_aim(self, name: str, settings: AimSettings) -> None:
        """Until the program ends; :meth:`keep_aim` writes it."""
        self._aimed[name] = settings

    def keep_aim(self, name: str) -> None:
        """Write what is held, the newest of it however many calls come at once, for the next start.

        Raises
        ------
        StorageError
        """
        from scanner_core.devices.aim_settings import write_aim

        with self._writing:
            write_aim(self._aimed[name], self._aim_path(name))

    def _aim_path(self, name: str) -> Path:
        from scanner_core.devices.aim_settings import aim_path

        return aim_path(self._folder / f"{name}.toml" if name in PRESETS else Path(name))

    @staticmethod
    def _own(config: RigConfig) -> AimSettings:
        from scanner_core.devices.aim_settings import AimSettings

        return AimSettings.of(config)

    def _read(self, name: str) -> RigConfig:
        from scanner_core.devices.rig import load_preset, load_rig

        if name not in PRESETS:
            return load_rig(Path(name))
        own = self._folder / f"{name}.toml"
        if own.exists():
            try:
                return load_rig(own)
            except ImprontaError as fault:
                self._tell(fault)
        return load_preset(name)

    def keep(self, name: str, config: RigConfig, calibration: StereoCalibration) -> None:
        """Write the calibration, for the next start; an own rig file keeps everything else as it was written.

        Raises
        ------
        StorageError, UsageError
        """
        from scanner_core.devices.rig import dump_rig, recalibrated, rig_text
        from scanner_core.files import replaced_when_whole, storage_error

        if name in PRESETS:
            filed = self._filed.get(name)
            path, text = self._folder / f"{name}.toml", dump_rig(config if filed is None else self._own(filed).applied(config))
            try:
                path.parent.mkdir(parents=True, exist_ok=True)
            except OSError as fault:
                raise storage_error(path.parent, fault) from fault
        else:
            path, text = Path(name), recalibrated(rig_text(name), calibration)
        with replaced_when_whole(path, force=True) as partial:
            partial.write_text(text, encoding="utf-8")

    def history(self, name: str) -> Path:
        """Where the tests of a rig as it is used here are kept: beside its file, of a preset beside what was calibrated of it here, if anything."""
        from scanner_core.metrology.history import history_path

        own = self._folder / f"{name}.toml"
        return history_path(str(own) if name in PRESETS and own.exists() else name)

    def last_sphere(self, name: str) -> SphereTrend | None:
        """The last test with the reference sphere; of a preset the newer one of as it was shipped and as it was calibrated here."""
        from scanner_core.metrology.history import history_path, last_reference_sphere

        rigs = [name, str(self._folder / f"{name}.toml")] if name in PRESETS else [name]
        try:
            tests = [last_reference_sphere(history_path(rig)) for rig in rigs]
        except ImprontaError as fault:
            self._tell(fault)
            return None
        return max((trend for trend in tests if trend is not None), key=lambda trend: trend.last.moment, default=None)
