/// 1 / the change from voxel to voxel, as a share of the domain, below which a field is flat. Twin: optics/rays/gradient.ts, flatChange
uniform float uPerFlat;

/// As uMaterial, for flat places, which have no surface.
uniform vec4 uFogMaterial;

/// The end of the last segment that was shaded: the next segment begins there.
vec3 shadedPoint = vec3(-9.0);
Shade shadedLast = Shade(vec3(1.0), vec3(0.0));

/// Light on every place of a field, with its gradient as the normal of a surface. Taps are taken only where something shows: places that
/// are left out change a picture by MIN_LIT at most. Source: Lum, Wilson and Ma 2004. Twin: optics/rays/lit.ts, litShade
vec4 litShade(Segment segment, vec4 seen) {
  Sample front = segment.front;
  Sample back = segment.back;
#if NO_DATA
  if (!hasData(front)) front = back;
  if (!hasData(back)) back = front;
#endif
  // Per length, so that the step length does not decide what is lit.
  bool shows = segment.visible > MIN_LIT && segment.visible * seen.a > MIN_LIT * segment.span;
  Shade near = shadedLast;
  Shade far = shadedLast;
  float first = !shows ? 2.0 : front.point == shadedPoint ? 1.0 : 0.0;
  // A loop, so that the program has this code only once for both ends.
  for (int i = 0; i < 2; i++) {
    float end = first + float(i);
    if (end > 1.5) break;
    Sample here = back;
    if (end < 0.5) here = front;
    far = shadeSample(here, uPerFlat, uFogMaterial);
    if (end < 0.5) near = far;
    // End the loop at its bottom: see changePerVoxel.
    if (end > 0.5) break;
  }
  if (!shows) return seen;
  shadedPoint = back.point;
  shadedLast = far;
  return vec4(min(vec3(seen.a), 0.5 * (seen.rgb * (near.diffuse + far.diffuse) + seen.a * (near.specular + far.specular))), seen.a);
}
