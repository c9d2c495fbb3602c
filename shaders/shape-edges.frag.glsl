/// Shows a picture of the volume that was drawn before, over the scene's shapes. The canvas has several samples a pixel and a ray
/// ends at what stands in the pixel's middle: where a shape's edge passes through a pixel, the samples on its other side get
/// what a ray beside it has gathered. Drawn twice, for the samples before and behind a depth between both.
uniform sampler2D uGathered;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

/// Two ends of rays are on two sides of an edge if they are farther apart than this, in bounding diameters.
uniform float uLeastJump;

/// 1 for the samples that are farther than an edge's depth, else 0.
uniform float uFarSide;

/// Ends of rays before and behind the volume, whose bounding sphere is there, are not told apart.
float endAt(vec2 pixel) {
  return clamp(depthToT(depthAt(pixel)), -0.5, 0.5);
}

void main() {
  vec2 pixel = gl_FragCoord.xy;
  float stored = depthAt(pixel);
  float own = endAt(pixel);
  // The pixel on the other side of an edge: of those around whose end is not where this one's slope says, the farthest off.
  float jump = uLeastJump;
  float depth = 1.0;
  for (int i = 0; i < 4; i++) {
    vec2 offset = i == 0 ? vec2(1.0, 0.0) : i == 1 ? vec2(0.0, 1.0) : i == 2 ? vec2(1.0, 1.0) : vec2(1.0, -1.0);
    vec2 ends = vec2(endAt(pixel - offset), endAt(pixel + offset)) - own;
    float bend = abs(ends.x + ends.y);
    if (bend <= jump) continue;
    jump = bend;
    depth = 0.5 * (stored + depthAt(pixel + (abs(ends.x) > abs(ends.y) ? -offset : offset)));
  }
  bool isSplit = jump > uLeastJump;
  bool isFar = uFarSide > 0.5;
  if (isFar && !isSplit) discard;
  vec4 color = texture2D(uGathered, pixel * uGatheredPixel);
  if (isSplit && (stored > depth) != isFar) {
    // All around that are on the other side: which of them is nearest to a sample is not known.
    vec4 sum = vec4(0.0);
    float count = 0.0;
    for (int i = 0; i < 9; i++) {
      float number = float(i);
      vec2 one = pixel + vec2(mod(number, 3.0) - 1.0, floor(number / 3.0) - 1.0);
      if ((depthAt(one) > depth) != isFar) continue;
      sum += texture2D(uGathered, one * uGatheredPixel);
      count += 1.0;
    }
    if (count > 0.5) color = sum / count;
  }
  FRAGMENT_DEPTH = depth;
  FRAGMENT_COLOR = color;
}
