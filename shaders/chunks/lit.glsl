/// 1 where there is a light at the eye.
uniform float uHeadlight;

/// Unit-cube direction to world direction.
uniform mat3 uUnitToWorld;

/// Directions in which values grow to world directions.
uniform mat3 uNormalToWorld;

/// 1 / the change from voxel to voxel, as a share of the domain, below which a field is flat. Twin: optics/gradient.ts, flatChange
uniform float uPerFlat;

/// Of a place of the unit cube, voxels from the low faces of the region that is shown, a column each; its size in the last one.
uniform mat4 uRegionInVoxels;

/// The end of a segment that has been shaded last: it is where the next one begins.
vec3 shadedPoint = vec3(-9.0);
Shade shadedLast = Shade(vec3(1.0), vec3(0.0));

/// Six taps, as a loop: each text of one takes long to compile. Twin: optics/gradient.ts, differ
vec3 changePerVoxel(Sample known, vec3 from) {
  vec3 steps = tapSteps(from);
  vec3 sums = vec3(0.0);
  vec3 counts = vec3(0.0);
  for (int i = 0; i < 6; i++) {
    float axis = floor(0.5 * float(i) + 0.01);
    float side = float(i) - 2.0 * axis < 0.5 ? -1.0 : 1.0;
    vec3 unit = vec3(equal(vec3(axis), vec3(0.0, 1.0, 2.0)));
    float stored;
    bool valid = tapField(from + side * unit * steps, stored);
    float value = toShare(stored);
#if NO_DATA
    if (!valid) continue;
#endif
#if FOLDS
    if (isFolded(known.value, value)) continue;
#endif
    sums += side * (value - known.value) * unit;
    counts += unit;
  }
  return sums / max(counts, 1.0);
}

/// Voxels from the nearest face of a box; negative outside. low: from its low faces.
float depthInBox(vec3 low, vec3 size) {
  vec3 depth = min(low, size - low);
  return min(min(depth.x, depth.y), depth.z);
}

/// 0 at a cut and beyond, 1 from a voxel inside on. Twin: optics/cut-fade.ts, fadeAtCuts
float fadeAtCuts(vec3 p) {
  float depth = depthInBox(p * uDimensions, uDimensions);
  depth = min(depth, depthInBox((vec4(p, 1.0) * uRegionInVoxels).xyz, uRegionInVoxels[3].xyz));
#if LIT_CUTS
  depth = min(depth, depthAtClips(p));
#endif
  return clamp(depth, 0.0, 1.0);
}

/// Twin: optics/lit.ts, shadeAt
Shade shadeSample(Sample known) {
  vec3 from = beginTaps(known.point);
  vec3 perVoxel = changePerVoxel(known, from) * uPerFlat;
  float g2 = dot(perVoxel, perVoxel);
  float weight = fadeAtCuts(known.point) * (1.0 - 1.0 / (1.0 + g2));
  vec3 grows = uNormalToWorld * growsTowards(known.point, from, perVoxel);
  vec3 normal = grows / max(length(grows), 1.0e-30);
  vec3 toEye = -normalize(uUnitToWorld * rayOfPixel().direction);
  float facing = abs(dot(normal, toEye));
  Shade shade = Shade(vec3(uMaterial.x + uHeadlight * uMaterial.y * facing), vec3(uHeadlight * uMaterial.z * pow(max(1.0e-6, facing), uMaterial.w)));
#if LIT_LIGHTS
  shade = shadeByLights(uUnitToWorld * (known.point - 0.5), normal, toEye, shade);
#endif
  return Shade(1.0 + weight * (shade.diffuse - 1.0), weight * shade.specular);
}

/// Light on the surfaces that a field has everywhere. Taps are taken only where something shows: what is left out changes a picture by
/// LEAST_LIT at most. Source: Lum, Wilson and Ma 2004. Twin: optics/lit.ts, litShade
vec4 litShade(Segment segment, vec4 seen) {
  Sample front = segment.front;
  Sample back = segment.back;
#if NO_DATA
  if (!hasData(front)) front = back;
  if (!hasData(back)) back = front;
#endif
  // By length, so that steps do not matter to what is lit.
  bool shows = segment.visible > LEAST_LIT && segment.visible * seen.a > LEAST_LIT * segment.span;
  Shade near = shadedLast;
  Shade far = shadedLast;
  float first = !shows ? 2.0 : front.point == shadedPoint ? 1.0 : 0.0;
  // One text for both ends.
  for (int i = 0; i < 2; i++) {
    float end = first + float(i);
    if (end > 1.5) break;
    Sample here = back;
    if (end < 0.5) here = front;
    far = shadeSample(here);
    if (end < 0.5) near = far;
  }
  if (!shows) return seen;
  shadedPoint = back.point;
  shadedLast = far;
  return vec4(min(vec3(seen.a), 0.5 * (seen.rgb * (near.diffuse + far.diffuse) + seen.a * (near.specular + far.specular))), seen.a);
}
