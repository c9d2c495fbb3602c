varying vec3 vPoint;
varying vec3 vDirection;

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
/// a velocity folds in between, each half belongs to its end.
/// Twin: optics/reference.ts, classifyEnds
vec4 classifyEnds(float front, bool frontValid, float back, bool backValid, float ratio) {
  if (!frontValid && !backValid) return vec4(0.0);
#if POLAR
  if (frontValid && backValid && abs(back - front) > uFoldFrom * abs(uTableDomain.x)) {
    vec4 nearer = classifySegment(front, front, 0.5 * ratio);
    return nearer + (1.0 - nearer.a) * classifySegment(back, back, 0.5 * ratio);
  }
#endif
  if (frontValid && backValid) return classifySegment(front, back, ratio);
  float only = frontValid ? front : back;
  return classifySegment(only, only, 0.5 * ratio);
}

/// Emission and absorption, front to back, premultiplied. Twin: optics/reference.ts, castRay
void main() {
  vec2 span = crossVolume(vPoint, vDirection);
  float start = max(span.x, uEyeT);
#if SURFACES
  span.y = min(span.y, surfaceT());
#endif
#if SLICES
  vec3 sliceColor;
  float beforeSlices = span.y;
  span.y = meetSlices(vPoint, vDirection, vec2(start, span.y), sliceColor);
#endif
  float lengthPerT = length(uUnitToDiameters * vDirection);
  float total = (span.y - start) * lengthPerT;
  vec4 accumulated = vec4(0.0);
  if (total > 0.0) {
    float steps = max(1.0, ceil(total / uStepLength - 0.001));
    vec3 origin = vPoint + vDirection * start;
    vec3 forward = vDirection / lengthPerT;
    vec3 stride = forward * uStepLength;
    float front;
    bool frontValid = sampleShare(origin, front);
    bool sawNothing = true;
    float number = 0.0;
    for (int i = 0; i < MAX_STEPS; i++) {
      if (number >= steps) break;
      if (sawNothing) {
        float empty = countEmptySteps(origin + stride * number, stride);
        if (empty > 0.5) {
          number += empty;
          if (number >= steps) break;
          frontValid = sampleShare(origin + stride * number, front);
        }
      }
      float begin = number * uStepLength;
      float end = number < steps - 1.0 ? begin + uStepLength : total;
      float last;
      bool lastValid = sampleShare(origin + forward * end, last);
      float before = accumulated.a;
      float parts = 1.0;
      if (frontValid || lastValid) parts = countParts(frontValid ? front : last, lastValid ? last : front, 1.0 - before);
      float partLength = (end - begin) / parts;
      for (float part = 1.0; part <= MOST_PARTS; part += 1.0) {
        float back = last;
        bool backValid = lastValid;
        if (part < parts) backValid = sampleShare(origin + forward * (begin + part * partLength), back);
        vec4 light = classifyEnds(front, frontValid, back, backValid, partLength * uOpticalScale);
        accumulated += (1.0 - accumulated.a) * light;
        front = back;
        frontValid = backValid;
        if (part >= parts) break;
      }
      // Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
      if (accumulated.a > 0.999) break;
      sawNothing = accumulated.a == before;
      number += 1.0;
    }
  }
#if SLICES
  if (span.y < beforeSlices) accumulated += (1.0 - accumulated.a) * vec4(sliceColor, 1.0);
#endif
  FRAGMENT_COLOR = accumulated;
}
