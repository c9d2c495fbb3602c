/// Cube roots of the opacity that a voxel may have between two values, see optics/substep-table.ts
uniform sampler2D uSubstepTable;

/// No step is cut into more substeps.
uniform float uMaxSubsteps;

/// What a length of constant mean emits and hides; ratio: length / reference length. Twin: optics/segment.ts, attenuate
vec4 attenuate(vec4 mean, float ratio) {
  float depth = mean.a * ratio;
  if (depth <= 0.0) return vec4(0.0);
  // 1 - exp(-x) has no digits left for small x.
  float alpha = depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
  return vec4(mean.rgb * (alpha * (1.0 / mean.a)), alpha);
}

/// Into how many substeps a step is cut between whose ends the value runs from one share of the domain to another;
/// visible: share that reaches the eye. Twin: optics/segment.ts, countSubsteps
float countSubsteps(float from, float to, float visible) {
  if (uMaxSubsteps < 1.5) return 1.0;
  float a = clamp((min(from, to) - SUBSTEP_TABLE_FROM) / SUBSTEP_TABLE_WIDTH, 0.0, 1.0);
  float b = clamp((max(from, to) - SUBSTEP_TABLE_FROM) / SUBSTEP_TABLE_WIDTH, 0.0, 1.0);
  vec2 size = vec2(SUBSTEP_TABLE_COLUMNS, SUBSTEP_TABLE_ROWS);
  vec2 texel = floor(vec2(0.5 * (a + b), sqrt(b - a)) * (size - 1.0) + 0.5);
#ifdef FUNCTIONS
  texel.y += whichFunction * size.y;
  size.y *= FUNCTIONS;
#endif
  float root = texture2D(uSubstepTable, (texel + 0.5) / size).r;
  return clamp(ceil(SUBSTEPS_PER_ROOT * root * sqrt(visible)), 1.0, uMaxSubsteps);
}
