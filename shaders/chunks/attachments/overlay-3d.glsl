/// Samples of the layer, on a grid of its own.
uniform sampler3D uOverlay;

vec4 fetchOverlay(vec3 index) {
  return texelFetch(uOverlay, ivec3(index + 0.5), 0);
}

/// By the device's own tri-linear filter; q: the layer's unit cube.
vec4 filterOverlay(vec3 q) {
  return texture(uOverlay, q);
}
