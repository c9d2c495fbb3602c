/// The half picture, drawn before, with every second pixel across and down: its pixel (i, j) is pixel (2 i, 2 j) of this picture.
uniform sampler2D uHalfPicture;

/// Quads of 2 x 2 pixels along each axis; a quad that needs rays is drawn as a point. 0 if the box is drawn instead.
uniform vec2 uQuads;

/// 1 / the half picture's pixels across and down.
uniform vec2 uHalfPixel;

/// The half picture around a quad of 2 x 2 pixels: a is the pixel at its lower left, b right of it, c above, d right above.
struct Surroundings {
  vec4 a;
  vec4 b;
  vec4 c;
  vec4 d;
  vec4 leftOfA;
  vec4 rightOfB;
  vec4 leftOfC;
  vec4 rightOfD;
  vec4 belowA;
  vec4 belowB;
  vec4 aboveC;
  vec4 aboveD;
};

vec4 halfPixel(vec2 pixel) {
  return texture2D(uHalfPicture, (pixel + 0.5) * uHalfPixel);
}

/// quad: whole numbers. Beyond its edges, the half picture repeats its last pixels.
Surroundings lookAround(vec2 quad) {
  return Surroundings(
    halfPixel(quad),
    halfPixel(quad + vec2(1.0, 0.0)),
    halfPixel(quad + vec2(0.0, 1.0)),
    halfPixel(quad + vec2(1.0, 1.0)),
    halfPixel(quad + vec2(-1.0, 0.0)),
    halfPixel(quad + vec2(2.0, 0.0)),
    halfPixel(quad + vec2(-1.0, 1.0)),
    halfPixel(quad + vec2(2.0, 1.0)),
    halfPixel(quad + vec2(0.0, -1.0)),
    halfPixel(quad + vec2(1.0, -1.0)),
    halfPixel(quad + vec2(0.0, 2.0)),
    halfPixel(quad + vec2(1.0, 2.0))
  );
}

vec4 secondDifference(vec4 a, vec4 b, vec4 c) {
  return abs(a - 2.0 * b + c);
}

/// How much the half picture curves around a quad. Twin: optics/rays/between-pixels.ts, interpolateQuad
float curvatureOf(Surroundings s) {
  vec4 across = max(
    max(secondDifference(s.leftOfA, s.a, s.b), secondDifference(s.a, s.b, s.rightOfB)),
    max(secondDifference(s.leftOfC, s.c, s.d), secondDifference(s.c, s.d, s.rightOfD))
  );
  vec4 down = max(
    max(secondDifference(s.belowA, s.a, s.c), secondDifference(s.a, s.c, s.aboveC)),
    max(secondDifference(s.belowB, s.b, s.d), secondDifference(s.b, s.d, s.aboveD))
  );
  vec4 curvatures = max(across, down);
  return max(max(curvatures.r, curvatures.g), max(curvatures.b, curvatures.a));
}

/// The colour of one of a quad's pixels. place: 0 or 1 across and down. Twin: optics/rays/between-pixels.ts, interpolateQuad
vec4 interpolateBetween(Surroundings s, vec2 place) {
  vec4 across = (9.0 * (s.a + s.b) - s.leftOfA - s.rightOfB) / 16.0;
  vec4 down = (9.0 * (s.a + s.c) - s.belowA - s.aboveC) / 16.0;
  vec4 outer = s.leftOfA + s.rightOfB + s.leftOfC + s.rightOfD + s.belowA + s.belowB + s.aboveC + s.aboveD;
  vec4 amid = (10.0 * (s.a + s.b + s.c + s.d) - outer) / 32.0;
  return mix(mix(s.a, across, place.x), mix(down, amid, place.x), place.y);
}
