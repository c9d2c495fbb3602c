/// Emission and absorption that finds what is opaque at once wherever a ray touches it: see optics/opaque-jumps.ts. Twin: optics/jump-gather.ts

bool runsThrough(Segment segment) {
  return segment.span > 0.0 && hasData(segment.front) && hasData(segment.back);
}

void remember(Segment segment, inout Gathered gathered) {
  gathered.pointBefore = segment.front.point;
  gathered.valueBefore = segment.front.value;
  gathered.spanBefore = runsThrough(segment) ? segment.span : 0.0;
}

void gatherSegment(Segment segment, inout Gathered gathered) {
  // The last segment of a ray that is settled comes once more.
  if (isOpaque(gathered)) return;
  // Behind empty space nothing is known of what was before: there values do not turn, as they are beyond nothing that shows.
  float before = gathered.valueBefore;
  gathered.waits = gathered.spanBefore > 0.0 && runsThrough(segment) && mayTurn(segment, before, countUpTo(segment.front.value));
  if (gathered.waits) return;
  float visible = 1.0 - gathered.color.a;
  gathered.color += visible * seeSegment(Segment(segment.front, segment.back, segment.begin, segment.span, visible));
  remember(segment, gathered);
}

/// The value that is passed on the way from one to another.
float passedValue(float from, float to) {
  float passed = from;
  for (int i = 0; i < SURFACE_COUNT; i++) if ((from >= uSurfaceValues[i]) != (to >= uSurfaceValues[i])) passed = uSurfaceValues[i];
  return passed;
}

/// A segment next to which values turn, and what lies beyond the turn.
void lookCloser(Segment segment, inout Gathered gathered) {
  if (!gathered.waits) return;
  gathered.waits = false;
  vec3 pointBefore = gathered.pointBefore;
  float spanBefore = gathered.spanBefore;
  float valueBefore = gathered.valueBefore;
  Sample top;
  float turn = findTurn(segment, valueBefore, pointBefore, spanBefore, top);
  Sample from = segment.front;
  Sample to = segment.back;
  float span = segment.span;
  Sample next = segment.front;
  float nextSpan = 0.0;
  // Pieces that are still to come behind the first one.
  float toCome = 0.0;
  if (turn > 0.0) {
    top = sampleField(mix(segment.front.point, segment.back.point, turn / span));
    next = to;
    nextSpan = span - turn;
    to = top;
    span = turn;
    toCome = 1.0;
  } else if (turn < 0.0) {
    // In the segment before, of which what is not beyond has been gathered.
    top = sampleField(mix(segment.front.point, pointBefore, -turn / spanBefore));
    float passed = passedValue(segment.front.value, top.value);
    vec2 shares = clamp((top.value - passed) / (top.value - vec2(valueBefore, segment.front.value)), 0.0, 1.0);
    from = sampleField(mix(top.point, pointBefore, shares.x));
    next = sampleField(mix(top.point, segment.front.point, shares.y));
    to = top;
    span = shares.x * (spanBefore + turn);
    nextSpan = -shares.y * turn;
    toCome = 2.0;
  }
  for (int i = 0; i < 3; i++) {
    float visible = 1.0 - gathered.color.a;
    gathered.color += visible * seeSegment(Segment(from, to, segment.begin, span, visible));
    if (toCome < 0.5) break;
    if (toCome < 1.5 && turn < 0.0) {
      from = segment.front;
      to = segment.back;
      span = segment.span;
    } else {
      from = top;
      to = next;
      span = nextSpan;
    }
    toCome -= 1.0;
  }
  remember(segment, gathered);
}

#ifdef SUBSTEPS
float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
#ifdef FUNCTIONS
  return countSubstepsOf(front, back, 1.0 - gathered.color.a);
#else
  return countSubsteps(hasData(front) ? front.value : back.value, hasData(back) ? back.value : front.value, 1.0 - gathered.color.a);
#endif
}
#endif
