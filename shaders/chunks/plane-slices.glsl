/// A plane a column: normal . p = w for places p of the unit cube.
uniform mat4 uPlanes;

/// How each is painted. First row: 0 no plane, 1 grey, 2 the transfer function's colours; then of greys the share of the
/// table's domain that is black, and 1 / (white - black); then what of a thick one is shown: 0 the average, 1 the largest value,
/// 2 the smallest.
uniform mat4 uPlanePaints;

#if SLABS
/// How thick each is: from sample to sample through it, in the unit cube, and how many there are; 0 for the values on it alone.
uniform mat4 uSlabs;

/// What a thick plane shows at a place. Twin: optics/plane-slices.ts, sampleSlab
bool sampleSlab(vec3 p, vec4 slab, float kind, out float value) {
  float count = 0.0;
  value = 0.0;
  for (int i = 0; i < SLABS; i++) {
    if (float(i) >= slab.w) break;
    vec3 at = p + (float(i) - 0.5 * (slab.w - 1.0)) * slab.xyz;
    float here;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0))) || !sampleVolume(at, here)) continue;
    count += 1.0;
    // The running mean stays within the values, whatever their number.
    if (kind < 0.5) value += (here - value) / count;
    else if (count < 1.5) value = here;
    else value = kind < 1.5 ? max(value, here) : min(value, here);
  }
  return count > 0.5;
}
#endif

/// Paint what is seen at a place of a plane. False where there is nothing. Twin: optics/plane-slices.ts, planeInterval
bool paintPlane(vec3 p, vec4 paint, vec4 slab, out vec3 color) {
  float value;
  bool valid;
#if SLABS
  if (slab.w > 0.5) valid = sampleSlab(p, slab, paint.w, value);
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

/// The nearest plane on which there are data ends a ray, and stands behind what is before it.
/// Twin: optics/plane-slices.ts, planeInterval
Interval planesInterval(Ray ray, Interval interval) {
  for (int i = 0; i < 4; i++) {
    vec4 paint = uPlanePaints[i];
    if (paint.x < 0.5) break;
    vec4 plane = uPlanes[i];
    float slope = dot(plane.xyz, ray.direction);
    float t = (plane.w - dot(plane.xyz, ray.point)) / (abs(slope) < 1.0e-20 ? 1.0e-20 : slope);
    if (t < interval.entry || t >= interval.exit || isCutOut(t)) continue;
#if SLABS
    vec4 slab = uSlabs[i];
#else
    vec4 slab = vec4(0.0);
#endif
    vec3 color;
    if (paintPlane(ray.point + t * ray.direction, paint, slab, color)) interval = Interval(interval.entry, t, vec4(color, 1.0));
  }
  return interval;
}
