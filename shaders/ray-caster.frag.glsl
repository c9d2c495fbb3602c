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
      float ratio = (end - begin) * uOpticalScale;
      float back;
      bool backValid = sampleShare(origin + forward * end, back);
      vec4 light = vec4(0.0);
      if (frontValid && backValid) {
        light = classifySegment(front, back, ratio);
      } else if (frontValid || backValid) {
        // Where data end, the nearer half of the segment belongs to the end that has some.
        float only = frontValid ? front : back;
        light = classifySegment(only, only, 0.5 * ratio);
      }
      accumulated += (1.0 - accumulated.a) * light;
      // Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
      if (accumulated.a > 0.999) break;
      sawNothing = light.a == 0.0;
      front = back;
      frontValid = backValid;
      number += 1.0;
    }
  }
  FRAGMENT_COLOR = accumulated;
}
