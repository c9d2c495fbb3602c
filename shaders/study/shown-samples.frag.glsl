// Finds which samples of a ray are visible, only for the benchmark's lower bound: steps of a voxel, each with the mean of its
// ends as in ray-caster.frag.glsl. It draws t of the first visible step and the number of visible steps, instead of a colour.

/// t at the eye.
uniform float uEyeT;

/// Step length in bounding diameters.
uniform float uStepLength;

/// Reference lengths per bounding diameter.
uniform float uOpticalScale;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;

/// A step with a smaller share of its ray's light counts as not visible: 200 such steps together are half of 1/255.
#define MIN_SHOWN 1.0e-5

void main() {
  Ray ray = rayOfPixel();
  vec2 span = intersectUnitCube(ray.point, ray.direction);
  float start = max(span.x, uEyeT);
  float tPerStep = uStepLength / length(uUnitToDiameters * ray.direction);
  float steps = ceil((span.y - start) / tPerStep);
  Sample front = sampleField(ray.point + ray.direction * start);
  float seen = 0.0;
  float first = 0.0;
  float shown = 0.0;
  for (int i = 0; i <= MAX_SAMPLES; i++) {
    float number = float(i);
    if (number > steps || seen > 0.999) break;
    float t = start + number * tPerStep;
    Sample back = sampleField(ray.point + ray.direction * t);
    if (i > 0 && hasData(back) && hasData(front)) {
      float alpha = attenuate(meanOfSamples(front, back), uStepLength * uOpticalScale).a;
      if ((1.0 - seen) * alpha > MIN_SHOWN) {
        if (shown < 0.5) first = t - tPerStep;
        shown += 1.0;
      }
      seen += (1.0 - seen) * alpha;
    }
    front = back;
  }
  FRAGMENT_COLOR = vec4(first, shown, seen, 1.0);
}
