/// Means of extinction times colour, and of extinction, over spans of values, per reference length: columns by the
/// middle of the span, rows by the square root of its width. Twin: optics/transfer/preintegration-table.ts
uniform sampler2D uTransferFunction;

/// Columns and rows of the table.
uniform vec2 uTableSize;

/// Means below and above the domain.
uniform vec4 uTableFirst;
uniform vec4 uTableLast;

/// Mean over a span inside the domain; middle, width: shares of the domain.
vec4 fetchMean(float middle, float width) {
  vec2 texel = vec2(middle, sqrt(width)) * (uTableSize - 1.0);
  return texture2D(uTransferFunction, (texel + 0.5) / uTableSize);
}

/// Mean over any span; from, to: shares of the domain. Twin: optics/transfer/preintegration-table.ts, lookUpSpan
vec4 meanOverSpan(float from, float to) {
  float a = min(from, to);
  float b = max(from, to);
  float start = clamp(a, 0.0, 1.0);
  float end = clamp(b, 0.0, 1.0);
  // The shares of the span below and above the domain; 1 if the whole span is beyond it.
  float perWidth = 1.0 / max(b - a, 1.0e-30);
  float below = b < 0.0 ? 1.0 : max(0.0, -a) * perWidth;
  float above = a >= 1.0 ? 1.0 : max(0.0, b - 1.0) * perWidth;
  return fetchMean(0.5 * (start + end), end - start) * max(0.0, 1.0 - below - above) + uTableFirst * below + uTableLast * above;
}

vec4 meanOfSamples(Sample from, Sample to) {
  return meanOverSpan(from.value, to.value);
}

vec4 emissionAt(float share) {
  return meanOverSpan(share, share);
}
