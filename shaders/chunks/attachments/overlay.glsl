/// Means of the layer's transfer function, stored like those of the volume in uTransferFunction.
uniform sampler2D uOverlayTable;

/// Columns and rows of the table; means below and above the domain.
uniform vec2 uOverlayTableSize;
uniform vec4 uOverlayFirst;
uniform vec4 uOverlayLast;

#if OVERLAY_FOLDS
/// Values that differ by more than this share of the domain are on two sides of a fold.
uniform float uOverlayFold;
#endif

#if OVERLAY_COLOR
/// 1 / the extinction at which the layer's colour replaces the volume's colour completely.
uniform float uOverlayWeight;

/// The colour of the volume where the layer has no data, and the share of that colour.
uniform vec4 uOverlayMissing;
#else
/// Reference lengths per bounding diameter, times both opacity factors.
uniform float uOverlayScale;
#endif

/// Mean over a span inside the domain; middle, width: shares of the domain.
vec4 fetchOverlayMean(float middle, float width) {
  vec2 texel = vec2(middle, sqrt(width)) * (uOverlayTableSize - 1.0);
#if OVERLAY_TABLE_FILTER
  return texture2D(uOverlayTable, (texel + 0.5) / uOverlayTableSize);
#else
  vec2 low = min(floor(texel), uOverlayTableSize - 2.0);
  vec2 share = texel - low;
  vec2 at = (low + 0.5) / uOverlayTableSize;
  vec2 next = at + 1.0 / uOverlayTableSize;
  vec4 narrow = mix(texture2D(uOverlayTable, at), texture2D(uOverlayTable, vec2(next.x, at.y)), share.x);
  vec4 wide = mix(texture2D(uOverlayTable, vec2(at.x, next.y)), texture2D(uOverlayTable, next), share.x);
  return mix(narrow, wide, share.y);
#endif
}

/// Mean over any span; from, to: shares of the domain. Twin: optics/transfer/preintegration-table.ts, lookUpSpan
vec4 overlayMean(float from, float to) {
  float a = min(from, to);
  float b = max(from, to);
  float start = clamp(a, 0.0, 1.0);
  float end = clamp(b, 0.0, 1.0);
  // The same as in meanOverSpan.
  float perWidth = 1.0 / max(b - a, 1.0e-30);
  float below = b < 0.0 ? 1.0 : max(0.0, -a) * perWidth;
  float above = a >= 1.0 ? 1.0 : max(0.0, b - 1.0) * perWidth;
  return fetchOverlayMean(0.5 * (start + end), end - start) * max(0.0, 1.0 - below - above) + uOverlayFirst * below + uOverlayLast * above;
}

/// Either two media in one place: their extinctions add, and so does their light. Or the volume's extinction with the layer's colour.
/// If one end has no data of the layer, the half next to it has no layer. Twin: optics/attachments/overlay.ts, overlayShade
vec4 overlayAppearanceShade(Segment segment, vec4 seen) {
  float from = segment.front.overlay;
  float to = segment.back.overlay;
  bool hasFrom = from >= MIN_OVERLAY;
  bool hasTo = to >= MIN_OVERLAY;
  float known = (hasFrom ? 0.5 : 0.0) + (hasTo ? 0.5 : 0.0);
  if (!hasFrom) from = to;
  if (!hasTo) to = from;
#if OVERLAY_FOLDS
  bool isFold = abs(to - from) > uOverlayFold;
  vec4 mean = overlayMean(from, isFold ? from : to);
  if (isFold) mean = 0.5 * (mean + overlayMean(to, to));
#else
  vec4 mean = overlayMean(from, to);
#endif
  vec3 color = mean.rgb / max(mean.a, 1.0e-30);
#if OVERLAY_COLOR
  float own = known * min(1.0, mean.a * uOverlayWeight);
  float missing = (1.0 - known) * uOverlayMissing.a;
  return vec4((1.0 - own - missing) * seen.rgb + seen.a * (own * color + missing * uOverlayMissing.rgb), seen.a);
#else
  float depth = min(OVERLAY_DEEPEST, known * segment.span * uOverlayScale * mean.a);
  if (depth <= 0.0) return seen;
  float before = min(OVERLAY_DEEPEST, depthOf(seen.a));
  float opacity = opacityOf(before + depth);
  return vec4(opacity / (before + depth) * (before * seen.rgb / max(seen.a, 1.0e-30) + depth * color), opacity);
#endif
}
