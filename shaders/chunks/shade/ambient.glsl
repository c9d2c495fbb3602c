/// The ambient light in cells, whose slices are tiles of a mosaic.
uniform sampler2D uAmbient;

/// Cells along x, y and z, with the margin; columns of tiles.
uniform vec4 uAmbientGrid;

/// 1 / texels across and down; open cells around the volume; how far in front of a place its light is looked up, world length.
uniform vec4 uAmbientScale;

/// at: in a tile, cells.
float ambientInSlice(float slice, vec2 at) {
  float row = floor((slice + 0.5) / uAmbientGrid.w);
  return texture2D(uAmbient, (vec2(slice - row * uAmbientGrid.w, row) * uAmbientGrid.xy + at) * uAmbientScale.xy).r;
}

/// p: unit cube. Twin: optics/rays/ambient-light.ts, ambientAt
float ambientAt(vec3 p) {
  vec3 at = clamp(p * (uAmbientGrid.xyz - 2.0 * uAmbientScale.z) + uAmbientScale.z, vec3(0.5), uAmbientGrid.xyz - 0.5);
  float below = floor(at.z - 0.5);
  float above = min(below + 1.0, uAmbientGrid.z - 1.0);
  return mix(ambientInSlice(below, at.xy), ambientInSlice(above, at.xy), at.z - 0.5 - below);
}

/// Darkens what is hidden from the light that comes from all sides. Places are left out as in lit.glsl, which comes before.
/// Source: Hernell, Ljung and Ynnerman 2010. Twin: optics/rays/ambient-light.ts, ambientShade
vec4 ambientShade(Segment segment, vec4 seen) {
  if (segment.visible <= MIN_LIT || segment.visible * seen.a <= MIN_LIT * segment.span) return seen;
  vec3 middle = 0.5 * (segment.front.point + segment.back.point);
  vec3 direction = rayOfPixel().direction;
  float light = ambientAt(middle - direction * (uAmbientScale.w / length(uUnitToWorld * direction)));
  return vec4(seen.rgb * mix(1.0, light, fadeAtCuts(middle)), seen.a);
}
