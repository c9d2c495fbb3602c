/// Cube roots of the maximum opacity of a voxel between two values, see optics/transfer/substep-table.ts
uniform sampler2D uSubstepTable;

/// The maximum number of substeps of a step.
uniform float uMaxSubsteps;

/// The number of substeps of a step. from, to: the values at its ends, as shares of the domain;
/// visible: the share of light that reaches the eye. Twin: optics/rays/segment.ts, countSubsteps
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
