"""Writing 3MF (3MF Consortium, Core Specification 1.3): a zip with one XML model; its unit stands in it."""

from __future__ import annotations

import zipfile
from typing import BinaryIO

from scanner_core.geometry.mesh import TriangleMesh
from scanner_core.mesh_io.precision import decimals

_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
RELATIONS = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_BEGIN = b"""<?xml version="1.0" encoding="UTF-8"?>
<model unit="%s" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Impronta</metadata>
<resources><object id="1" type="model"><mesh>
<vertices>
"""
_MIDDLE = b"</vertices>\n<triangles>\n"
_END = b'</triangles>\n</mesh></object></resources>\n<build><item objectid="1"/></build>\n</model>\n'
_WORDS = {"mm": b"millimeter", "cm": b"centimeter", "m": b"meter", "inch": b"inch"}
_ROWS = 20_000


def write_3mf(file: BinaryIO, mesh: TriangleMesh, unit: str = "mm") -> None:
    """3MF with the unit millimetre, or cm, m, inch; the same mesh gives the same bytes."""
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as package:
        package.writestr(_entry("[Content_Types].xml"), _TYPES)
        package.writestr(_entry("_rels/.rels"), RELATIONS)
        with package.open(_entry("3D/3dmodel.model"), "w", force_zip64=True) as model:
            model.write(_BEGIN % _WORDS[unit])
            row = b'<vertex x="%.9g" y="%.9g" z="%.9g"/>\n'.replace(b"9", b"%d" % decimals(mesh.vertices))
            for begin in range(0, len(mesh.vertices), _ROWS):
                part = mesh.vertices[begin : begin + _ROWS]
                model.write((row * len(part)) % tuple(part.ravel().tolist()))
            model.write(_MIDDLE)
            for begin in range(0, len(mesh.triangles), _ROWS):
                faces = mesh.triangles[begin : begin + _ROWS]
                model.write((b'<triangle v1="%d" v2="%d" v3="%d"/>\n' * len(faces)) % tuple(faces.ravel().tolist()))
            model.write(_END)


def _entry(name: str) -> zipfile.ZipInfo:
    entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
    entry.compress_type = zipfile.ZIP_DEFLATED
    return entry
