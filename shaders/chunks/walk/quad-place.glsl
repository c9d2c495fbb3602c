/// Where a quad of 2 x 2 pixels is: its place among all, 0..1; and the known pixels at its corners, in device coordinates of the
/// whole picture: their middle, and how far they are from it.
struct QuadPlace {
  vec2 at;
  vec2 middle;
  vec2 reach;
};

/// The middle of a quad's known pixels, in device coordinates: factors and shifts.
uniform vec4 uQuadToDevice;

QuadPlace placeOf(vec2 quad) {
  return QuadPlace((quad + 0.5) / uQuads, quad * uQuadToDevice.xy + uQuadToDevice.zw, 0.5 * uQuadToDevice.xy);
}
