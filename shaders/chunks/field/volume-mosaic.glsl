uniform sampler2D uVolume;

/// Columns and rows of tiles; texels across and down.
uniform vec4 uMosaic;

/// First texel of a slice's tile, in texels.
vec2 tileOrigin(float slice) {
  float row = floor((slice + 0.5) / uMosaic.x);
  return vec2(slice - row * uMosaic.x, row) * uDimensions.xy;
}

/// Stored value of one voxel; index: whole numbers, inside the grid.
float fetchVoxel(vec3 index) {
  vec4 texel = texture2D(uVolume, (tileOrigin(index.z) + index.xy + 0.5) / uMosaic.zw);
#ifdef WEIGHED
  if (dot(texel, uWeightChannels) < 0.5) return -3.4e38; // Below NO_DATA_BELOW.
  return uWeighedFrom + dot(texel, uValueChannels);
#else
  return decodeTexel(texel);
#endif
}

/// A texel, interpolated from two bilinear filters of the device, which stay half a texel inside their tiles; p: unit cube.
/// Source: paper.md, equations 5 to 17, corrected
vec4 filterTexel(vec3 p) {
  vec2 inTile = clamp(p.xy * uDimensions.xy, vec2(0.5), uDimensions.xy - 0.5);
  float slice = clamp(p.z * uDimensions.z - 0.5, 0.0, uDimensions.z - 1.0);
  float below = floor(slice);
  float above = min(below + 1.0, uDimensions.z - 1.0);
  vec4 lower = texture2D(uVolume, (tileOrigin(below) + inTile) / uMosaic.zw);
  vec4 upper = texture2D(uVolume, (tileOrigin(above) + inTile) / uMosaic.zw);
  return lower + (slice - below) * (upper - lower);
}

/// Stored value, interpolated by the device; p: unit cube.
float filterVolume(vec3 p) {
  return decodeTexel(filterTexel(p));
}
