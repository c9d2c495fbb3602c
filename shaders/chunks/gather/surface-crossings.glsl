/// Finds where rays cross surfaces of constant values, and where they graze them. Twin: optics/surfaces/surface-crossings.ts

/// Whether a surface is between two values; isTop: whether `value` is above it, else below it.
bool isBeyond(float value, float known, bool isTop) {
  float more = countUpTo(value) - countUpTo(known);
  return (isTop ? more : -more) > 0.5;
}

#if KINKS
#ifndef PLANE_VOXELS
#define PLANE_VOXELS uDimensions
#endif

/// Where a way of at most a voxel passes planes of voxel centres, along each axis, as shares of the way; 2 if it passes none.
/// Twin: optics/rays/ray-field.ts
vec3 kinksBetween(vec3 from, vec3 to) {
  vec3 begin = from * PLANE_VOXELS - 0.5;
  vec3 way = (to - from) * PLANE_VOXELS;
  vec3 plane = mix(ceil(begin) - 1.0, floor(begin) + 1.0, step(vec3(0.0), way));
  vec3 safe = mix(way, vec3(1.0e-9), vec3(lessThan(abs(way), vec3(1.0e-9))));
  vec3 shares = (plane - begin) / safe;
  vec3 counts = step(0.001, shares) * step(shares, vec3(0.999)) * step(max(abs(way), abs(way.yzx)), vec3(1.01)) * step(abs(way.zxy), vec3(1.01));
  return mix(vec3(2.0), shares, counts);
}
#endif

/// Whether values would pass a surface if they continued, beyond the first sample of a segment, as far as they came. count: of surfaces up
/// to this sample.
bool mayTurn(Segment segment, float before, float count) {
  float here = segment.front.value;
  float lowest = min(before, segment.back.value);
  float highest = max(before, segment.back.value);
  bool isTop = highest <= here;
  float more = countUpTo(here + (here - (isTop ? lowest : highest))) - count;
  return isTop ? more > 0.5 : lowest >= here && more < -0.5;
}

/// Where values turn back beyond a surface between two samples: the length from the segment's begin; 0 if they do not.
/// value, point, span: of the sample before the segment, and its distance. Twin: optics/surfaces/surface-crossings.ts, findTurn
float findTurn(Segment segment, float valueBefore, vec3 pointBefore, float spanBefore, out Sample top) {
  vec3 t = vec3(-spanBefore, 0.0, segment.span);
  vec3 v = vec3(valueBefore, segment.front.value, segment.back.value);
  vec3 ends = v;
  top = segment.front;
  bool isTop = v.x <= v.y && v.z <= v.y;
  if (!mayTurn(segment, valueBefore, countUpTo(segment.front.value))) return 0.0;
#if KINKS
  vec3 ahead = kinksBetween(segment.front.point, segment.back.point);
  vec3 behind = kinksBetween(segment.front.point, pointBefore);
#endif
  for (int i = 0; i < KINK_PROBES + GRAZING_PROBES; i++) {
    float after = (v.z - v.y) / (t.z - t.y);
    float bend = (after - (v.y - v.x) / (t.y - t.x)) / (t.z - t.x);
    float at = t.y - (after - bend * (t.z - t.y)) / (2.0 * bend);
#if KINKS
    if (i < KINK_PROBES) {
      float share = ahead.x;
      ahead = vec3(ahead.yz, behind.x);
      behind = behind.yzx;
      if (share > 1.0) continue;
      at = i < KINK_PROBES / 2 ? share * segment.span : -share * spanBefore;
    } else
#endif
    if (bend == 0.0) return 0.0;
    vec3 place = at < 0.0 ? mix(segment.front.point, pointBefore, -at / spanBefore) : mix(segment.front.point, segment.back.point, at / segment.span);
    top = sampleField(place);
#if NO_DATA
    if (!hasData(top)) return 0.0;
#endif
    float found = top.value;
    if (isBeyond(found, ends.y, isTop)) return at;
    bool isBetter = isTop ? found > v.y : found < v.y;
    if (isBetter && at > t.y) {
      // Whether a kink is beyond a known place: kinks come in any order.
      bool isPast = at >= t.z;
      t = vec3(t.y, at, isPast ? segment.span : t.z);
      v = vec3(v.y, found, isPast ? ends.z : v.z);
    } else if (isBetter) {
      bool isPast = at <= t.x;
      t = vec3(isPast ? -spanBefore : t.x, at, t.y);
      v = vec3(isPast ? ends.x : v.x, found, v.y);
    } else if (at > t.y && at < t.z) {
      t.z = at;
      v.z = found;
    } else if (at < t.y && at > t.x) {
      t.x = at;
      v.x = found;
    } else if (i >= KINK_PROBES) {
      return 0.0;
    }
  }
  return 0.0;
}

/// The number of the next surface that a leg crosses; -1 if there is none. last: the surface before, or a number that is no surface.
/// Twin: optics/surfaces/surface-crossings.ts, listCrossed
float nextSurface(float from, float to, float last) {
  float next = -1.0;
  for (int i = 0; i < SURFACE_COUNT; i++) {
    float number = float(i);
    bool isCrossed = (from >= uSurfaceValues[i]) != (to >= uSurfaceValues[i]);
    if (!isCrossed) continue;
    if (to >= from) {
      if (number > last && next < 0.0) next = number;
    } else if (number < last) {
      next = number;
    }
  }
  return next;
}

/// The share of a piece at which it has the wanted value; hit: the sample there. known: share and value of a place before it.
/// Twin: optics/surfaces/surface-crossings.ts, refine
float refineHit(Segment piece, vec2 known, float wanted, out Sample hit) {
  bool isAbove = piece.back.value >= wanted;
  vec2 a = vec2(known.x, known.y - wanted);
  vec2 b = vec2(1.0, piece.back.value - wanted);
  float kept = 0.0;
  float at = 0.0;
  hit = piece.back;
#if KINKS
  vec3 kinks = kinksBetween(piece.front.point, piece.back.point);
  float middle = max(min(kinks.x, kinks.y), min(max(kinks.x, kinks.y), kinks.z));
#endif
  for (int i = 0; i <= SURFACE_REFINEMENTS; i++) {
    at = a.y == b.y ? a.x : clamp(a.x + (b.x - a.x) * a.y / (a.y - b.y), a.x, b.x);
    if (i == SURFACE_REFINEMENTS) break;
    bool isKink = false;
#if KINKS
    // The middle kink, and the next one on the side of the surface: between two kinks values are smooth.
    float kink = 2.0;
    if (i == 0) kink = middle;
    if (i == 1) kink = a.x < middle ? min(min(kinks.x, kinks.y), kinks.z) : max(max(kinks.x, kinks.y), kinks.z);
    isKink = kink > a.x && kink < b.x;
    if (isKink) at = kink;
#endif
    Sample found = sampleField(mix(piece.front.point, piece.back.point, at));
#if NO_DATA
    if (!hasData(found)) break;
#endif
    hit = found;
    float off = found.value - wanted;
    if ((off >= 0.0) == isAbove) {
      b = vec2(at, off);
      if (kept > 0.5) a.y *= 0.5;
      kept = isKink ? 0.0 : 1.0;
    } else {
      a = vec2(at, off);
      if (kept < -0.5) b.y *= 0.5;
      kept = isKink ? 0.0 : -1.0;
    }
  }
  hit.value = wanted;
  hit.point = mix(piece.front.point, piece.back.point, at);
  return at;
}
