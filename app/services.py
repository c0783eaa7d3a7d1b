"""What the pages are given: settings, draft and one controller an activity."""

from __future__ import annotations

from dataclasses import dataclass

from app.background import Background
from app.controllers.acquisition import AcquisitionController
from app.controllers.aiming import AimController
from app.controllers.assistant import AssistantController
from app.controllers.case import CaseController
from app.controllers.comparing import Comparing
from app.controllers.coverage import CoverageController
from app.controllers.delivery import DeliveryController
from app.controllers.editing import EditingController
from app.controllers.live_surface import LiveSurfaceController
from app.controllers.measurements import Measurements
from app.controllers.mount_picks import MountPicks
from app.controllers.mounts import MountsController
from app.controllers.pair_tray import PairTrayController
from app.controllers.preferences import Preferences
from app.controllers.readiness import ReadinessController
from app.controllers.reconstruction import ReconstructionController
from app.controllers.recovery import RecoveryController
from app.controllers.rig import RigController
from app.controllers.verification import VerificationController
from app.controllers.worklist import WorklistController
from app.draft import Draft
from app.settings import Settings


@dataclass(slots=True, eq=False)
class Services:
    """Shared by all pages."""

    settings: Settings
    draft: Draft
    background: Background
    rig: RigController
    case: CaseController
    acquisition: AcquisitionController
    reconstruction: ReconstructionController
    delivery: DeliveryController
    comparing: Comparing
    recovery: RecoveryController
    assistant: AssistantController
    live_surface: LiveSurfaceController
    coverage: CoverageController
    mounts: MountsController
    mount_picks: MountPicks
    preferences: Preferences
    readiness: ReadinessController
    worklist: WorklistController
    pair_tray: PairTrayController
    new_order: Draft
    """What is entered for an order that is not made yet."""
    aiming: AimController
    editing: EditingController
    measurements: Measurements
    verification: VerificationController
