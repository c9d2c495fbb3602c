varying vec3 vPoint;
varying vec3 vDirection;

/// t at the eye.
uniform float uEyeT;

/// Step length in bounding diameters.
uniform float uStepLength;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;

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
    for (int i = 0; i < MAX_STEPS; i++) {
      float number = float(i);
      if (number >= steps) break;
      float begin = number * uStepLength;
      bool last = number >= steps - 1.0;
      float stepLength = last ? total - begin : uStepLength;
      float value;
      if (sampleVolume(origin + forward * (begin + 0.5 * stepLength), value)) {
        vec4 light = last ? classifyPart(value, stepLength / uStepLength) : classify(value);
        accumulated += (1.0 - accumulated.a) * light;
        // Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
        if (accumulated.a > 0.999) break;
      }
    }
  }
  FRAGMENT_COLOR = accumulated;
}
