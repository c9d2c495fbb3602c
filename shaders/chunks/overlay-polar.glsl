/// Data values of another moment, laid out as the volume's gates are.
uniform sampler2D uOverlay;

float fetchSecond(vec2 place) {
  return texture2D(uOverlay, place).r;
}

/// Velocities more than this apart are on two sides of a fold.
uniform float uOverlayFoldFrom;

/// Data value of the other moment at a place, which has been gathered with the volume's own. False where there is none.
bool sampleOverlay(vec3 p, out float value) {
  return blend(second, uOverlayFoldFrom, value);
}
