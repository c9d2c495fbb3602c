/// Emission and absorption that also finds every place where a ray touches a value at which the volume becomes opaque at once: see
/// optics/transfer/opaque-jumps.ts. Twin: optics/surfaces/jump-gather.ts

/// Length of a voxel, in bounding diameters.
uniform float uVoxelLength;

/// The colour that a ray has gathered, front to back: premultiplied.
struct Gathered {
  vec4 color;
  /// The ray waits for a closer look at its last part.
  bool waits;
};

Gathered beginGathering() {
  return Gathered(vec4(0.0), false);
}

/// The same limit as in composite.glsl.
bool isOpaque(Gathered gathered) {
  return gathered.color.a > 0.999;
}

bool isSettled(Gathered gathered) {
  return gathered.waits || isOpaque(gathered);
}

/// The number of parts of the way between two planes of voxel centres: the number of steps for a voxel, so that twice as many steps give
/// parts of half the length.
float countParts() {
  return max(1.0, ceil(uVoxelLength / uStepLength - 0.01));
}

/// Only the values at both thirds of a part: they cost less than whole samples. isWhole: whether both have data.
vec2 sampleThirds(Path path, float from, float to, out bool isWhole) {
  vec2 thirds = vec2(0.0);
  isWhole = sampleVolume(path.origin + path.forward * mix(from, to, 1.0 / 3.0), thirds.x);
  isWhole = sampleVolume(path.origin + path.forward * mix(from, to, 2.0 / 3.0), thirds.y) && isWhole;
  return vec2(toShare(thirds.x), toShare(thirds.y));
}

/// A piece that hides more than this share of the light is halved.
float limitOf(Sample front, Sample back) {
  return (differInStyle(front, back) ? MAX_HIDDEN_AT_LABELS : MAX_HIDDEN) / countParts();
}

bool passes(Sample front, Sample back) {
  return hasData(front) && hasData(back) && countUpTo(front.value) != countUpTo(back.value);
}

/// Whether a cubic may pass a value between its ends: the cubic never exceeds its Bernstein coefficients.
bool mayTurn(vec4 values) {
  vec2 inner = innerBounds(values);
  float low = min(values.x, values.w);
  float high = max(values.x, values.w);
  return countUpTo(min(low, min(inner.x, inner.y))) != countUpTo(low) || countUpTo(max(high, max(inner.x, inner.y))) != countUpTo(high);
}

/// Gather a part of a ray if it is simple; else the ray waits for `lookCloser`.
void gatherPart(Path path, float from, float to, Sample front, Sample back, inout Gathered gathered) {
  float visible = 1.0 - gathered.color.a;
  vec4 seen = visible * seeSegment(Segment(front, back, from, to - from, visible));
  bool isWhole;
  vec2 thirds = sampleThirds(path, from, to, isWhole);
  isWhole = isWhole && hasData(front) && hasData(back);
  gathered.waits = seen.a > limitOf(front, back) || passes(front, back) || (isWhole && mayTurn(vec4(front.value, thirds, back.value)))
    || labelTurn(path.origin + path.forward * from, path.origin + path.forward * to) > 0.0;
  if (!gathered.waits) gathered.color += seen;
}

/// How long the way of a jump of the value is taken to be: a voxel of the coarser one of two levels of bricks, as values pass all between on such a way in the whole
/// volume. 0 where there is no jump. one, other: voxels along the unit cube of what is shown at two places.
float jumpBetween(float one, float other) {
  return one == other ? 0.0 : uVoxelLength * PLANE_VOXELS.x / min(one, other);
}

#ifdef BRICKS
/// Voxels along the unit cube, along its x, of what is shown at a place.
float scaleAt(vec3 p) {
  inAtlas(p);
  return voxelScale.x;
}

/// The same at the place of the last sample.
#define LAST_SCALE voxelScale.x

