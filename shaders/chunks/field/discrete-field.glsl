/// Stored values below this are no data: the largest finite float stands for NaN, which shaders may not know.
#define NO_DATA_BELOW -3.0e38

/// Stored value at a point, of the eight voxels around it the one that most of them vote for; p: unit cube. False where there is no data.
/// Twin: optics/vote.ts
bool sampleVolume(vec3 p, out float value) {
  vec3 position = clamp(p * uDimensions - 0.5, vec3(0.0), uDimensions - 1.0);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, uDimensions - 1.0);
  vec4 below = vec4(fetchVoxel(low), fetchVoxel(vec3(high.x, low.yz)), fetchVoxel(vec3(low.x, high.y, low.z)), fetchVoxel(vec3(high.xy, low.z)));
  vec4 above = vec4(fetchVoxel(vec3(low.xy, high.z)), fetchVoxel(vec3(high.x, low.y, high.z)), fetchVoxel(vec3(low.x, high.yz)), fetchVoxel(high));
  value = voteOfCorners(below, above, position - low);
  return value > NO_DATA_BELOW;
}

/// Between two labels there is nothing.
bool isFolded(float from, float to) {
  return from != to;
}
