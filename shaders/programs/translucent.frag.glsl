/// A translucent shape over a picture in which it is not, with what of the volume is before it. With opacity a the picture is
/// (1 - a) times the one without, and a times the one in which the shape is opaque: that is the volume's part before it, over
/// its colour. Exact for what absorbs and emits, whatever lies behind.
uniform sampler2D uGathered;

/// The shape alone, premultiplied, and its depth, 1 where it is not.
uniform sampler2D uShapeColor;
uniform sampler2D uShapeDepth;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

/// Where the shape's part of a pixel is known: where its middle is beside the shape, in a pixel around.
vec2 knownPlace(vec2 pixel) {
  vec2 place = pixel * uGatheredPixel;
  for (int i = 0; i < 9; i++) {
    float number = float(i);
    // The middle one first, then those beside it, then those at its corners.
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
