/// Where a quad of 2 x 2 pixels is: its place among all quads, 0..1; and, in device coordinates of the whole picture, the middle of the
/// known pixels at its corners, and their distance from it.
struct QuadPlace {
  vec2 at;
  vec2 middle;
  vec2 reach;
};

/// From a quad to the middle of its known pixels in device coordinates: factors and shifts.
uniform vec4 uQuadToDevice;

QuadPlace placeOf(vec2 quad) {
  return QuadPlace((quad + 0.5) / uQuads, quad * uQuadToDevice.xy + uQuadToDevice.zw, 0.5 * uQuadToDevice.xy);
}
