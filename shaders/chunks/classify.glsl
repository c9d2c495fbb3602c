/// Reference lengths per bounding diameter, times the opacity factor.
uniform float uOpticalScale;

/// Of all values.
uniform float uLargestOpacity;

/// What a segment shows of which one end or both may have no data: the half next to an end without data is empty. Where
/// a velocity folds in between, half of it is of either end.
/// Twin: optics/ray-classify.ts, classifyByMeans
vec4 classifySegment(Segment segment) {
  Sample front = segment.front;
  Sample back = segment.back;
  float from = hasData(front) ? front.value : back.value;
  float to = hasData(back) ? back.value : front.value;
  float share = (hasData(front) ? 0.5 : 0.0) + (hasData(back) ? 0.5 : 0.0);
#if FOLDS
  bool isFold = isFolded(from, to);
  vec4 mean = meanOverSpan(from, isFold ? from : to);
  if (isFold) mean = 0.5 * (mean + meanOverSpan(to, to));
#else
  vec4 mean = meanOverSpan(from, to);
#endif
  return attenuate(mean, share * (segment.span * uOpticalScale));
}

/// Colour of a value, where the largest opacity of all counts as 1: neither lengths nor steps matter to it.
vec4 classifyValue(float value) {
  return attenuate(meanOverSpan(value, value), 1.0) / uLargestOpacity;
}
