/// Where a line enters and leaves the unit cube, in the line's parameter; entry > exit if it misses the cube.
/// Source: Kay and Kajiya 1986. Twin: optics/rays/rays.ts, intersectUnitCube
vec2 intersectUnitCube(vec3 point, vec3 direction) {
  vec3 d = mix(direction, vec3(1.0e-9), vec3(lessThan(abs(direction), vec3(1.0e-9))));
  vec3 t0 = -point / d;
  vec3 t1 = (1.0 - point) / d;
  vec3 near = min(t0, t1);
  vec3 far = max(t0, t1);
  return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}
