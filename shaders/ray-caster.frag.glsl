/// t at the eye.
uniform float uEyeT;

/// Step length in bounding diameters.
uniform float uStepLength;

/// Reference lengths per bounding diameter, times the opacity factor.
uniform float uOpticalScale;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;

/// Share of the table's domain at a point; p: unit cube. False where there is no data.
bool sampleShare(vec3 p, out float share) {
  float value;
  bool valid = sampleVolume(p, value);
  share = value * uTableDomain.x + uTableDomain.y;
  return valid;
}

/// What a length shows of which one end or both may have no data: the half next to an end without data is empty. Where
/// a velocity folds in between, half of it is of either end.
/// Twin: optics/reference.ts, classifyEnds
vec4 classifyEnds(float front, bool frontValid, float back, bool backValid, float ratio) {
  float from = frontValid ? front : back;
  float to = backValid ? back : front;
  float share = (frontValid ? 0.5 : 0.0) + (backValid ? 0.5 : 0.0);
#if POLAR
  bool isFolded = abs(to - from) > uFoldFrom * abs(uTableDomain.x);
  vec4 mean = meanOverSpan(from, isFolded ? from : to);
  if (isFolded) mean = 0.5 * (mean + meanOverSpan(to, to));
#else
  vec4 mean = meanOverSpan(from, to);
#endif
  return attenuate(mean, share * ratio);
}

/// Emission and absorption, front to back, premultiplied. Twin: optics/reference.ts, castRay
void main() {
  Ray ray = rayOfPixel();
  vec2 span = crossVolume(ray.point, ray.direction);
  float start = max(span.x, uEyeT);
#if SURFACES
  span.y = min(span.y, surfaceT());
#endif
#if SLICES
  vec3 sliceColor;
  float beforeSlices = span.y;
  if (start < span.y) span.y = meetSlices(ray.point, ray.direction, vec2(start, span.y), sliceColor);
#endif
  float lengthPerT = length(uUnitToDiameters * ray.direction);
  float total = (span.y - start) * lengthPerT;
  vec4 accumulated = vec4(0.0);
  if (total > 0.0) {
    float steps = max(1.0, ceil(total / uStepLength - 0.001));
    vec3 origin = ray.point + ray.direction * start;
    vec3 forward = ray.direction / lengthPerT;
    CellRay cells = enterCells(origin, forward);
    // A step's end is sampled before it is known how many samples are taken inside it. One sample is taken each time
    // around, the next inside or the end of the next step, and what lies between those known before it is gathered.
    float end = 0.0;
    float last;
    bool lastValid = sampleShare(origin, last);
    float place = end;
    float front = last;
    bool frontValid = lastValid;
    float number = 0.0;
    float insideLeft = 0.0;
    float substepLength = 0.0;
    for (int i = 0; i < MAX_SAMPLES; i++) {
      bool inside = insideLeft > 0.5;
      if (!inside && number >= steps) break;
      float empty = 0.0;
      if (!inside) empty = countEmptySteps(cells, end, 1.0 / uStepLength);
      float next = number + max(1.0, empty);
      float at = inside ? place + substepLength : (next < steps ? next * uStepLength : total);
      float value;
      bool valid = sampleShare(origin + forward * at, value);
      float to = inside ? at : end;
      float back = inside ? value : last;
      bool backValid = inside ? valid : lastValid;
      accumulated += (1.0 - accumulated.a) * classifyEnds(front, frontValid, back, backValid, (to - place) * uOpticalScale);
      // Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
      if (accumulated.a > 0.999) break;
      insideLeft -= 1.0;
      place = to;
      front = back;
      frontValid = backValid;
      if (!inside) {
        number = next;
        end = at;
        last = value;
        lastValid = valid;
        float substeps = 1.0;
        if (empty > 0.5) {
          place = at;
          front = value;
          frontValid = valid;
        } else if (frontValid || lastValid) {
          substeps = countSubsteps(frontValid ? front : last, lastValid ? last : front, 1.0 - accumulated.a);
        }
        insideLeft = substeps - 1.0;
        substepLength = (end - place) / substeps;
      }
    }
    accumulated += (1.0 - accumulated.a) * classifyEnds(front, frontValid, last, lastValid, (end - place) * uOpticalScale);
  }
#if SLICES
  if (span.y < beforeSlices) accumulated += (1.0 - accumulated.a) * vec4(sliceColor, 1.0);
#endif
  FRAGMENT_COLOR = accumulated;
}
