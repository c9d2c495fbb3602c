/// Samples of the layer, on its own grid.
uniform sampler3D uOverlay;

vec4 fetchOverlay(vec3 index) {
  return texelFetch(uOverlay, ivec3(index + 0.5), 0);
}

/// A texel, interpolated by the device's own tri-linear filter; q: in the layer's unit cube.
vec4 filterOverlay(vec3 q) {
  return texture(uOverlay, q);
}
