/// Light of the channels of each voxel: red, green, blue and brightness; slices are stored as tiles.
uniform sampler2D uChannels;

/// Columns and rows of tiles; texels across and down.
uniform vec4 uChannelMosaic;

/// First texel of a slice's tile, in texels.
vec2 channelTile(float slice) {
  float row = floor((slice + 0.5) / uChannelMosaic.x);
  return vec2(slice - row * uChannelMosaic.x, row) * uDimensions.xy;
}

/// Interpolated from two bilinear filters of the device, which stay half a texel inside their tiles.
vec4 filterChannels(vec3 p) {
  vec2 inTile = clamp(p.xy * uDimensions.xy, vec2(0.5), uDimensions.xy - 0.5);
  float slice = clamp(p.z * uDimensions.z - 0.5, 0.0, uDimensions.z - 1.0);
  float below = floor(slice);
  float above = min(below + 1.0, uDimensions.z - 1.0);
  vec4 lower = texture2D(uChannels, (channelTile(below) + inTile) / uChannelMosaic.zw);
  vec4 upper = texture2D(uChannels, (channelTile(above) + inTile) / uChannelMosaic.zw);
  return lower + (slice - below) * (upper - lower);
}
