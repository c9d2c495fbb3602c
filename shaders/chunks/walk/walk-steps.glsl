/// Walk a ray whose steps are cut by what their cells need and by nothing else. Each time around, the cell ahead is looked up, a sample is taken
/// there, and the segment before is gathered: none of the three waits for what another finds, so that a processor does them side by side.
/// Samples lie on the lattice of steps, with skipping and without. Twin: optics/cast-ray.ts, with maxSubsteps 1
void walkRay(Path path, float limit, inout Gathered gathered) {
  float steps = countSteps(limit);
  // The last step is shorter than the others: its length, and how far the next sample is in it.
  float lastLength = limit - (steps - 1.0) * uStepLength;
  CellRay cells = enterCells(path.origin, path.forward * uStepLength);
  Ahead ahead = lookAhead(cells, 0.0, gathered);
  // Of the piece of the ray: there are two where something is cut out.
  float begin = 0.0;
  // The place of the next sample, in steps and by its length; where the segment begins that ends there, and its span.
  bool skips = ahead.skipped > 0.5;
  float spacing = ahead.spacing;
  float number = skips ? ahead.skipped : spacing;
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
  // What only few segments need stands beside the loop over all: software GL runs through all that is in a loop each time around.
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
    if (isWhole) spacing = ahead.spacing;
    from = at;
    number += skips ? ahead.skipped : spacing;
    inLast = max(0.0, number - steps + 1.0);
    at = begin + ((number - inLast) * uStepLength + inLast * lastLength);
    span = skips ? 0.0 : at - from;
#ifdef GAP
    if (isEnd && limit < path.total) {
      // What is cut out is one step, in which there is nothing.
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
