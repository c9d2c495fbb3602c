/// Half-spaces that are kept, a column each: normal . p + w >= 0 for places p of the unit cube; 0 0 0 1 keeps everything.
uniform mat4 uClipA;
uniform mat4 uClipB;
uniform mat4 uClipC;

/// The part of an interval that is inside four half-spaces.
Interval clipTo(mat4 planes, Ray ray, Interval interval) {
  vec4 slopes = vec4(ray.direction, 0.0) * planes;
  vec4 starts = vec4(ray.point, 1.0) * planes;
  for (int i = 0; i < 4; i++) {
    float slope = abs(slopes[i]) < 1.0e-9 ? 1.0e-9 : slopes[i];
    float t = -starts[i] / slope;
    if (slope > 0.0) interval.entry = max(interval.entry, t);
    else interval.exit = min(interval.exit, t);
  }
  return interval;
}

/// A ray runs in the intersection of all half-spaces. Twin: optics/rays/clip-intervals.ts, clipInterval
Interval clipInterval(Ray ray, Interval interval) {
  interval = clipTo(uClipC, ray, clipTo(uClipB, ray, clipTo(uClipA, ray, interval)));
  if (interval.exit < interval.entry + slackOf(ray.direction)) interval.exit = min(interval.exit, interval.entry);
  return interval;
}
