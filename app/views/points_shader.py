"""How points are lit: once a point and not once a pixel, which is a third of the time on software rendering.

One lamp over the left shoulder whose shade never reaches black (half Lambert), so that a point in the shade still has the
colour of the legend.  The texts go in at marks that VTK keeps in its own shaders.
"""

from __future__ import annotations

from typing import Any

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - without it no actor has a shader property

_VERTEX_DECLARED = """//VTK::Normal::Dec
out float litVS;
"""
_VERTEX_LIT = """//VTK::Normal::Impl
  float facingMC = 0.5 + 0.5 * dot(normalMatrix * normalMC, vec3(-0.27, 0.43, 0.86));
  litVS = 0.42 + 0.66 * facingMC * facingMC;
"""
_FRAGMENT_LIGHT = """fragOutput0 = vec4(diffuseColor * litVS, 1.0);
"""


def install(shader: Any) -> None:
    """Put the texts into the shader property of an actor."""
    shader.AddVertexShaderReplacement("//VTK::Normal::Dec", True, _VERTEX_DECLARED, False)
    shader.AddVertexShaderReplacement("//VTK::Normal::Impl", True, _VERTEX_LIT, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Dec", True, "in float litVS;\n", False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, "", False)
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, _FRAGMENT_LIGHT, False)
