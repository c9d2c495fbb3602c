/// Means of extinction times colour, and of extinction, over spans of values, per reference length: columns by the
/// middle of the span, rows by the square root of its width. Twin: optics/preintegration-table.ts
uniform sampler2D uTransferFunction;

/// Columns and rows of the table.
uniform vec2 uTableSize;

/// Means below and above the domain.
uniform vec4 uTableFirst;
uniform vec4 uTableLast;

/// Cube roots of the opacity that a voxel may have between two values, see optics/substep-table.ts
uniform sampler2D uSubstepTable;

/// No step is cut into more substeps.
uniform float uMaxSubsteps;

/// Mean over a span inside the domain; middle, width: shares of the domain.
vec4 fetchMean(float middle, float width) {
  vec2 texel = vec2(middle, sqrt(width)) * (uTableSize - 1.0);
#if TABLE_IN_SHADER
  vec2 low = min(floor(texel), uTableSize - 2.0);
  vec2 upper = texel - low;
  vec2 from = (low + 0.5) / uTableSize;
  vec2 to = (low + 1.5) / uTableSize;
  vec4 narrow = mix(texture2D(uTransferFunction, from), texture2D(uTransferFunction, vec2(to.x, from.y)), upper.x);
  vec4 wide = mix(texture2D(uTransferFunction, vec2(from.x, to.y)), texture2D(uTransferFunction, to), upper.x);
  return mix(narrow, wide, upper.y);
#else
  return texture2D(uTransferFunction, (texel + 0.5) / uTableSize);
#endif
}

/// Mean over any span; from, to: shares of the domain. Twin: optics/preintegration-table.ts, lookUpSpan
vec4 meanOverSpan(float from, float to) {
  float a = min(from, to);
  float b = max(from, to);
  if (a >= 1.0) return uTableLast;
  if (b < 0.0) return uTableFirst;
  float start = clamp(a, 0.0, 1.0);
  float end = clamp(b, 0.0, 1.0);
  vec4 inside = fetchMean(0.5 * (start + end), end - start);
  if (a >= 0.0 && b <= 1.0) return inside;
  float below = max(0.0, min(b, 0.0) - a) / (b - a);
  float above = max(0.0, b - max(a, 1.0)) / (b - a);
  return inside * max(0.0, 1.0 - below - above) + uTableFirst * below + uTableLast * above;
}

/// What a length of constant mean emits and hides; ratio: length / reference length. Twin: optics/segment.ts, attenuate
vec4 attenuate(vec4 mean, float ratio) {
  float depth = mean.a * ratio;
  if (depth <= 0.0) return vec4(0.0);
  // 1 - exp(-x) has no digits left for small x.
  float alpha = depth < 1.0e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
  return vec4(mean.rgb * (alpha / mean.a), alpha);
}

/// Into how many substeps a step is cut between whose ends the value runs from one share of the domain to another;
/// visible: share that reaches the eye. Twin: optics/segment.ts, countSubsteps
float countSubsteps(float from, float to, float visible) {
  if (uMaxSubsteps < 1.5) return 1.0;
  float a = clamp((min(from, to) - SUBSTEP_TABLE_FROM) / SUBSTEP_TABLE_WIDTH, 0.0, 1.0);
  float b = clamp((max(from, to) - SUBSTEP_TABLE_FROM) / SUBSTEP_TABLE_WIDTH, 0.0, 1.0);
  vec2 size = vec2(SUBSTEP_TABLE_COLUMNS, SUBSTEP_TABLE_ROWS);
  vec2 texel = floor(vec2(0.5 * (a + b), sqrt(b - a)) * (size - 1.0) + 0.5);
  float root = texture2D(uSubstepTable, (texel + 0.5) / size).r;
  return clamp(ceil(SUBSTEPS_PER_ROOT * root * sqrt(visible)), 1.0, uMaxSubsteps);
}
