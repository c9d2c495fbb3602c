/// Gathers the mean value of a ray over the length that has data. Twin: optics/rays/projection.ts, averageGather
struct Gathered {
  float mean;
  /// The length over which it is the mean.
  float span;
};

Gathered beginGathering() {
  return Gathered(0.0, 0.0);
}

/// Add to the running mean: the mean of a constant is exactly the constant, to the last bit.
void weigh(Sample found, float span, inout Gathered gathered) {
  if (!hasData(found) || span <= 0.0) return;
  gathered.span += span;
  gathered.mean += (found.value - gathered.mean) * (span / gathered.span);
}

/// By trapezoids; if one end has no data, the half next to it is empty.
void gatherSegment(Segment segment, inout Gathered gathered) {
  weigh(segment.front, 0.5 * segment.span, gathered);
  weigh(segment.back, 0.5 * segment.span, gathered);
}

#if EXACT
/// By Simpson's rule, which is exact for cubics. Twin: optics/rays/line-pieces.ts
void gatherPiece(Path path, float from, float to, Sample front, Sample back, inout Gathered gathered) {
  float sixth = (to - from) / 6.0;
  weigh(front, sixth, gathered);
  weigh(sampleField(path.origin + path.forward * (from + 3.0 * sixth)), 4.0 * sixth, gathered);
  weigh(back, sixth, gathered);
}
#endif

bool isSettled(Gathered gathered) {
  return false;
}

float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
  return 1.0;
}

vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.span > 0.0 ? classifyValue(gathered.mean) : vec4(0.0);
}
