/// Taps of a radar stand as far apart as its beam is wide: metres along it at the least, and degrees. Twin: radar/polar-gradient.ts
uniform vec2 uBeamTaps;

vec3 beginTaps(vec3 p) {
  return toBeam(uPolarLow + p * uPolarSize);
}

/// from: range, azimuth and elevation.
vec3 tapSteps(vec3 from) {
  return vec3(max(uBeamTaps.x, from.x * radians(uBeamTaps.y)), uBeamTaps.yy);
}

bool tapField(vec3 at, out float stored) {
  float azimuth = at.y < 0.0 ? at.y + 360.0 : at.y;
  return sampleBeam(vec3(at.x, azimuth < 360.0 ? azimuth : azimuth - 360.0, at.z), stored);
}

/// Per metre east, north and up: the transpose of the derivatives of `toBeam`. Twin: radar/polar-gradient.ts, beamToLocalGradient
vec3 growsTowards(vec3 p, vec3 from, vec3 perVoxel) {
  vec3 local = uPolarLow + p * uPolarSize;
  vec3 steps = tapSteps(from);
  float byRange = perVoxel.x / steps.x;
  vec2 byAngles = perVoxel.yz / radians(steps.yz);
  vec2 angles = radians(from.yz);
  float sine = sin(angles.y);
  float cosine = cos(angles.y);
  float turn = byAngles.y / max(1.0e-3, from.x);
  float byUp = byRange * sine + turn * cosine;
  float byAlong = byRange * cosine - turn * sine;
  float up = from.x * sine * uCurvature;
  float along = from.x * cosine * uCurvature;
  float byArc = byAlong * (1.0 + up) - byUp * along;
  float byHeight = (byUp * (1.0 + up) + byAlong * along) / (1.0 + local.z * uCurvature);
  vec2 outward = vec2(sin(angles.x), cos(angles.x));
  vec2 clockwise = vec2(outward.y, -outward.x);
  return vec3(byArc * outward + byAngles.x / max(1.0e-3, length(local.xy)) * clockwise, byHeight);
}
