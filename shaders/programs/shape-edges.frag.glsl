/// Shows a picture of the volume that was drawn before, over the scene's shapes. The canvas has several samples for each pixel, but a
/// ray ends at the shape in the pixel's middle. If a shape's edge passes through a pixel, the samples on its other side get the colour of
/// a second ray that ends there; if there is no second ray, as at lines, they get the colour of neighbouring rays. This program is drawn
/// twice: for the samples in front of a depth between both sides, and for those behind it.
uniform sampler2D uGathered;

/// The colours of the second rays, and which pixels have one.
uniform sampler2D uOtherSides;
uniform sampler2D uSplitPixels;
uniform float uHasOtherSides;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

/// 1 for the samples that are farther than an edge's depth, else 0.
uniform float uFarSide;

/// The mean of all neighbours on one side of the edge: it is not known which of them is nearest to a sample.
vec4 meanOfSide(vec2 pixel, float depth, bool isFar, vec4 color) {
  vec4 sum = vec4(0.0);
  float count = 0.0;
  for (int i = 0; i < 9; i++) {
    float number = float(i);
    vec2 one = pixel + vec2(mod(number, 3.0) - 1.0, floor(number / 3.0) - 1.0);
    if ((depthAt(one) > depth) != isFar) continue;
    sum += texture2D(uGathered, one * uGatheredPixel);
    count += 1.0;
  }
  return count > 0.5 ? sum / count : color;
}

void main() {
  vec2 pixel = gl_FragCoord.xy;
  Split split = splitAt(pixel);
  bool isFar = uFarSide > 0.5;
  if (isFar && !split.isSplit) discard;
  vec4 color = texture2D(uGathered, pixel * uGatheredPixel);
  if (split.isSplit && (split.own > split.between) != isFar) {
    if (uHasOtherSides > 0.5 && texture2D(uSplitPixels, pixel * uGatheredPixel).r > 0.5) color = texture2D(uOtherSides, pixel * uGatheredPixel);
    else color = meanOfSide(pixel, split.between, isFar, color);
  }
  FRAGMENT_DEPTH = split.between;
  FRAGMENT_COLOR = color;
}
