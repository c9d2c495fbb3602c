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
    float insideLeft = 0.0;
    float substepLength = 0.0;
    for (int i = 0; i < MAX_SAMPLES; i++) {
      bool inside = insideLeft > 0.5;
      bool ends = !inside && number >= steps;
      if (ends && limit >= total) break;
      float skipped = 0.0;
      if (!inside) skipped = countSkippedSteps(cells, end, 1.0 / uStepLength, gathered);
      float next = number + max(1.0, skipped);
      float at = inside ? place + substepLength : (next < steps ? begin + next * uStepLength : limit);
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
      Sample taken = sampleField(path.origin + path.forward * at);
      float to = inside ? at : end;
      Sample back = last;
      if (inside) back = taken;
      gatherSegment(Segment(front, back, place, to - place, 1.0), gathered);
      // The segment is then gathered once more below, which must not matter any more.
      if (isSettled(gathered)) break;
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
        substepLength = (end - place) / substeps;
      }
    }
    gatherSegment(Segment(front, last, place, end - place, 1.0), gathered);
  }
  vec4 color = finishGathering(gathered, path);
  FRAGMENT_COLOR = color + (1.0 - color.a) * interval.behind;
}
