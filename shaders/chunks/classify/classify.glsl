/// Reference lengths per bounding diameter, times the opacity factor.
uniform float uOpticalScale;

/// Of all values.
uniform float uLargestOpacity;

/// What a segment shows of which one end or both may have no data: the half next to an end without data is empty. Where
/// a velocity folds in between, half of it is of either end.
/// Twin: optics/ray-classify.ts, classifyByMeans
vec4 classifySegment(Segment segment) {
  Sample from = segment.front;
  Sample to = segment.back;
#if NO_DATA
  float share = (hasData(from) ? 0.5 : 0.0) + (hasData(to) ? 0.5 : 0.0);
  if (!hasData(from)) from = to;
  if (!hasData(to)) to = from;
#else
  float share = 1.0;
#endif
#if FOLDS
  bool isFold = isFolded(from.value, to.value);
  Sample until = to;
  if (isFold) until = from;
  vec4 mean = meanOfSamples(from, until);
  if (isFold) mean = 0.5 * (mean + meanOfSamples(to, to));
#else
  vec4 mean = meanOfSamples(from, to);
#endif
  return attenuate(mean, share * (segment.span * uOpticalScale));
}

/// Colour of a value, where the largest opacity of all counts as 1: neither lengths nor steps matter to it.
vec4 classifyValue(float value) {
  return attenuate(emissionAt(value), 1.0) / uLargestOpacity;
}
