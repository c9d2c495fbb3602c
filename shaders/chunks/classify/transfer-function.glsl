/// What a length of constant mean emits and hides; ratio: length / reference length. Twin: optics/segment.ts, attenuate
vec4 attenuate(vec4 mean, float ratio) {
  float depth = mean.a * ratio;
  if (depth <= 0.0) return vec4(0.0);
  // 1 - exp(-x) has no digits left for small x.
  float alpha = depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
  return vec4(mean.rgb * (alpha * (1.0 / mean.a)), alpha);
}