/// A sample on a way on which values change evenly from one sample to another, at a share of it; all but the value is that of the first one.
/// `columnsField` uses only the value, so its p does not matter.
Sample onWay(Sample from, Sample to, float share) {
  from.value = mix(from.value, to.value, share);
#ifdef COLUMN_BINS
  from.stored = mix(from.stored, to.stored, share);
  from = columnsField(vec3(0.0), from);
#endif
  return from;
}

/// Gather a jump of the value: as a way of some length on which values change evenly, halved as all others.
void gatherJump(Segment jump, inout Gathered gathered) {
  float at = 0.0;
  float share = 1.0;
  Sample front = jump.front;
  for (int i = 0; i <= MAX_LOOKS; i++) {
    float end = i == MAX_LOOKS ? 1.0 : min(1.0, at + share);
    Sample next = jump.back;
    if (end < 1.0) next = onWay(jump.front, jump.back, end);
    float visible = 1.0 - gathered.color.a;
    vec4 seen = visible * seeSegment(Segment(front, next, jump.begin, (end - at) * jump.span, visible));
    bool isShort = i == MAX_LOOKS || end - at <= MIN_SHARE;
    if (!isShort && (seen.a > limitOf(front, next) || passes(front, next))) {
      share = 0.5 * (end - at);
    } else {
      gathered.color += seen;
      share = 2.0 * (end - at);
      at = end;
      front = next;
      if (at >= 1.0 || isOpaque(gathered)) break;
    }
  }
}
#else
float scaleAt(vec3 p) {
  return 1.0;
}

#define LAST_SCALE 1.0
#endif

/// Cut a part at the turning points of the cubic through it and where another label may show, and halve the pieces that hide much, pass a value, or in which
/// values jump.
void lookCloser(Path path, float from, float to, Sample front, Sample back, inout Gathered gathered) {
  if (!gathered.waits) return;
  gathered.waits = false;
  bool isWhole;
  vec4 values = vec4(front.value, sampleThirds(path, from, to, isWhole), back.value);
  float top;
  vec2 turns = vec2(topOfCubic(values, top), bottomOfCubic(values));
  bool turnsOnce = isWhole && hasData(front) && hasData(back);
  turns = turnsOnce ? from + (to - from) * turns / 3.0 : vec2(from);
  float smallest = (to - from) * MIN_SHARE;
  float label = from + (to - from) * labelTurn(path.origin + path.forward * from, path.origin + path.forward * to);
  float backScale = scaleAt(path.origin + path.forward * to);
  float frontScale = scaleAt(path.origin + path.forward * from);
  float at = from;
  float span = to - from;
  for (int i = 0; i <= MAX_LOOKS; i++) {
    // The last piece is taken as it is.
    bool isLast = i == MAX_LOOKS;
    float end = isLast ? to : min(to, at + span);
    if (turns.x > at && !isLast) end = min(end, turns.x);
    if (turns.y > at && !isLast) end = min(end, turns.y);
    if (label > at && !isLast) end = min(end, label);
    Sample next = back;
    float scale = backScale;
    if (end < to) {
      next = sampleField(path.origin + path.forward * end);
      scale = LAST_SCALE;
    }
    float visible = 1.0 - gathered.color.a;
    float jump = jumpBetween(frontScale, scale);
    bool isShort = isLast || end - at <= smallest;
    Segment piece = Segment(front, next, at, end - at, visible);
    vec4 seen = visible * seeSegment(piece);
    if (!isShort && (jump > 0.0 || seen.a > limitOf(front, next) || passes(front, next))) {
      span = 0.5 * (end - at);
    } else {
#ifdef BRICKS
      if (jump > piece.span && hasData(front) && hasData(next)) gatherJump(Segment(front, next, at, jump, visible), gathered);
      else
#endif
      gathered.color += seen;
      span = 2.0 * (end - at);
      at = end;
      front = next;
      frontScale = scale;
      if (at >= to || isOpaque(gathered)) break;
    }
  }
}
