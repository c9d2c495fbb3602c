/// Draws a translucent shape over a picture without it, together with the part of the volume in front of the shape. With opacity a, the
/// result is (1 - a) times the picture without the shape, plus a times the picture in which the shape is opaque: that is the volume's
/// part in front of it, over the shape's colour. This is exact for emission and absorption, whatever is behind the shape.
uniform sampler2D uGathered;

/// The shape alone, premultiplied, and its depth: 1 where there is no shape.
uniform sampler2D uShapeColor;
uniform sampler2D uShapeDepth;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

/// The place of a pixel that shows the shape: this pixel, or a neighbour if this pixel's middle is next to the shape.
vec2 knownPlace(vec2 pixel) {
  vec2 place = pixel * uGatheredPixel;
  for (int i = 0; i < 9; i++) {
    float number = float(i);
    // The pixel itself first, then its neighbours at the sides, then those at the corners.
    vec2 offset = i == 0 ? vec2(0.0) : i < 5 ? vec2(number < 2.5 ? 2.0 * number - 3.0 : 0.0, number > 2.5 ? 2.0 * number - 7.0 : 0.0) : vec2(mod(number, 2.0) * 2.0 - 1.0, number < 6.5 ? -1.0 : 1.0);
    vec2 one = (pixel + offset) * uGatheredPixel;
    if (texture2D(uShapeDepth, one).r < 1.0) {
      place = one;
      break;
    }
  }
  return place;
}

void main() {
  vec2 place = knownPlace(gl_FragCoord.xy);
  vec4 before = texture2D(uGathered, place);
  vec4 shape = texture2D(uShapeColor, place);
  FRAGMENT_COLOR = vec4(shape.a * before.rgb + (1.0 - before.a) * shape.rgb, shape.a);
}
