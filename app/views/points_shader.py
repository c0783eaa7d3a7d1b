"""How points are lit: once a point and not once a pixel, which is a third of the time on software rendering.

One lamp over the left shoulder whose shade never reaches black (half Lambert), so that a point in the shade still has the
colour of the legend.  What faces away, and is seen through the gaps of what is in front, fades into the ground.  The texts go
in at marks that VTK keeps in its own shaders.
"""

from __future__ import annotations

from typing import Any

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 - without it no actor has a shader property

_VERTEX_DECLARED = """//VTK::Normal::Dec
out vec2 litVS;  // by the lamp; share of the ground
"""
_VERTEX_LIT = """//VTK::Normal::Impl
  vec3 acrossVC = normalMatrix * normalMC;
  float facingVC = 0.5 + 0.5 * dot(acrossVC, vec3(-0.27, 0.43, 0.86));
  litVS = vec2(0.42 + 0.66 * facingVC * facingVC, 0.72 * smoothstep(0.05, -0.25, acrossVC.z));
"""
_FRAGMENT_DECLARED = """in vec2 litVS;
"""
_FRAGMENT_LIGHT = """fragOutput0 = vec4(mix(diffuseColor * litVS.x, groundColour, litVS.y), 1.0);
"""


def install(shader: Any) -> None:
    """Put the texts into the shader property of an actor."""
    shader.AddVertexShaderReplacement("//VTK::Normal::Dec", True, _VERTEX_DECLARED, False)
    shader.AddVertexShaderReplacement("//VTK::Normal::Impl", True, _VERTEX_LIT, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Dec", True, _FRAGMENT_DECLARED, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", True, "", False)
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, _FRAGMENT_LIGHT, False)
    put_ground(shader, (0.0, 0.0, 0.0))


def put_ground(shader: Any, colour: tuple[float, float, float]) -> None:
    """What is behind the points, as shares of one."""
    shader.GetFragmentCustomUniforms().SetUniform3f("groundColour", colour)
