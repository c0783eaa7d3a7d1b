"""What the graphics card does for a compared surface: bands, level of detection, hatch, curtain, section, morph.

Done for every pixel and not for every vertex: the borders of the bands are then as sharp as the surface allows, the hatch
stays a hatch at every zoom, and a slider moves one number instead of a hundred thousand colours.  The texts go in at marks
that VTK keeps in its own shaders; they need nothing beyond OpenGL 3.2.  The light is their own, too: one lamp over the left
shoulder whose shade never reaches black (half Lambert), so that dark bands keep their hue.
"""

from __future__ import annotations

from typing import Any, Final

MOST_BANDS: Final = 16

_VERTEX_DECLARED = """//VTK::ValuePass::Dec
in vec4 deviationMC;  // signed um, level um, 1 with counterpart, 1 stable
in float paintedMC;  // 1 painted
in vec3 footMC;  // from the vertex to its foot on the other surface, mm
out vec4 deviationVS;
out float paintedVS;
out vec3 placeVS;
"""
_VERTEX_PLACE = """vec4 moved = vertexMC + vec4(footMC * (1.0 - morph), 0.0);
  deviationVS = deviationMC;
  paintedVS = paintedMC;
  placeVS = moved.xyz;
  vertexVCVSOutput = MCVCMatrix * moved;
  gl_Position = MCDCMatrix * moved;
"""
_FRAGMENT_DECLARED = """//VTK::ValuePass::Dec
in vec4 deviationVS;
in float paintedVS;
in vec3 placeVS;
vec3 bandOf(int n) {  // three bytes in a float; a choice among sixteen colours would take half of the picture's time
  vec4 four = n < 8 ? (n < 4 ? bands0 : bands1) : (n < 12 ? bands2 : bands3);
  float three = four[n & 3];
  float red = floor(three / 65536.0);
  float green = floor((three - red * 65536.0) / 256.0);
  return vec3(red, green, three - red * 65536.0 - green * 256.0) / 255.0;
}
"""
_FRAGMENT_COLOUR = """//VTK::Color::Impl
  float um = deviationVS.x;
  if ((gl_FragCoord.x - curtain.x) * curtain.y < 0.0 || dot(cut.xyz, placeVS) > cut.w) discard;
  vec3 look = plainColour;
  float floorOfLight = 0.28;
  vec2 pixel = gl_FragCoord.xy / pixelRatio;
  if (coloured > 0) {
    floorOfLight = 0.6;  // a colour in the shade must still be the colour of the legend
    if (deviationVS.z < 0.999) {
      look = mod(pixel.x + pixel.y, 7.0) < 2.4 ? hatchColour : emptyColour;
    } else if (abs(um) <= deviationVS.y) {
      look = levelColour;
      floorOfLight = 0.3;
    } else {
      look = bandOf(int(clamp(floor(um * perUM) + float(steps), 0.0, float(2 * steps - 1))));
    }
  }
  vec2 cell = mod(pixel, 6.0) - 3.0;
  float dotted = paintedVS > 0.5 ? 5.2 : (stableShown > 0 && deviationVS.w > 0.5 ? 2.2 : 0.0);
  if (dot(cell, cell) < dotted) look = stableColour;
  if (!gl_FrontFacing) look = mix(backColour, look, 0.3);
"""
_FRAGMENT_LIGHT = """float facing = 0.5 + 0.5 * dot(normalVCVSOutput, vec3(-0.27, 0.43, 0.86));
  fragOutput0 = vec4(look * (floorOfLight + (1.0 - floorOfLight) * facing * facing), fade);
"""


def install(shader: Any) -> None:
    """Put the texts into the shader property of an actor."""
    shader.AddVertexShaderReplacement("//VTK::ValuePass::Dec", True, _VERTEX_DECLARED, False)
    shader.AddVertexShaderReplacement("//VTK::PositionVC::Impl", True, _VERTEX_PLACE, False)
    shader.AddFragmentShaderReplacement("//VTK::ValuePass::Dec", True, _FRAGMENT_DECLARED, False)
    shader.AddFragmentShaderReplacement("//VTK::Color::Impl", True, _FRAGMENT_COLOUR, False)
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, _FRAGMENT_LIGHT, False)
