/// 1 if there is a light at the eye, else 0.
uniform float uHeadlight;

/// From a unit-cube direction to a world direction.
uniform mat3 uUnitToWorld;

/// From a direction in which values grow to a world direction.
uniform mat3 uNormalToWorld;

#ifndef FINEST_VOXELS
#define FINEST_VOXELS uDimensions
#endif

/// 0 at a cut and beyond it, 1 from one voxel inside on. Twin: optics/rays/cut-fade.ts, fadeAtCuts
float fadeAtCuts(vec3 p) {
  float depth = depthInBox(p * FINEST_VOXELS, FINEST_VOXELS);
#if LIT_CUTS
  depth = min(depth, depthAtClips(p));
#endif
  return clamp(depth, 0.0, 1.0);
}

/// perFlat: 1 / the change from voxel to voxel, as a share of the domain, below which a field is flat; material: as uMaterial.
/// Twin: optics/rays/lit.ts, lightAt
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
