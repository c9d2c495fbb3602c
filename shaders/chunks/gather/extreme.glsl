/// Gathers the largest value of a ray (EXTREME_SIGN 1.0), or the smallest (-1.0): values are multiplied by the sign.

/// For each cell: 0 if it has no data, else the largest value that it can have, from 1 for 0.0 to 255 for 1.0.
uniform sampler2D uCellLimits;

#if LOCAL_EXTREME
/// The threshold, a share times the sign: the first local extreme from this value on counts.
uniform float uThreshold;
#endif

/// Smaller than any value.
#define NO_VALUE -3.0e38

/// The best value that a ray has gathered.
struct Gathered {
  float best;
  /// The place of this value on the ray.
  float at;
#if LOCAL_EXTREME
  /// The ray has passed its local extreme: the rest of it does not count.
  bool isPast;
#endif
};

Gathered beginGathering() {
  Gathered gathered;
  gathered.best = NO_VALUE;
  gathered.at = 0.0;
#if LOCAL_EXTREME
  gathered.isPast = false;
#endif
  return gathered;
}

void consider(Sample found, float at, inout Gathered gathered) {
  float value = EXTREME_SIGN * found.value;
  if (hasData(found) && value > gathered.best) {
    gathered.best = value;
    gathered.at = at;
  }
}

/// Takes a sample on the way. Behind the first local extreme that reaches the threshold, samples do not count.
/// Twin: optics/rays/projection.ts, seekExtreme
void pass(Sample found, float at, inout Gathered gathered) {
#if LOCAL_EXTREME
  gathered.isPast = gathered.isPast || (hasData(found) && gathered.best >= uThreshold && EXTREME_SIGN * found.value < gathered.best);
  if (gathered.isPast) return;
#endif
  consider(found, at, gathered);
}

void gatherSegment(Segment segment, inout Gathered gathered) {
  pass(segment.front, segment.begin, gathered);
  pass(segment.back, segment.begin + segment.span, gathered);
}

#if EXACT
/// Takes a piece between two planes of voxel centres: samples at its ends, at both thirds, and at the maximum of the cubic through these
/// four, if that is larger than the best value. All are samples of the ray, so that the picture shows only real values.
/// Twin: optics/rays/line-pieces.ts
void gatherPiece(Path path, float from, float to, Sample front, Sample back, inout Gathered gathered) {
  float third = (to - from) / 3.0;
  Sample second = sampleField(path.origin + path.forward * (from + third));
  Sample next = sampleField(path.origin + path.forward * (from + 2.0 * third));
  bool isWhole = hasData(front) && hasData(second) && hasData(next) && hasData(back);
  vec4 values = EXTREME_SIGN * vec4(front.value, second.value, next.value, back.value);
  float best;
  float top = topOfCubic(values, best);
#if LOCAL_EXTREME
  // Take the two turning points of the cubic in their order.
  float bottom = bottomOfCubic(values);
  vec2 turns = isWhole ? vec2(min(top, bottom), max(top, bottom)) : vec2(1.0, 2.0);
  pass(front, from, gathered);
  if (turns.x > 0.0) pass(sampleField(path.origin + path.forward * (from + turns.x * third)), from, gathered);
  if (turns.y > 0.0) pass(sampleField(path.origin + path.forward * (from + turns.y * third)), from, gathered);
  pass(back, to, gathered);
#else
  consider(front, from, gathered);
  consider(second, from, gathered);
  consider(next, from, gathered);
  consider(back, to, gathered);
  if (isWhole && top > 0.0 && best > gathered.best) consider(sampleField(path.origin + path.forward * (from + top * third)), from, gathered);
#endif
}
#endif

/// Beyond the end of the domain all values have the same colour.
bool isSettled(Gathered gathered) {
#if LOCAL_EXTREME
  if (gathered.isPast) return true;
#endif
  return EXTREME_SIGN > 0.0 ? gathered.best >= 1.0 : gathered.best > 0.0;
}

