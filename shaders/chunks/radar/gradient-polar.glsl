/// The taps of a radar are one beam width apart: the minimum in metres along the beam, and degrees. Twin: radar/polar-gradient.ts
uniform vec2 uBeamTaps;

vec3 beginTaps(vec3 p) {
  return toBeam(uPolarLow + p * uPolarSize);
}

/// from: range, azimuth and elevation.
vec3 tapSteps(vec3 from) {
  return vec3(max(uBeamTaps.x, from.x * radians(uBeamTaps.y)), uBeamTaps.yy);
}

float wrapAzimuth(float azimuth) {
  float positive = azimuth < 0.0 ? azimuth + 360.0 : azimuth;
  return positive < 360.0 ? positive : positive - 360.0;
}

#define TAPS_IN_LOOP

bool tapField(vec3 at, out float stored) {
  return sampleBeam(vec3(at.x, wrapAzimuth(at.y), at.z), stored);
}

/// Per metre east, north and up: the transpose of the derivatives of `toBeam`. Twin: radar/polar-gradient.ts, beamToLocalGradient
vec3 growsTowards(vec3 p, vec3 from, vec3 perVoxel) {
  vec3 local = uPolarLow + p * uPolarSize;
  vec3 steps = tapSteps(from);
  float range = max(1.0e-3, from.x);
  float arc = max(1.0e-3, length(local.xy));
  float byRange = perVoxel.x / steps.x;
  vec2 byAngles = perVoxel.yz / radians(steps.yz);
  // The way up from the antenna's plane and the way along it, as shares of the range: sine and cosine of the elevation.
  vec2 climbed = climb(local);
  vec2 rise = climbed / range;
  float turn = byAngles.y / range;
  float byUp = byRange * rise.x + turn * rise.y;
  float byAlong = byRange * rise.y - turn * rise.x;
  vec2 curved = climbed * uCurvature;
  float byArc = byAlong * (1.0 + curved.x) - byUp * curved.y;
  float byHeight = (byUp * (1.0 + curved.x) + byAlong * curved.y) / (1.0 + local.z * uCurvature);
  vec2 outward = local.xy / arc;
  return vec3(byArc * outward + byAngles.x / arc * vec2(outward.y, -outward.x), byHeight);
}
