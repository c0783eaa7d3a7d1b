"""The laser's lamps in the rail and in the status line, which every page shows."""

from __future__ import annotations

import time

from app.controllers.emission import Emission, emission_words
from app.services import Services
from app.views.rail import Rail
from app.views.status_line import StatusLine

HOLD_S = 0.8
_LAMPS = {Emission.NO_RIG: "idle", Emission.UNKNOWN: "warn", Emission.DARK: "idle", Emission.LIT: "laser"}


class LaserLamps:
    """Lit while the controller reports emission, and a moment longer: between two rows it is dark too briefly to be told."""

    def __init__(self, services: Services, rail: Rail, status_line: StatusLine) -> None:
        self._services, self._rail, self._status_line = services, rail, status_line
        self.emission: Emission | None = None
        """As it is shown."""
        self._lit_s = -HOLD_S

    def show(self) -> None:
        """Of whoever holds the devices; for the pump."""
        now_s = time.monotonic()
        services = self._services
        emission = services.assistant.emission if services.assistant.holds_devices else services.rig.emission
        if emission is Emission.LIT:
            self._lit_s = now_s
        elif emission is Emission.DARK and now_s - self._lit_s < HOLD_S:
            emission = Emission.LIT
        if emission is not self.emission:
            self.emission = emission
            self._rail.show_laser(emission)
            self._status_line.laser.show_state(_LAMPS[emission], emission_words(emission))
