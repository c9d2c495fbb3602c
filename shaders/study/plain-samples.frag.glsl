// Post-classified samples at the middle of each step, for the accuracy study only: what most ray-casters do. The rest
// is as in ray-caster.frag.glsl.

/// t at the eye.
uniform float uEyeT;

/// Step length in bounding diameters.
uniform float uStepLength;

/// Reference lengths per bounding diameter.
uniform float uOpticalScale;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;

void main() {
  Ray ray = rayOfPixel();
  vec2 span = intersectUnitCube(ray.point, ray.direction);
  float start = max(span.x, uEyeT);
  float lengthPerT = length(uUnitToDiameters * ray.direction);
  float total = (span.y - start) * lengthPerT;
  vec4 accumulated = vec4(0.0);
  if (total > 0.0) {
    float steps = max(1.0, ceil(total / uStepLength - 0.001));
    vec3 origin = ray.point + ray.direction * start;
    vec3 forward = ray.direction / lengthPerT;
    for (int i = 0; i < MAX_SAMPLES; i++) {
      float number = float(i);
      if (number >= steps) break;
      float begin = number * uStepLength;
      float end = number < steps - 1.0 ? begin + uStepLength : total;
      float value;
      if (sampleVolume(origin + forward * (0.5 * (begin + end)), value)) {
        accumulated += (1.0 - accumulated.a) * attenuate(emissionAt(toShare(value)), (end - begin) * uOpticalScale);
      }
      if (accumulated.a > 0.999) break;
    }
  }
  FRAGMENT_COLOR = accumulated;
}
