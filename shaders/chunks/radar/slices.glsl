/// A column for each slice. First row: 0 none, 1 cone, 2 level, 3 upright. Then, for a cone: number of its sweep, cosine and sine of
/// its elevation; for a level slice: metres above the antenna; for an upright slice: metres along the ground.
uniform mat4 uSlices;

/// For upright slices: where they begin, in metres east and north, and their direction.
uniform mat4 uSliceLines;

/// The transfer function's stops: share of the table's domain in the first row, premultiplied colours in the second.
uniform sampler2D uStops;

/// The number of stops, and 1 / texels across.
uniform vec2 uStopTexels;

/// The number of the sweep for slices that are no cones.
#define NO_SWEEP -1.0

float fetchStop(float stop) {
  return texture2D(uStops, vec2((stop + 0.5) * uStopTexels.y, 0.25)).r;
}

vec4 fetchStopColor(float stop) {
  return texture2D(uStops, vec2((stop + 0.5) * uStopTexels.y, 0.75));
}

/// Colour and opacity at a share of the table's domain. Twin: optics/transfer/transfer-function.ts, evaluate
vec4 evaluateStops(float share) {
  float low = 0.0;
  float high = uStopTexels.x - 1.0;
  if (share < fetchStop(low)) return fetchStopColor(low);
  if (share >= fetchStop(high)) return fetchStopColor(high);
  for (int i = 0; i < 16; i++) {
    if (high - low < 1.5) break;
    float middle = floor(0.5 * (low + high));
    if (fetchStop(middle) <= share) low = middle;
    else high = middle;
  }
  float from = fetchStop(low);
  return mix(fetchStopColor(low), fetchStopColor(high), clamp((share - from) / (fetchStop(high) - from), 0.0, 1.0));
}

/// The colour at a place of a slice; sweep: the sweep of a cone, NO_SWEEP for other slices. False if there is no data.
/// Twin: radar/slices.ts, straightColor
bool paintSlice(vec3 local, float sweep, out vec3 color) {
  vec3 beam = toBeam(local);
  float value;
  bool valid;
  if (sweep > NO_SWEEP) valid = sampleSweep(sweep, beam, value);
  else valid = sampleBeam(beam, value);
  vec4 seen = evaluateStops(toShare(value));
  color = seen.rgb / max(seen.a, 1.0e-20);
  return valid && seen.a >= MIN_SLICE_OPACITY;
}

/// The height above a cone, in metres; slice: see uSlices. Twin: radar/slices.ts, heightOverSweep
float heightOverCone(vec3 local, vec4 slice) {
  vec2 climbed = climb(local);
#if RADIAL_ELEVATIONS
  float azimuth = degrees(arcTangent(local.x, local.y));
  float elevation = radians(elevationBetween(locateRadial(slice.y, azimuth < 0.0 ? azimuth + 360.0 : azimuth)));
  return climbed.x * cos(elevation) - climbed.y * sin(elevation);
#else
  return climbed.x * slice.z - climbed.y * slice.w;
#endif
}

/// The smallest t in an interval at which a cone is visible; the interval's exit if it is not. origin, forward: metres at t = 0, and per t.
/// Twin: radar/slices.ts, crossCone
float meetCone(vec4 slice, vec3 origin, vec3 forward, Interval interval, inout vec3 color) {
  float nearest = clamp(-dot(origin.xy, forward.xy) / max(dot(forward.xy, forward.xy), 1.0e-20), interval.entry, interval.exit);
  float before = interval.entry;
  bool wasAbove = heightOverCone(origin + forward * before, slice) >= 0.0;
  for (int i = 1 - CONE_INTERVALS; i <= CONE_INTERVALS; i++) {
    float share = float(i) / float(CONE_INTERVALS);
    float t = nearest + share * abs(share) * (share < 0.0 ? nearest - interval.entry : interval.exit - nearest);
    bool isAbove = heightOverCone(origin + forward * t, slice) >= 0.0;
    if (isAbove != wasAbove) {
      float low = before;
      float high = t;
      for (int halving = 0; halving < CONE_HALVINGS; halving++) {
        float middle = 0.5 * (low + high);
        if ((heightOverCone(origin + forward * middle, slice) >= 0.0) == wasAbove) low = middle;
        else high = middle;
      }
      float crossing = 0.5 * (low + high);
      vec3 painted;
      if (!isCutOut(crossing, slackOf(forward / uPolarSize)) && paintSlice(origin + forward * crossing, slice.y, painted)) {
        color = painted;
        return crossing;
      }
    }
    before = t;
    wasAbove = isAbove;
  }
  return interval.exit;
}

/// The t in an interval at which a level or upright slice is visible; the interval's exit if it is not.
/// Twin: radar/slices.ts, crossSlice
float meetPlane(vec4 slice, vec4 line, vec3 origin, vec3 forward, Interval interval, inout vec3 color) {
  bool isLevel = slice.x < 2.5;
  vec3 normal = isLevel ? vec3(0.0, 0.0, 1.0) : vec3(line.w, -line.z, 0.0);
  vec3 start = isLevel ? vec3(0.0, 0.0, slice.y) : vec3(line.xy, 0.0);
  float slope = dot(normal, forward);
  float t = dot(normal, start - origin) / (abs(slope) < 1.0e-9 ? 1.0e-9 : slope);
  if (t < interval.entry || t >= interval.exit || isCutOut(t, slackOf(forward / uPolarSize))) return interval.exit;
  vec3 local = origin + forward * t;
  float along = dot(local.xy - line.xy, line.zw);
  if (!isLevel && (along < 0.0 || along > slice.y)) return interval.exit;
  vec3 painted;
  if (!paintSlice(local, NO_SWEEP, painted)) return interval.exit;
  color = painted;
  return t;
}

/// The nearest slice ends a ray, behind the part of the volume in front of it. A slice on a cut face is visible from both sides.
/// Twin: radar/slices.ts, sliceInterval
Interval slicesInterval(Ray ray, Interval interval) {
  float slack = slackOf(ray.direction);
  if (!(interval.entry < interval.exit + slack)) return interval;
  Interval near = Interval(interval.entry - slack, interval.exit + slack, vec4(0.0));
  vec3 origin = uPolarLow + ray.point * uPolarSize;
  vec3 forward = ray.direction * uPolarSize;
  vec3 color = vec3(0.0);
  float end = near.exit;
  for (int i = 0; i < MAX_SLICES; i++) {
    vec4 slice = uSlices[i];
    if (slice.x < 0.5) break;
    if (slice.x < 1.5) near.exit = meetCone(slice, origin, forward, near, color);
    else near.exit = meetPlane(slice, uSliceLines[i], origin, forward, near, color);
  }
  if (near.exit >= end) return interval;
  bool isFirst = near.exit < interval.entry + slack;
  return Interval(interval.entry, isFirst ? min(interval.entry, interval.exit) : min(interval.exit, near.exit), vec4(color, 1.0));
}
