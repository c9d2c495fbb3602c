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

/// Emission and absorption, front to back, premultiplied. Twin: optics/reference.ts, castRay
void main() {
  vec2 span = intersectUnitCube(vPoint, vDirection);
  float start = max(span.x, uEyeT);
#if SURFACES
  span.y = min(span.y, surfaceT());
#endif
  float lengthPerT = length(uUnitToDiameters * vDirection);
  float total = (span.y - start) * lengthPerT;
  vec4 accumulated = vec4(0.0);
  if (total > 0.0) {
    float steps = max(1.0, ceil(total / uStepLength - 0.001));
    vec3 origin = vPoint + vDirection * start;
    vec3 forward = vDirection / lengthPerT;
    float front;
    bool frontValid = sampleShare(origin, front);
    for (int i = 0; i < MAX_STEPS; i++) {
      float number = float(i);
      if (number >= steps) break;
      float begin = number * uStepLength;
      float end = number < steps - 1.0 ? begin + uStepLength : total;
      float ratio = (end - begin) * uOpticalScale;
      float back;
      bool backValid = sampleShare(origin + forward * end, back);
      if (frontValid && backValid) {
        accumulated += (1.0 - accumulated.a) * classifySegment(front, back, ratio);
      } else if (frontValid || backValid) {
        // Where data end, the nearer half of the segment belongs to the end that has some.
        float only = frontValid ? front : back;
        accumulated += (1.0 - accumulated.a) * classifySegment(only, only, 0.5 * ratio);
      }
      // Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
      if (accumulated.a > 0.999) break;
      front = back;
      frontValid = backValid;
    }
  }
  FRAGMENT_COLOR = accumulated;
}
