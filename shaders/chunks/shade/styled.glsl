/// The end of the last segment that was styled: the next segment begins there.
vec3 styledPoint = vec3(-9.0);
Styled styledLast = Styled(vec3(1.0), vec3(0.0), 1.0);

/// -log(1 - opacity), and its inverse: for small numbers by series, because the plain formulas would have no digits left.
float styleDepth(float opacity) {
  return opacity < 1.0e-2 ? opacity * (1.0 + opacity * (0.5 + opacity / 3.0)) : -log(max(1.0 - opacity, 1.0e-30));
}

float styleOpacity(float depth) {
  return depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
}

/// Applies X3D's rendering styles to a segment: the mean of both ends. As in lit.glsl, taps are taken only where something shows.
/// Twin: optics/rays/styled.ts, styledShade
vec4 styledShade(Segment segment, vec4 seen) {
  Sample front = segment.front;
  Sample back = segment.back;
  float share = 1.0;
#if NO_DATA
  // Half of the segment has data of the volume. If neither end has data, a layer may show along the whole segment.
  if (hasData(front) != hasData(back)) share = 0.5;
  if (!hasData(front)) front = back;
  if (!hasData(back)) back = front;
#endif
  // Rounding may make the span of a segment between two planes of voxels negative: it shows nothing.
  bool shows = seen.a > 0.0 && segment.visible > MIN_LIT && segment.visible * seen.a > MIN_LIT * segment.span;
  Styled near = styledLast;
  Styled far = styledLast;
  float first = !shows ? 2.0 : front.point == styledPoint ? 1.0 : 0.0;
  // A loop, so that the program has this code only once for both ends.
  for (int i = 0; i < 2; i++) {
    float end = first + float(i);
    if (end > 1.5) break;
    Sample here = back;
    if (end < 0.5) here = front;
    far = styleSample(here);
    if (end < 0.5) near = far;
  }
  if (!shows) return seen;
  styledPoint = back.point;
  styledLast = far;
  // The length in reference lengths, times the opacity factor.
  float ratio = max(share * (segment.span * uOpticalScale), 1.0e-30);
  float own = styleOpacity(styleDepth(seen.a) / ratio);
  float alpha = styleOpacity(styleDepth(min(STYLE_MAX, 0.5 * own * (near.opacity + far.opacity))) * ratio);
  vec3 color = 0.5 * ((seen.rgb / seen.a) * (near.gain + far.gain) + near.more + far.more);
  return vec4(alpha * min(vec3(1.0), color), alpha);
}
