/// Emission and opacity of a length with a constant mean; ratio: length / reference length. Twin: optics/rays/segment.ts, attenuate
vec4 attenuate(vec4 mean, float ratio) {
  float depth = mean.a * ratio;
  if (depth <= 0.0) return vec4(0.0);
  // For small x by a series: 1 - exp(-x) would have no digits left.
  float alpha = depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
  return vec4(mean.rgb * (alpha * (1.0 / mean.a)), alpha);
}
