/// Stored values below this mean no data: the largest negative float replaces NaN, which shaders need not support.
#define NO_DATA_BELOW -3.0e38

#ifndef IN_VOXELS
#define IN_VOXELS(point) (point * uDimensions)
#define LAST_VOXEL (uDimensions - 1.0)
#endif

/// Tri-linear interpolation of the eight voxels around a place in voxels; value: stored. False if there is no data.
/// Twin: optics/rays/interpolate.ts
bool interpolateAt(vec3 place, out float value) {
  vec3 last = LAST_VOXEL;
  vec3 position = clamp(place - 0.5, vec3(0.0), last);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, last);
  vec3 upper = position - low;
  vec3 lower = 1.0 - upper;
#if NO_DATA
  // Sum the differences from one of the voxels, so that a constant stays exact to the last digit: the transfer function may jump there.
  float base = 0.0;
  float sum = 0.0;
  float weights = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    float number = float(corner);
    vec3 side = mod(floor(vec3(number, number / 2.0, number / 4.0) + 0.001), 2.0);
    float voxel = fetchVoxel(mix(low, high, side));
    vec3 weight = mix(lower, upper, side);
    if (voxel > NO_DATA_BELOW) {
      float product = weight.x * weight.y * weight.z;
      if (weights == 0.0) base = voxel;
      sum += product * (voxel - base);
      weights += product;
    }
    // End the loop at its bottom: if a loop ends at its top, software GL runs it once more for no ray.
    if (corner == 7) break;
  }
  value = base + sum / max(weights, 0.5);
  return weights >= 0.5;
#else
  float v000 = fetchVoxel(low);
  float v100 = fetchVoxel(vec3(high.x, low.yz));
  float v010 = fetchVoxel(vec3(low.x, high.y, low.z));
  float v110 = fetchVoxel(vec3(high.xy, low.z));
  float v001 = fetchVoxel(vec3(low.xy, high.z));
  float v101 = fetchVoxel(vec3(high.x, low.y, high.z));
  float v011 = fetchVoxel(vec3(low.x, high.yz));
  float v111 = fetchVoxel(high);
  // mix() does not keep a constant exact to the last digit, and the transfer function may jump there.
  vec4 alongX = vec4(v000, v010, v001, v011) + upper.x * (vec4(v100, v110, v101, v111) - vec4(v000, v010, v001, v011));
  vec2 alongY = alongX.xz + upper.y * (alongX.yw - alongX.xz);
  value = alongY.x + upper.z * (alongY.y - alongY.x);
  return true;
#endif
}

/// The same at a point of the unit cube.
bool interpolateVoxels(vec3 p, out float value) {
  return interpolateAt(IN_VOXELS(p), value);
}
