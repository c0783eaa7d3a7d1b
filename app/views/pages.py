"""The pages in the order of the work: a page is one file and one entry here."""

from __future__ import annotations

from dataclasses import dataclass

from app.translation import QT_TRANSLATE_NOOP
from app.views.aim_page import AimPage
from app.views.assistant_page import AssistantPage
from app.views.compare_page import ComparePage
from app.views.coverage_page import CoveragePage
from app.views.deliver_page import DeliverPage
from app.views.edit_page import EditPage
from app.views.home_page import HomePage
from app.views.mounts_page import MountsPage
from app.views.page import MakePage
from app.views.pick_page import PickPage
from app.views.reconstruct_page import ReconstructPage
from app.views.rig_page import RigPage
from app.views.scan_page import ScanPage
from app.views.settings_page import SettingsPage
from app.views.verify_page import VerifyPage


@dataclass(frozen=True, slots=True)
class PageInfo:
    """One page.

    Attributes
    ----------
    stage : title over the 3D view that stands beside the page, or empty when the page fills the window
    of : id of the page of the rail that it belongs to, for a page without a place of its own there
    """

    id: str
    title: str
    icon: str
    make: MakePage
    stage: str = ""
    of: str = ""


PAGES: tuple[PageInfo, ...] = (
    PageInfo("home", QT_TRANSLATE_NOOP("pages", "Home"), "home", HomePage),
    PageInfo("rig", QT_TRANSLATE_NOOP("pages", "Rig"), "rig", RigPage),
    PageInfo("aim", QT_TRANSLATE_NOOP("pages", "Aim"), "aim", AimPage),
    PageInfo("scan", QT_TRANSLATE_NOOP("pages", "Scan"), "scan", ScanPage, stage=QT_TRANSLATE_NOOP("pages", "Live point cloud")),
    PageInfo("edit", QT_TRANSLATE_NOOP("pages", "Edit"), "edit", EditPage, stage=QT_TRANSLATE_NOOP("pages", "Points and measurements")),
    PageInfo("reconstruct", QT_TRANSLATE_NOOP("pages", "Reconstruct"), "reconstruct", ReconstructPage, stage=QT_TRANSLATE_NOOP("pages", "Surface")),
    PageInfo("deliver", QT_TRANSLATE_NOOP("pages", "Deliver"), "export", DeliverPage, stage=QT_TRANSLATE_NOOP("pages", "Surface")),
    PageInfo("compare", QT_TRANSLATE_NOOP("pages", "Compare"), "compare", ComparePage),
)

FOOT: tuple[PageInfo, ...] = (PageInfo("settings", QT_TRANSLATE_NOOP("pages", "Settings"), "settings", SettingsPage),)
"""At the foot of the rail: no step of the work."""
ASIDE: tuple[PageInfo, ...] = (
    PageInfo("assistant", QT_TRANSLATE_NOOP("pages", "Set up a rig"), "rig", AssistantPage, of="rig"),
    PageInfo("verify", QT_TRANSLATE_NOOP("pages", "Reference sphere"), "rig", VerifyPage, of="rig"),
    PageInfo("coverage", QT_TRANSLATE_NOOP("pages", "Complete"), "scan", CoveragePage, stage=QT_TRANSLATE_NOOP("pages", "Missing places"), of="scan"),
    PageInfo("mounts", QT_TRANSLATE_NOOP("pages", "Another mount"), "scan", MountsPage, stage=QT_TRANSLATE_NOOP("pages", "Mounts"), of="scan"),
    PageInfo("pick", QT_TRANSLATE_NOOP("pages", "Pick three points"), "scan", PickPage, of="scan"),
)
"""What is not done for every order: not in the rail."""
