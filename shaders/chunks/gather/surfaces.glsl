/// The surfaces' colours and opacities, a column for each.
uniform mat4 uSurfaceColors;

#if SURFACES_LIT
/// As uPerFlat of lit.glsl, for surfaces.
uniform float uPerFlatSurface;
#endif

/// A piece of a ray along which values only rise or fall. Twin: optics/surfaces/surface-crossings.ts, Leg
struct Leg {
  Segment piece;
  /// The leg crosses the surfaces from this value on.
  float from;
  bool isNew;
};

/// Whether values run continuously from one sample to the next.
bool runsOn(Sample a, Sample b) {
#if NO_DATA
  if (!hasData(a) || !hasData(b)) return false;
#endif
#if FOLDS
  if (isFolded(a.value, b.value)) return false;
#endif
  return true;
}

/// The colour of a surface that a ray passes. visible: the share of light that reaches the eye. Twin: optics/surfaces/surfaces.ts, seeSurface
vec4 seeSurface(vec4 color, Sample hit, float visible) {
  vec4 seen = vec4(color.rgb * color.a, color.a);
#ifdef LABELS_HIDE
  seen = labelAppearancesShade(Segment(hit, hit, 0.0, 0.0, visible), seen);
#endif
#if SURFACES_LIT
  if (visible * seen.a > MIN_LIT) {
    Shade shade = shadeSample(hit, uPerFlatSurface, uMaterial);
    seen.rgb = min(vec3(seen.a), seen.rgb * shade.diffuse + seen.a * shade.specular);
  }
#endif
#if SURFACES_STYLED
  if (visible * seen.a > MIN_LIT) {
    Styled styled = styleSample(hit);
    vec3 own = seen.rgb / seen.a;
    seen.a = min(1.0, seen.a * styled.opacity);
    seen.rgb = seen.a * clamp(own * styled.gain + styled.more, 0.0, 1.0);
  }
#endif
  return seen;
}

bool runsThrough(Segment segment) {
  return segment.span > 0.0 && runsOn(segment.front, segment.back);
}

void remember(Segment segment, bool runs, inout Gathered gathered) {
  gathered.pointBefore = segment.front.point;
  gathered.valueBefore = segment.front.value;
  gathered.spanBefore = runs ? segment.span : 0.0;
}

/// Whether a segment may meet a surface.
bool mayMeet(Segment segment, Gathered gathered) {
  // If the value before the segment is not known, assume that it may have been any value.
  float change = segment.front.value - segment.back.value;
  float before = gathered.spanBefore > 0.0 ? gathered.valueBefore : segment.front.value - FARTHEST * sign(change);
  float count = countUpTo(segment.front.value);
  return runsThrough(segment) && (count != countUpTo(segment.back.value) || mayTurn(segment, before, count));
}

/// Emission and absorption if the segment meets no surface.
void gatherSegment(Segment segment, inout Gathered gathered) {
  // The walk gathers the last segment of a settled ray once more: ignore it.
  if (isOpaque(gathered)) return;
  gathered.waits = mayMeet(segment, gathered);
  if (gathered.waits) return;
#if SURFACE_FOG
  float visible = 1.0 - gathered.color.a;
  gathered.color += visible * seeSegment(Segment(segment.front, segment.back, segment.begin, segment.span, visible));
#endif
  remember(segment, runsThrough(segment), gathered);
}

