/// Stored value at a point, from the sums that the device's filter gives; p: unit cube. False if there is no data.
/// Twin: optics/rays/interpolate.ts
bool sampleVolume(vec3 p, out float value) {
#if FILTER_IN_SHADER
  return interpolateVoxels(p, value);
#else
#if TEXTURE_3D
  vec4 texel = texture(uVolume, p);
#else
  vec4 texel = filterTexel(p);
#endif
  float weights = dot(texel, uWeightChannels);
  value = uWeighedFrom + dot(texel, uValueChannels) / max(weights, 0.5);
  return weights >= 0.5;
#endif
}
