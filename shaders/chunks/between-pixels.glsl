/// The picture with every second pixel across and down, drawn before: its pixel (i, j) is this one's (2 i, 2 j).
uniform sampler2D uHalfPicture;

/// 1 / its pixels across and down.
uniform vec2 uHalfPixel;

/// How much the half picture may bend around a pixel that gets no ray of its own, 0..1; below 0 all pixels get one.
uniform float uMostBend;

vec4 secondDifference(vec4 a, vec4 b, vec4 c) {
  return abs(a - 2.0 * b + c);
}

/// The colour of a pixel from those of the half picture around it, which reach beyond its edges. False where it needs a
/// ray of its own. Twin: optics/between-pixels.ts, interpolateQuad
bool interpolatePixel(vec2 pixel, out vec4 color) {
  vec2 corner = floor(0.5 * pixel);
  vec2 odd = pixel - 2.0 * corner;
  vec2 place = (corner + 0.5) * uHalfPixel;
  vec2 right = vec2(uHalfPixel.x, 0.0);
  vec2 up = vec2(0.0, uHalfPixel.y);
  vec4 a = texture2D(uHalfPicture, place);
  vec4 b = texture2D(uHalfPicture, place + right);
  vec4 c = texture2D(uHalfPicture, place + up);
  vec4 d = texture2D(uHalfPicture, place + uHalfPixel);
  vec4 leftOfA = texture2D(uHalfPicture, place - right);
  vec4 rightOfB = texture2D(uHalfPicture, place + 2.0 * right);
  vec4 leftOfC = texture2D(uHalfPicture, place + up - right);
  vec4 rightOfD = texture2D(uHalfPicture, place + up + 2.0 * right);
  vec4 belowA = texture2D(uHalfPicture, place - up);
  vec4 belowB = texture2D(uHalfPicture, place + right - up);
  vec4 aboveC = texture2D(uHalfPicture, place + 2.0 * up);
  vec4 aboveD = texture2D(uHalfPicture, place + right + 2.0 * up);
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
