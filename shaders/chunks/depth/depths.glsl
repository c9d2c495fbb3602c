/// 1 - exp(-depth); for small depths by a series, because the difference would have no digits left.
float opacityOf(float depth) {
  return depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
}

/// Optical depth of an opacity; for small opacities by a series, because 1 - opacity would have no digits left.
float depthOf(float opacity) {
  return opacity < 1.0e-2 ? opacity * (1.0 + opacity * (0.5 + opacity / 3.0)) : -log(max(1.0 - opacity, 1.0e-30));
}
