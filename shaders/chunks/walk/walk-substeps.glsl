/// Walk a ray whose steps are also cut by the samples at their ends: into more substeps where more may be seen. Twin: optics/rays/cast-ray.ts
void walkRay(Path path, float limit, inout Gathered gathered) {
  float total = path.total;
  float begin = 0.0;
  float steps = countSteps(limit);
  CellRay cells = enterCells(path.origin, path.forward * uStepLength);
  // A step's end is sampled first; only then is it known how many samples are taken inside the step. Each iteration takes one sample:
  // the next one inside the step, or the end of the next step. It also gathers the segment between the two samples before.
  float end = 0.0;
  Sample last = sampleField(path.origin);
  float place = end;
  Sample front = last;
  float number = 0.0;
  float next = 0.0;
  Ahead ahead = Ahead(0.0, 1.0);
  bool skips = false;
  float spacing = 0.0;
  // Start as if the first sample were the last one inside a step.
  bool inside = true;
  float insideLeft = 1.0;
  float at = end;
  Sample taken = last;
  float to = end;
  Sample back = last;
  bool isLast;
#ifdef LOOKS
  for (int i = 0; i < MAX_SAMPLES; i++) {
#endif
  for (int i = 0; i < MAX_SAMPLES; i++) {
    insideLeft -= 1.0;
    place = to;
    front = back;
    if (!inside) {
      number = next;
      end = at;
      last = taken;
      float substeps = 1.0 / ahead.spacing;
      if (skips) {
        place = at;
        front = taken;
        substeps = 1.0;
      } else if (hasData(front) || hasData(last)) {
        substeps = max(substeps, chooseSubsteps(front, last, gathered));
      }
      insideLeft = substeps - 1.0;
      spacing = (end - place) / substeps;
    }
    inside = insideLeft > 0.5;
    bool ends = !inside && number >= steps;
    isLast = ends && limit >= total;
    if (!inside) ahead = lookAhead(cells, end / uStepLength, gathered);
    skips = !inside && ahead.skipped > 0.5;
    next = number + (skips ? ahead.skipped : 1.0);
    at = inside ? place + spacing : (next < steps ? begin + next * uStepLength : limit);
#ifdef GAP
    // The part that is cut out is one empty step.
    if (ends) {
      at = begin = gap.y;
      limit = total;
      steps = countSteps(limit - begin);
      next = 0.0;
      skips = true;
    }
#endif
    taken = sampleField(path.origin + path.forward * at);
    to = inside ? at : end;
    back = last;
    if (inside) back = taken;
    gatherSegment(Segment(front, back, place, to - place, 1.0), gathered);
    if (isLast || isSettled(gathered)) break;
  }
#ifdef LOOKS
  lookCloser(Segment(front, back, place, to - place, 1.0), gathered);
  if (isLast || isSettled(gathered)) break;
  }
#endif
}
