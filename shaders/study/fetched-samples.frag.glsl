// A loop that fetches as many samples of each ray as are visible, one per voxel from the first visible one on, and only adds them up.
// No ray-caster that reads each voxel once can be faster. For the benchmark only.

/// Step length in bounding diameters.
uniform float uStepLength;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;

/// The picture of shown-samples.frag.glsl, of the same size.
uniform sampler2D uShown;

void main() {
  Ray ray = rayOfPixel();
  vec4 shown = texelFetch(uShown, ivec2(gl_FragCoord.xy), 0);
  vec3 point = ray.point + ray.direction * shown.x;
  vec3 stride = ray.direction * (uStepLength / length(uUnitToDiameters * ray.direction));
  float sum = 0.0;
  for (int i = 0; i < MAX_SAMPLES; i++) {
    if (float(i) >= shown.y) break;
    float value;
    sampleVolume(point, value);
    sum += value;
    point += stride;
  }
  FRAGMENT_COLOR = vec4(sum);
}
