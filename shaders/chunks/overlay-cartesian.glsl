/// Stored value of a texel: as decodeTexel, of a texture that need not hold what the volume's holds.
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

/// Of the eight voxels around a place those that have data, by their weights; false where these are less than half. Twin: optics/interpolate.ts
bool interpolateOverlay(vec3 q, out float stored) {
  vec3 position = clamp(q * uOverlayDimensions - 0.5, vec3(0.0), uOverlayDimensions - 1.0);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, uOverlayDimensions - 1.0);
  vec3 upper = position - low;
  float base = 0.0;
  float sum = 0.0;
  float weights = 0.0;
  for (int corner = 0; corner < 8; corner++) {
    float number = float(corner);
    vec3 side = mod(floor(vec3(number, number / 2.0, number / 4.0) + 0.001), 2.0);
    float voxel = decodeOverlay(fetchOverlay(mix(low, high, side)));
    vec3 weight = mix(1.0 - upper, upper, side);
    // The largest finite float stands for NaN.
    if (voxel > -3.0e38) {
      float product = weight.x * weight.y * weight.z;
      if (weights == 0.0) base = voxel;
      sum += product * (voxel - base);
      weights += product;
    }
  }
  stored = base + sum / max(weights, 0.5);
  return weights >= 0.5;
}

/// Stored value of the layer at a place of the volume's unit cube. False outside of its grid, and where it has no data.
bool sampleOverlay(vec3 p, out float stored) {
  vec3 q = (uToOverlay * vec4(p, 1.0)).xyz;
  stored = 0.0;
  if (any(lessThan(q, vec3(-OVERLAY_SLACK))) || any(greaterThan(q, vec3(1.0 + OVERLAY_SLACK)))) return false;
#if OVERLAY_FILTER
  stored = decodeOverlay(filterOverlay(q));
  return true;
#else
  return interpolateOverlay(q, stored);
#endif
}
