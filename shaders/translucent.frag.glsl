/// A translucent shape over a picture in which it is not, with what of the volume is before it. With opacity a the picture is
/// (1 - a) times the one without, and a times the one in which the shape is opaque: that is the volume's part before it, over
/// its colour. Exact for what absorbs and emits, whatever lies behind.
uniform sampler2D uGathered;

/// The shape alone, premultiplied, and its depth.
uniform sampler2D uShapeColor;
uniform sampler2D uShapeDepth;

/// Depth of the opaque shapes.
uniform sampler2D uSceneDepth;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

void main() {
  vec2 place = gl_FragCoord.xy * uGatheredPixel;
  vec4 before = texture2D(uGathered, place);
  vec4 shape = texture2D(uShapeColor, place);
  bool isHidden = texture2D(uShapeDepth, place).r > texture2D(uSceneDepth, place).r;
  FRAGMENT_COLOR = isHidden ? vec4(0.0) : vec4(shape.a * before.rgb + (1.0 - before.a) * shape.rgb, shape.a);
}
