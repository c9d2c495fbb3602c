/// Walk a ray whose steps are cut only as their cells need. Each iteration looks up the cell ahead, takes a sample there, and gathers the
/// segment before: none of the three waits for the result of another, so that a processor can do them in parallel.
/// Samples are on the same lattice of steps with skipping and without. Twin: optics/rays/cast-ray.ts, with maxSubsteps 1
void walkRay(Path path, float limit, inout Gathered gathered) {
  float steps = countSteps(limit);
  // The last step is shorter than the others: its length, and how far the next sample is in it.
  float lastLength = limit - (steps - 1.0) * uStepLength;
  CellRay cells = enterCells(path.origin, path.forward * uStepLength);
  Ahead ahead = lookAhead(cells, 0.0, gathered);
  // Where the current piece of the ray begins: a ray has two pieces if a box is cut out of its middle.
  float begin = 0.0;
  // The place of the next sample, in steps and as a length; then the begin of the segment that ends there, and its span.
  bool skips = ahead.skipped > 0.5;
  float spacing = max(ahead.spacing, ahead.skipped);
  float number = min(steps, spacing);
  float inLast = max(0.0, number - steps + 1.0);
  float at = (number - inLast) * uStepLength + inLast * lastLength;
  float from = 0.0;
  float span = skips ? 0.0 : at;
  bool isEnd = false;
  bool isLast;
  Sample taken = sampleField(path.origin);
  Segment known = Segment(taken, taken, 0.0, 0.0, 1.0);
  Segment last;
#ifdef LOOKS
  // Code that only few segments need is outside of the inner loop: software GL runs all code of a loop in each iteration.
  for (int i = 0; i < MAX_SAMPLES; i++) {
#endif
  for (int i = 0; i < MAX_SAMPLES; i++) {
    ahead = lookAhead(cells, number, gathered);
    last = known;
    gatherSegment(last, gathered);
    taken = sampleField(path.origin + path.forward * at);
    known = Segment(last.back, taken, from, span, 1.0);
    isLast = isEnd;
    isEnd = number >= steps;
    bool isWhole = fract(number) == 0.0;
    skips = isWhole && ahead.skipped > 0.5;
    if (isWhole) spacing = max(ahead.spacing, ahead.skipped);
    from = at;
    number = min(steps, number + spacing);
    inLast = max(0.0, number - steps + 1.0);
    at = begin + ((number - inLast) * uStepLength + inLast * lastLength);
    span = skips ? 0.0 : at - from;
#ifdef GAP
    if (isEnd && limit < path.total) {
      // The part that is cut out is one empty step.
      at = begin = gap.y;
      span = 0.0;
      number = 0.0;
      limit = path.total;
      steps = countSteps(limit - begin);
      lastLength = limit - begin - (steps - 1.0) * uStepLength;
      cells = enterCells(path.origin + path.forward * begin, path.forward * uStepLength);
      isEnd = false;
    }
#endif
    if (isLast || isSettled(gathered)) break;
  }
#ifdef LOOKS
  lookCloser(last, gathered);
  if (isLast || isSettled(gathered)) break;
  }
#endif
}
