/// Length of a step, in bounding diameters.
uniform float uStepLength;

/// Where a pixel's ray ends. place: grows with depth, and is linear in the pixel where the ends lie in a plane; slack: two
/// places that differ by less are the same; cut: at a shape; miss: the ray does not meet the volume.
struct RayEnd {
  float place;
  float slack;
  bool cut;
  bool miss;
};

/// pixel: its centre. Twin: optics/depth-jumps.ts, rayEnd
RayEnd rayEndAt(vec2 pixel) {
  Interval interval = boxInterval(rayAt(pixel), Interval(uEyeT, 1.0e30, vec4(0.0)));
  float surface = surfaceTAt(pixel);
  float t = max(interval.entry, min(interval.exit, surface));
  bool cut = surface < interval.exit;
  bool miss = !(interval.entry < interval.exit);
  float slack = END_SLACK * uStepLength;
  if (uDepthTerms.z == 0.0) return RayEnd(t, slack, cut, miss);
  float depth = max(NEAREST_END, uDepthToT.x / uDepthToT.y + t);
  return RayEnd(-1.0 / depth, slack / (depth * depth), cut, miss);
}

/// corner: centre of the pixel at the lower left of a quad of 2 x 2. Twin: optics/depth-jumps.ts, findJump
float findJump(vec2 corner) {
  RayEnd a = rayEndAt(corner);
  RayEnd b = rayEndAt(corner + vec2(2.0, 0.0));
  RayEnd c = rayEndAt(corner + vec2(0.0, 2.0));
  RayEnd d = rayEndAt(corner + vec2(2.0, 2.0));
  RayEnd right = rayEndAt(corner + vec2(1.0, 0.0));
  RayEnd above = rayEndAt(corner + vec2(0.0, 1.0));
  RayEnd amid = rayEndAt(corner + vec2(1.0, 1.0));
  bool cut = (a.cut && !a.miss) || (b.cut && !b.miss) || (c.cut && !c.miss) || (d.cut && !d.miss)
    || (right.cut && !right.miss) || (above.cut && !above.miss) || (amid.cut && !amid.miss);
  if (!cut) return JUMP_NONE;
  if (a.miss || b.miss || c.miss || d.miss || right.miss || above.miss || amid.miss) return JUMP_FARTHER;
  vec3 expected = vec3(0.5 * (a.place + b.place), 0.5 * (a.place + c.place), 0.25 * (a.place + b.place + c.place + d.place));
  vec3 off = (vec3(right.place, above.place, amid.place) - expected) / vec3(right.slack, above.slack, amid.slack);
  if (max(off.x, max(off.y, off.z)) > 1.0) return JUMP_FARTHER;
  return min(off.x, min(off.y, off.z)) < -1.0 ? JUMP_NEARER : JUMP_NONE;
}

/// Whether any shape stands in the picture around a quad.
bool hasShapes(vec2 corner) {
  float nearest = min(depthAt(corner), depthAt(corner + vec2(1.0, 0.0)));
  nearest = min(nearest, min(depthAt(corner + vec2(0.0, 1.0)), depthAt(corner + vec2(1.0, 1.0))));
  nearest = min(nearest, min(depthAt(corner + vec2(2.0, 0.0)), depthAt(corner + vec2(0.0, 2.0))));
  return min(nearest, depthAt(corner + vec2(2.0, 2.0))) < 1.0;
}
