/// Stored value of a texel: like decodeTexel, but the format of the layer's texture may differ from the volume's.
float decodeOverlay(vec4 texel) {
#if OVERLAY_TWO_BYTES
#if WEBGL2
  return texel.r * 255.0 + texel.g * 65280.0;
#else
  return texel.r * 255.0 + texel.a * 65280.0;
#endif
#else
  return texel.r;
#endif
}

float fetchOverlayVoxel(vec3 index) {
  return decodeOverlay(fetchOverlay(index));
}

/// Interpolates between those of the eight voxels around a place that have data; false if their weights sum to less than half.
/// Twin: optics/rays/interpolate.ts
bool interpolateOverlay(vec3 q, out float stored) {
  vec3 position = clamp(q * uOverlayDimensions - 0.5, vec3(0.0), uOverlayDimensions - 1.0);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, uOverlayDimensions - 1.0);
  vec3 upper = position - low;
  vec4 below = vec4(fetchOverlayVoxel(low), fetchOverlayVoxel(vec3(high.x, low.yz)), fetchOverlayVoxel(vec3(low.x, high.y, low.z)), fetchOverlayVoxel(vec3(high.xy, low.z)));
  vec4 above = vec4(fetchOverlayVoxel(vec3(low.xy, high.z)), fetchOverlayVoxel(vec3(high.x, low.y, high.z)), fetchOverlayVoxel(vec3(low.x, high.yz)), fetchOverlayVoxel(high));
  vec2 across = vec2(1.0 - upper.x, upper.x);
  vec4 face = vec4(across * (1.0 - upper.y), across * upper.y);
  // The largest negative float means no data.
  vec4 lower = face * (1.0 - upper.z) * step(-3.0e38, below);
  vec4 higher = face * upper.z * step(-3.0e38, above);
  // Sum the differences from a voxel that has data, so that a constant stays exact to the last digit.
  vec4 largest = max(below, above);
  float base = max(max(largest.x, largest.y), max(largest.z, largest.w));
  float weights = dot(lower + higher, vec4(1.0));
  stored = base + (dot(lower, below - base) + dot(higher, above - base)) / max(weights, 0.5);
  return weights >= 0.5;
}

#if OVERLAY_HOLES
/// The same as uValueChannels, uWeightChannels and uWeighedFrom.
uniform vec4 uOverlayValues;
uniform vec4 uOverlayWeights;
uniform float uOverlayFrom;
#endif

/// Stored value of the layer at a place of the volume's unit cube. False outside of the layer's grid, and if it has no data there.
bool sampleOverlay(vec3 p, out float stored) {
  vec3 q = (uToOverlay * vec4(p, 1.0)).xyz;
  stored = 0.0;
  if (any(lessThan(q, vec3(-OVERLAY_SLACK))) || any(greaterThan(q, vec3(1.0 + OVERLAY_SLACK)))) return false;
#if OVERLAY_HOLES
  // The weighted sum of values (0 for missing data), and the sum of the weights. Twin: optics/rays/interpolate.ts
  vec4 texel = filterOverlay(q);
  float weights = dot(texel, uOverlayWeights);
  stored = uOverlayFrom + dot(texel, uOverlayValues) / max(weights, 0.5);
  return weights >= 0.5;
#elif OVERLAY_FILTER
  stored = decodeOverlay(filterOverlay(q));
  return true;
#else
  return interpolateOverlay(q, stored);
#endif
}
