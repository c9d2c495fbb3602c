/// 1 where there is a light at the eye.
uniform float uHeadlight;

/// Unit-cube direction to world direction.
uniform mat3 uUnitToWorld;

/// Directions in which values grow to world directions.
uniform mat3 uNormalToWorld;

/// Of a place of the unit cube, voxels from the low faces of the region that is shown, a column each; its size in the last one.
uniform mat4 uRegionInVoxels;

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
    // Of a place without data nothing is known that could face anywhere.
    if (!valid || !hasData(known)) continue;
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

/// perFlat: 1 / the change from voxel to voxel, as a share of the domain, below which a field is flat; material: as uMaterial. Twin: optics/lit.ts, lightAt
Shade shadeSample(Sample known, float perFlat, vec4 material) {
  vec3 from = beginTaps(known.point);
  vec3 perVoxel = changePerVoxel(known, from) * perFlat;
  float g2 = dot(perVoxel, perVoxel);
  float weight = fadeAtCuts(known.point) * (1.0 - 1.0 / (1.0 + g2));
  vec3 grows = uNormalToWorld * growsTowards(known.point, from, perVoxel);
  vec3 normal = grows / max(length(grows), 1.0e-30);
  vec3 toEye = -normalize(uUnitToWorld * rayOfPixel().direction);
  float facing = abs(dot(normal, toEye));
  Shade shade = Shade(vec3(material.x + uHeadlight * material.y * facing), vec3(uHeadlight * material.z * pow(max(1.0e-6, facing), material.w)));
#if LIT_LIGHTS
  shade = shadeByLights(uUnitToWorld * (known.point - 0.5), normal, toEye, material, shade);
#endif
  return Shade(1.0 + weight * (shade.diffuse - 1.0), weight * shade.specular);
}
