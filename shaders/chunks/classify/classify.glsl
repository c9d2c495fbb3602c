/// Reference lengths per bounding diameter, times the opacity factor.
uniform float uOpticalScale;

/// The largest opacity that any value has.
uniform float uLargestOpacity;

/// What a segment shows. If an end has no data, the half next to it is empty. If a velocity folds between the ends, each half has
/// the value of its end.
/// Twin: optics/rays/ray-classify.ts, classifyByMeans
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

/// The colour of a value, scaled so that the largest opacity of all values counts as 1: it does not depend on lengths and steps.
vec4 classifyValue(float value) {
  return attenuate(emissionAt(value), 1.0) / uLargestOpacity;
}
