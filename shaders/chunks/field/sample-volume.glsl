/// Stored value at a point; p: unit cube. False if there is no data.
bool sampleVolume(vec3 p, out float value) {
#if FILTER_IN_SHADER
  return interpolateVoxels(p, value);
#else
  value = filterVolume(p);
  return true;
#endif
}
