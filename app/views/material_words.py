"""What the shipped materials are called and the reasons of their numbers, for the translation; a person's own ones stay as they were typed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from app.translation import QT_TRANSLATE_NOOP

if TYPE_CHECKING:
    from scanner_core.devices.material import Material

TEXTS = (
    QT_TRANSLATE_NOOP("materials", "Ear impression silicone"),
    QT_TRANSLATE_NOOP("materials", "Matt, light silicone that has set; coloured ones may need more light."),
    QT_TRANSLATE_NOOP(
        "materials", "The rig's own exposure is made for a matt, light surface that scatters back about half of the light, as silicone does."
    ),
    QT_TRANSLATE_NOOP("materials", "The walls of the canal are seen at up to 80 degrees: their spots are drawn out, and still good."),
    QT_TRANSLATE_NOOP("materials", "Set silicone hardly mirrors: four times as bright tells the spot from the few reflections."),
    QT_TRANSLATE_NOOP("materials", "Plaster"),
    QT_TRANSLATE_NOOP("materials", "White gypsum, as dental models and casts are made of."),
    QT_TRANSLATE_NOOP(
        "materials", "Plaster scatters back about 0.8 of the light where silicone scatters 0.5: the same peak comes in 0.65 of the time."
    ),
    QT_TRANSLATE_NOOP("materials", "A little light spreads inside of the plaster and comes out around the spot."),
    QT_TRANSLATE_NOOP("materials", "Dry plaster does not mirror; what is less bright by four is light from a neighbouring wall."),
    QT_TRANSLATE_NOOP("materials", "Alginate, scan-sprayed"),
    QT_TRANSLATE_NOOP("materials", "Alginate or another wet, glossy impression under a thin coat of white powder."),
    QT_TRANSLATE_NOOP("materials", "The powder is as white as plaster where the coat covers; a little more light for where it is thin."),
    QT_TRANSLATE_NOOP(
        "materials",
        "Where the coat is thin the wet surface mirrors: only what is clearly the brightest is taken, the rest is left to the other camera.",
    ),
    QT_TRANSLATE_NOOP("materials", "Glare flattens the top of a spot on a wet place: fewer clipped pixels are borne than on a matt surface."),
    QT_TRANSLATE_NOOP("materials", "Skin-like"),
    QT_TRANSLATE_NOOP("materials", "Translucent and reddish: skin, wax, flesh-coloured silicone."),
    QT_TRANSLATE_NOOP("materials", "Light goes in and comes out around: the peak is lower than on silicone that scatters as much."),
    QT_TRANSLATE_NOOP("materials", "The halo of the light that comes out around the spot is wider than the spot."),
    QT_TRANSLATE_NOOP("materials", "A higher threshold keeps the foot of the halo, which is no part of the beam, out of the spot."),
    QT_TRANSLATE_NOOP("materials", "A dim halo without its spot must not be taken for one."),
    QT_TRANSLATE_NOOP("materials", "Glossy plastic"),
    QT_TRANSLATE_NOOP("materials", "Printed models, varnish, enamel; spray it where you can."),
    QT_TRANSLATE_NOOP("materials", "The part that is mirrored is lost to both cameras or blinds one: between plaster and silicone."),
    QT_TRANSLATE_NOOP("materials", "Mirrored spots are nearly as bright as true ones: the frame alone decides nothing, the other camera does."),
    QT_TRANSLATE_NOOP("materials", "A clipped top hides where the peak is, and on gloss it is seldom in the middle."),
    QT_TRANSLATE_NOOP(
        "materials", "Mirrored light is drawn out along the surface: spots that are longer than three times their width are doubtful here."
    ),
)
"""Every text of ``resources/materials``: a test compares."""


def material_title(material: Material) -> str:
    """Its name."""
    return _text(material, material.title)


def material_reasons(material: Material) -> str:
    """What it is and why it is set as it is, a line each."""
    return "\n".join(_text(material, text) for text in (material.about, *material.reasons.values()) if text)


def _text(material: Material, text: str) -> str:
    return text if material.own or not text else QCoreApplication.translate("materials", text)