/// The steps ahead that can't have a larger value than the best one.
Ahead lookAhead(CellRay ray, float number, Gathered gathered) {
  vec3 place = ray.origin + ray.forward * number;
  vec3 cell = cellAt(place);
  float level = floor(texture2D(uCellLimits, placeOfCell(cell)).r * 255.0 + 0.5);
  float limit = level < 0.5 ? NO_VALUE : (level - 1.0) / 254.0 + min(EXTREME_SIGN, 0.0);
  bool isOfUse = limit > gathered.best;
#if LOCAL_EXTREME
  // From the threshold on, a smaller value ends the search, so the ray must not skip it.
  isOfUse = isOfUse || gathered.best >= uThreshold;
#endif
  return Ahead(isOfUse ? 0.0 : countStepsWithin(ray, place, cell, 1.0), 1.0);
}

float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
  return 1.0;
}

#if !EXACT
float divide(float a, float b) {
  return a / (abs(b) < 1.0e-20 ? 1.0e-20 : b);
}

/// Places where a peak may be: the top of the parabola through three samples, and the places in front and behind where straight lines
/// from two sides meet, as at faces of voxels. best: value and place; values, places: two samples before it and two after it.
/// Twin: optics/rays/projection.ts, findPeaks
vec3 findPeaks(vec2 best, vec4 values, vec4 places) {
  float before = best.y - places.y;
  float after = places.z - best.y;
  float rise = divide(best.x - values.y, before);
  float fall = divide(values.z - best.x, after);
  float curvature = divide(fall - rise, before + after);
  float slope = divide(rise * after + fall * before, before + after);
  float top = curvature < 0.0 ? -0.5 * divide(slope, curvature) : 0.0;
  float outerRise = divide(values.y - values.x, places.y - places.x);
  float outerFall = divide(values.w - values.z, places.w - places.z);
  float kinkBefore = divide(values.y - best.x + outerRise * before, fall - outerRise);
  float kinkAfter = divide(values.z - best.x - outerFall * after, rise - outerFall);
  return best.y + vec3(clamp(top, -before, after), clamp(kinkBefore, -before, 0.0), clamp(kinkAfter, 0.0, after));
}

/// The begin and the end of the piece of the ray that contains a place.
vec2 pieceAround(Path path, float along) {
#ifdef GAP
  return along < gap.y ? vec2(0.0, min(gap.x, path.total)) : vec2(gap.y, path.total);
#else
  return vec2(0.0, path.total);
#endif
}

/// Takes samples where the peak may be, closer in each round. All are samples of the ray, so that the picture shows only real values.
/// Twin: optics/rays/projection.ts, refine
Gathered refine(Gathered gathered, Path path) {
  float reach = uStepLength;
  vec2 piece = pieceAround(path, gathered.at);
  for (int i = 0; i < REFINEMENTS; i++) {
    vec2 best = vec2(gathered.best, gathered.at);
    vec4 places = clamp(best.y + reach * vec4(-2.0, -1.0, 1.0, 2.0), piece.x, piece.y);
    vec4 values = vec4(best.x);
    vec3 peaks = vec3(best.y);
    for (int k = 0; k < 7; k++) {
      if (k == 4) peaks = findPeaks(best, values, places);
      float at = k == 0 ? places.x : k == 1 ? places.y : k == 2 ? places.z : k == 3 ? places.w : k == 4 ? peaks.x : k == 5 ? peaks.y : peaks.z;
      Sample found = sampleField(path.origin + path.forward * at);
      consider(found, at, gathered);
      float value = hasData(found) ? EXTREME_SIGN * found.value : best.x;
      if (k == 0) values.x = value;
      if (k == 1) values.y = value;
      if (k == 2) values.z = value;
      if (k == 3) values.w = value;
    }
    reach *= 0.25;
  }
  return gathered;
}

#endif

vec4 finishGathering(Gathered gathered, Path path) {
  if (gathered.best < 0.9 * NO_VALUE) return vec4(0.0);
#if !EXACT
  gathered = refine(gathered, path);
#endif
  return classifyValue(EXTREME_SIGN * gathered.best);
}
