/// Samples of the layer, on its own grid; slices are stored as tiles.
uniform sampler2D uOverlay;

/// Columns and rows of tiles; texels across and down.
uniform vec4 uOverlayMosaic;

/// First texel of a slice's tile, in texels.
vec2 overlayTile(float slice) {
  float row = floor((slice + 0.5) / uOverlayMosaic.x);
  return vec2(slice - row * uOverlayMosaic.x, row) * uOverlayDimensions.xy;
}

vec4 fetchOverlay(vec3 index) {
  return texture2D(uOverlay, (overlayTile(index.z) + index.xy + 0.5) / uOverlayMosaic.zw);
}

/// A texel, interpolated from two bilinear filters of the device, which stay half a texel inside their tiles; q: in the layer's unit cube.
vec4 filterOverlay(vec3 q) {
  vec2 inTile = clamp(q.xy * uOverlayDimensions.xy, vec2(0.5), uOverlayDimensions.xy - 0.5);
  float slice = clamp(q.z * uOverlayDimensions.z - 0.5, 0.0, uOverlayDimensions.z - 1.0);
  float below = floor(slice);
  float above = min(below + 1.0, uOverlayDimensions.z - 1.0);
  vec4 lower = texture2D(uOverlay, (overlayTile(below) + inTile) / uOverlayMosaic.zw);
  vec4 upper = texture2D(uOverlay, (overlayTile(above) + inTile) / uOverlayMosaic.zw);
  return lower + (slice - below) * (upper - lower);
}
