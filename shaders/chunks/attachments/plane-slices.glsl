/// A column for each plane: normal . p = w for places p of the unit cube.
uniform mat4 uPlanes;

/// How each plane is painted. First row: 0 no plane, 1 grey, 2 the transfer function's colours. For grey: the share of the table's
/// domain that is black, and 1 / (white - black). For a thick plane (a slab): 0 shows the average, 1 the largest value, 2 the smallest.
uniform mat4 uPlanePaints;

#if SLABS
/// The thickness of each plane: the vector from one side of the slab to the other, in the unit cube; w is 0 for a thin plane.
uniform mat4 uSlabs;

/// What a line through a slab has gathered: a value, and the share of the line that has data.
struct SlabValue {
  float value;
  float weight;
};

/// Adds a sample; kind: see uPlanePaints. The running mean stays between the values, for any number of them.
void takeOfSlab(float here, float weight, float kind, inout SlabValue found) {
  bool isFirst = found.weight <= 0.0;
  found.weight += weight;
  if (kind < 0.5) found.value += (here - found.value) * (weight / max(found.weight, 1.0e-20));
  else if (isFirst) found.value = here;
  else found.value = kind < 1.5 ? max(found.value, here) : min(found.value, here);
}

/// The value that a thick plane shows at a place: the average or extreme of all values on a line through the slab.
/// Twin: optics/attachments/plane-slices.ts, sampleSlab
bool sampleSlab(vec3 p, vec3 way, float kind, out float value) {
  vec3 origin = p - 0.5 * way;
  vec3 safe = mix(way, vec3(1.0e-9), vec3(lessThan(abs(way), vec3(1.0e-9))));
  vec3 low = -origin / safe;
  vec3 high = (1.0 - origin) / safe;
  vec3 entries = min(low, high);
  vec3 exits = max(low, high);
  float at = max(0.0, max(max(entries.x, entries.y), entries.z));
  float end = min(1.0, min(min(exits.x, exits.y), exits.z));
  SlabValue found = SlabValue(0.0, 0.0);
  value = 0.0;
  if (at >= end) return false;
  PlaneWalk walk = enterPlanes(origin, way);
  standAt(at, walk);
  float sign = kind < 1.5 ? 1.0 : -1.0;
  // For an average, the places of Simpson's rule; else thirds.
  float parts = kind < 0.5 ? 2.0 : 3.0;
  float front;
  bool isFront = sampleVolume(origin + at * way, front);
  for (int i = 0; i < SLABS; i++) {
    float to = passNext(end, walk);
    float span = to - at;
    vec4 values = vec4(front);
    bool isWhole = isFront;
    if (isFront) takeOfSlab(front, span / 6.0, kind, found);
    for (int k = 1; k < 4; k++) {
      float part = float(k);
      if (part > parts) break;
      float here;
      bool isThere = sampleVolume(origin + (at + span * (part / parts)) * way, here);
      if (isThere) takeOfSlab(here, span * (part < parts ? 2.0 / 3.0 : 1.0 / 6.0), kind, found);
      isWhole = isWhole && isThere;
      if (k == 1) values.y = here;
      if (k == 2) values.z = here;
      if (k == 3) values.w = here;
      front = here;
      isFront = isThere;
    }
    float best;
    float top = topOfCubic(sign * values, best);
    if (kind > 0.5 && isWhole && top > 0.0 && best > sign * found.value) {
      float here;
      if (sampleVolume(origin + (at + span * (top / 3.0)) * way, here)) takeOfSlab(here, span, kind, found);
    }
    at = to;
    if (at >= end) break;
  }
  value = found.value;
  return found.weight > 0.0;
}
#endif

/// The colour at a place of a plane. False if there is no data. Twin: optics/attachments/plane-slices.ts, planeInterval
bool paintPlane(vec3 p, vec4 paint, vec4 slab, out vec3 color) {
  float value;
  bool valid;
#if SLABS
  if (slab.w > 0.5) valid = sampleSlab(p, slab.xyz, paint.w, value);
  else valid = sampleVolume(p, value);
#else
  valid = sampleVolume(p, value);
#endif
  float share = toShare(value);
  color = vec3(clamp((share - paint.y) * paint.z, 0.0, 1.0));
  if (paint.x < 1.5) return valid;
  vec4 seen = classifyValue(share);
  color = seen.rgb / max(seen.a, 1.0e-20);
  return valid && seen.a >= MIN_SLICE_OPACITY;
}

/// The nearest plane that has data at its place ends a ray, behind the part of the volume in front of it. A plane on a cut face, or on
/// a face of the volume, is visible from both sides.
/// Twin: optics/attachments/plane-slices.ts, planeInterval
Interval planesInterval(Ray ray, Interval interval) {
  float nearest = 1.0e30;
  float end = interval.exit;
  vec4 behind = interval.behind;
  for (int i = 0; i < 4; i++) {
    vec4 paint = uPlanePaints[i];
    if (paint.x < 0.5) break;
    vec4 plane = uPlanes[i];
    float slope = dot(plane.xyz, ray.direction);
    if (abs(slope) < 1.0e-20) slope = 1.0e-20;
    float t = (plane.w - dot(plane.xyz, ray.point)) / slope;
    float slack = slackAt(slope);
    if (t < interval.entry - slack || t > interval.exit + slack || t >= nearest || isCutOut(t, slack)) continue;
#if SLABS
    vec4 slab = uSlabs[i];
#else
    vec4 slab = vec4(0.0);
#endif
    vec3 color;
    if (!paintPlane(ray.point + clamp(t, interval.entry, interval.exit) * ray.direction, paint, slab, color)) continue;
    nearest = t;
    end = t < interval.entry + slack ? min(interval.entry, interval.exit) : min(t, interval.exit);
    behind = vec4(color, 1.0);
  }
  return Interval(interval.entry, end, behind);
}
