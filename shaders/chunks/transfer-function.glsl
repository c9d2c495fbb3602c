/// Means of extinction times colour, and of extinction, over spans of values, per reference length: columns by the
/// middle of the span, rows by the square root of its width. Twin: optics/span-table.ts
uniform sampler2D uTransferFunction;

/// Columns and rows of the table.
uniform vec2 uTableSize;

/// Stored value to share of the table's domain: scale, offset.
uniform vec2 uTableDomain;

/// Means below and above the domain.
uniform vec4 uTableFirst;
uniform vec4 uTableLast;

/// Length of a voxel in reference lengths, times the opacity factor.
uniform float uVoxelRatio;

/// No step is cut into more parts.
uniform float uMostParts;

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

/// Mean over any span; from, to: shares of the domain. Twin: optics/span-table.ts, lookUpSpan
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

/// What a segment emits and hides on which the value runs from one share of the domain to another.
/// Twin: optics/segment.ts, classifySegment
vec4 classifySegment(float from, float to, float ratio) {
  vec4 mean = meanOverSpan(from, to);
  if (mean.a * ratio < ORDER_MATTERS_FROM_DEPTH || abs(to - from) < ORDER_MATTERS_FROM_SPAN) return attenuate(mean, ratio);
  vec4 accumulated = vec4(0.0);
  for (int i = 0; i < 4; i++) {
    float begin = float(i) * 0.25;
    vec4 quarter = meanOverSpan(mix(from, to, begin), mix(from, to, begin + 0.25));
    accumulated += (1.0 - accumulated.a) * attenuate(quarter, ratio * 0.25);
  }
  return accumulated;
}

/// Into how many parts a step is cut between whose ends the value runs from one share of the domain to another;
/// visible: share that reaches the eye. Twin: optics/segment.ts, countParts
float countParts(float from, float to, float visible) {
  float reach = REACH_OF_SPAN * abs(to - from) + REACH_OF_DOMAIN;
  float depth = meanOverSpan(min(from, to) - reach, max(from, to) + reach).a * uVoxelRatio;
  float seen = visible * (1.0 - exp(-depth));
  return clamp(ceil(PARTS_PER_ROOT * pow(max(seen, 1.0e-9), 1.0 / 3.0)), 1.0, uMostParts);
}
