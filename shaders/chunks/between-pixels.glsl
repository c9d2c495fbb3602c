/// The picture with every second pixel across and down, drawn before: its pixel (i, j) is this one's (2 i, 2 j).
uniform sampler2D uHalfPicture;

/// Its pixels across and down.
uniform vec2 uHalfSize;

/// How much the half picture may bend around a pixel that gets no ray of its own, 0..1; below 0 all pixels get one.
uniform float uMostBend;

vec4 halfPixel(vec2 corner, float i, float j) {
  return texture2D(uHalfPicture, (clamp(corner + vec2(i, j), vec2(0.0), uHalfSize - 1.0) + 0.5) / uHalfSize);
}

vec4 secondDifference(vec4 a, vec4 b, vec4 c) {
  return abs(a - 2.0 * b + c);
}

/// The colour of a pixel from those of the half picture around it. False where it needs a ray of its own.
/// Twin: optics/between-pixels.ts, interpolateQuad
bool interpolatePixel(vec2 pixel, out vec4 color) {
  vec2 corner = floor(0.5 * pixel);
  vec2 odd = pixel - 2.0 * corner;
  vec4 a = halfPixel(corner, 0.0, 0.0);
  vec4 b = halfPixel(corner, 1.0, 0.0);
  vec4 c = halfPixel(corner, 0.0, 1.0);
  vec4 d = halfPixel(corner, 1.0, 1.0);
  vec4 leftOfA = halfPixel(corner, -1.0, 0.0);
  vec4 rightOfB = halfPixel(corner, 2.0, 0.0);
  vec4 leftOfC = halfPixel(corner, -1.0, 1.0);
  vec4 rightOfD = halfPixel(corner, 2.0, 1.0);
  vec4 belowA = halfPixel(corner, 0.0, -1.0);
  vec4 belowB = halfPixel(corner, 1.0, -1.0);
  vec4 aboveC = halfPixel(corner, 0.0, 2.0);
  vec4 aboveD = halfPixel(corner, 1.0, 2.0);
  vec4 across = (9.0 * (a + b) - leftOfA - rightOfB) / 16.0;
  vec4 down = (9.0 * (a + c) - belowA - aboveC) / 16.0;
  vec4 amid = (10.0 * (a + b + c + d) - leftOfA - rightOfB - leftOfC - rightOfD - belowA - belowB - aboveC - aboveD) / 32.0;
  color = mix(mix(a, across, odd.x), mix(down, amid, odd.x), odd.y);
  vec4 bends = max(
    max(max(secondDifference(leftOfA, a, b), secondDifference(a, b, rightOfB)), max(secondDifference(leftOfC, c, d), secondDifference(c, d, rightOfD))),
    max(max(secondDifference(belowA, a, c), secondDifference(a, c, aboveC)), max(secondDifference(belowB, b, d), secondDifference(b, d, aboveD)))
  );
  float bend = max(max(bends.r, bends.g), max(bends.b, bends.a));
  return uMostBend >= 0.0 && (odd.x + odd.y < 0.5 || bend <= uMostBend);
}
