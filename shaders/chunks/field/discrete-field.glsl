/// Stored values below this mean no data: the largest negative float replaces NaN, which shaders need not support.
#define NO_DATA_BELOW -3.0e38

/// The stored value at a point: the value with the most votes of the eight voxels around it; p: unit cube. False if there is no data.
/// Twin: optics/rays/vote.ts
bool sampleVolume(vec3 p, out float value) {
  vec3 position = clamp(p * uDimensions - 0.5, vec3(0.0), uDimensions - 1.0);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, uDimensions - 1.0);
  vec4 below = vec4(fetchVoxel(low), fetchVoxel(vec3(high.x, low.yz)), fetchVoxel(vec3(low.x, high.y, low.z)), fetchVoxel(vec3(high.xy, low.z)));
  vec4 above = vec4(fetchVoxel(vec3(low.xy, high.z)), fetchVoxel(vec3(high.x, low.y, high.z)), fetchVoxel(vec3(low.x, high.yz)), fetchVoxel(high));
  value = voteOfCorners(below, above, position - low);
  return value > NO_DATA_BELOW;
}

/// There are no values between two labels.
bool isFolded(float from, float to) {
  return from != to;
}