/// Emission and absorption with surfaces in it. One loop handles all pieces and all surfaces, so that its code is there only once.
/// Twin: optics/surfaces/surfaces.ts, surfaceGather
void lookCloser(Segment segment, inout Gathered gathered) {
  if (!gathered.waits) return;
  gathered.waits = false;
  bool meetsAny = countUpTo(segment.front.value) != countUpTo(segment.back.value);
  Leg leg = Leg(segment, segment.front.value, true);
  // The legs that are left: none; the second half of the segment; or the second half of a turn before the segment, and the segment.
  float toCome = 0.0;
  Sample top = segment.front;
  float spanBefore = gathered.spanBefore;
  Sample sampled = segment.front;
  sampled.value = gathered.valueBefore;
  sampled.point = gathered.pointBefore;
  float turn = 0.0;
  if (spanBefore == 0.0) sampled = sampleField(2.0 * segment.front.point - segment.back.point);
  if (runsOn(sampled, segment.front)) turn = findTurn(segment, sampled.value, sampled.point, spanBefore > 0.0 ? spanBefore : segment.span, top);
  meetsAny = meetsAny || turn != 0.0;
  if (turn > 0.0) {
    leg.piece.back = top;
    leg.piece.span = turn;
    toCome = 1.0;
  } else if (turn < 0.0 && spanBefore > 0.0) {
    leg.piece.front = sampled;
    leg.piece.back = top;
    leg.piece.span = spanBefore + turn;
    leg.isNew = false;
    toCome = 2.0;
  }
  float number = leg.piece.back.value >= leg.from ? -1.0 : 4.0;
  vec2 known = vec2(0.0, leg.piece.front.value);
  Sample from = leg.piece.front;
  for (int i = 0; i < MAX_PIECES; i++) {
#if !SURFACE_FOG
    if (!meetsAny) break;
#endif
    number = meetsAny ? nextSurface(leg.from, leg.piece.back.value, number) : -1.0;
    bool meets = number > -0.5;
    Sample to = leg.piece.back;
    float at = 1.0;
    vec4 color = vec4(0.0);
    if (meets) {
      float wanted = 0.0;
      for (int k = 0; k < SURFACE_COUNT; k++) {
        if (abs(float(k) - number) < 0.5) {
          wanted = uSurfaceValues[k];
          color = uSurfaceColors[k];
        }
      }
      at = refineHit(leg.piece, known, wanted, to);
    }
#if SURFACE_FOG
    if (leg.isNew) {
      float visible = 1.0 - gathered.color.a;
      gathered.color += visible * seeSegment(Segment(from, to, leg.piece.begin + known.x * leg.piece.span, (at - known.x) * leg.piece.span, visible));
    }
#endif
    if (meets) {
      float visible = 1.0 - gathered.color.a;
      gathered.color += visible * seeSurface(color, to, visible);
      known = vec2(at, to.value);
      from = to;
      continue;
    }
    if (toCome < 0.5) break;
    // The next leg.
    if (toCome > 1.5) {
      leg.piece.front = top;
      leg.piece.back = segment.front;
      leg.from = top.value;
      toCome = 0.75;
    } else if (toCome < 0.8) {
      leg = Leg(segment, segment.front.value, true);
      toCome = 0.0;
    } else {
      leg.piece.front = top;
      leg.piece.back = segment.back;
      leg.piece.begin += leg.piece.span;
      leg.piece.span = segment.span - leg.piece.span;
      leg.from = top.value;
      toCome = 0.0;
    }
    number = leg.piece.back.value >= leg.from ? -1.0 : 4.0;
    known = vec2(0.0, leg.piece.front.value);
    from = leg.piece.front;
  }
  remember(segment, true, gathered);
}

#ifdef SUBSTEPS
/// Whether values near a step may pass a surface that the step itself does not cross, if they continue as far as they came on the step
/// or before it.
/// Twin: optics/surfaces/surface-crossings.ts, mayGraze
bool mayGraze(float from, float to, Gathered gathered) {
  float before = gathered.spanBefore > 0.0 ? abs(from - gathered.valueBefore) * (uStepLength / gathered.spanBefore) : 0.0;
  float reach = max(abs(to - from), before);
  return countUpTo(max(from, to) + reach) - countUpTo(min(from, to) - reach) > abs(countUpTo(to) - countUpTo(from)) + 0.5;
}

float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
  float smallest = runsOn(front, back) && mayGraze(front.value, back.value, gathered) ? min(uMaxSubsteps, GRAZING_SUBSTEPS) : 1.0;
#if SURFACE_FOG
#ifdef FUNCTIONS
  float wanted = countSubstepsOf(front, back, 1.0 - gathered.color.a);
#else
  float wanted = countSubsteps(hasData(front) ? front.value : back.value, hasData(back) ? back.value : front.value, 1.0 - gathered.color.a);
#endif
  return max(wanted, smallest);
#else
  return smallest;
#endif
}
#endif
