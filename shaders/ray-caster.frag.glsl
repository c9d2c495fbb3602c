/// A ray of five stages: where it runs (interval), what is there (field), what a piece of it shows (classify, shade), and
/// what all of them come to (gather). Here it is walked: steps, substeps, empty space. What the stages do their modules
/// say, see renderer/ray/. Twin: optics/cast-ray.ts
void main() {
  Ray ray = rayOfPixel();
  Interval interval = enterVolume(ray);
  float lengthPerT = length(uUnitToDiameters * ray.direction);
  float total = (interval.exit - interval.entry) * lengthPerT;
  Path path = Path(ray.point + ray.direction * interval.entry, ray.direction / lengthPerT, total);
  // Where the piece of the ray that is walked begins and ends: there are two where something is cut out.
  float begin = 0.0;
  float limit = total;
#ifdef GAP
  limit = endBeforeGap(interval.entry, lengthPerT, path);
  total = path.total;
#endif
  Gathered gathered = beginGathering();
  if (total > 0.0) {
    float steps = countSteps(limit);
    CellRay cells = enterCells(path.origin, path.forward);
    // A step's end is sampled before it is known how many samples are taken inside it. One sample is taken each time
    // around, the next inside or the end of the next step, and what lies between those known before it is gathered.
    float end = 0.0;
    Sample last = sampleField(path.origin);
    float place = end;
    Sample front = last;
    float number = 0.0;
    float next = 0.0;
    float skipped = 0.0;
    float spacing = 0.0;
    // As if the first sample had been the last one inside a step.
    bool inside = true;
    float insideLeft = 1.0;
    float at = end;
    Sample taken = last;
    float to = end;
    Sample back = last;
    bool isLast;
#ifdef LOOKS
    // What only few segments need stands beside the loop over all: software GL runs through all that is in a loop each time around.
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
        float substeps = 1.0;
        if (skipped > 0.5) {
          place = at;
          front = taken;
        } else if (hasData(front) || hasData(last)) {
          substeps = chooseSubsteps(front, last, gathered);
        }
        insideLeft = substeps - 1.0;
        spacing = (end - place) / substeps;
      }
      inside = insideLeft > 0.5;
      bool ends = !inside && number >= steps;
      isLast = ends && limit >= total;
      skipped = 0.0;
      if (!inside) skipped = countSkippedSteps(cells, end, 1.0 / uStepLength, gathered);
      next = number + max(1.0, skipped);
      at = inside ? place + spacing : (next < steps ? begin + next * uStepLength : limit);
#ifdef GAP
      // What is cut out is one step, in which there is nothing.
      if (ends) {
        at = begin = gap.y;
        limit = total;
        steps = countSteps(limit - begin);
        next = 0.0;
        skipped = 1.0;
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
  vec4 color = finishGathering(gathered, path);
  FRAGMENT_COLOR = color + (1.0 - color.a) * interval.behind;
}
