/// Taps of a cartesian grid stand a voxel apart along its axes. Twin: optics/gradient.ts, cartesianGradient
vec3 beginTaps(vec3 p) {
  return p;
}

vec3 tapSteps(vec3 from) {
  return 1.0 / uDimensions;
}

bool tapField(vec3 at, out float stored) {
  return sampleVolume(at, stored);
}

vec3 growsTowards(vec3 p, vec3 from, vec3 perVoxel) {
  return perVoxel;
}
