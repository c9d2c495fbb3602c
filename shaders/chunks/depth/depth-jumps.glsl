/// Length of a step, in bounding diameters.
uniform float uStepLength;

/// Depth buffer of the shapes that end the rays of the lattice before: without lines and points. uSolids: 0 if it is empty.
uniform sampler2D uSolidDepth;
uniform float uSolids;

float solidAt(vec2 pixel) {
  return texture2D(uSolidDepth, pixel * uPixelToDepth.xy + uPixelToDepth.zw).r;
}

/// Where a pixel's ray ends. place: grows with depth, and is linear in the pixel if the ends are in a plane; slack: two
/// places that differ by less are the same; cut: the ray ends at a shape; miss: the ray does not meet the volume.
struct RayEnd {
  float place;
  float slack;
  bool cut;
  bool miss;
};

/// pixel: its centre; stored: depth of the nearest shape. Twin: optics/rays/depth-jumps.ts, rayEnd
RayEnd rayEndAt(vec2 pixel, float stored) {
  Interval interval = boxInterval(rayAt(pixel), Interval(uEyeT, 1.0e30, vec4(0.0)));
  float surface = depthToT(stored);
  float t = max(interval.entry, min(interval.exit, surface));
  bool cut = surface < interval.exit;
  bool miss = !(interval.entry < interval.exit);
  float slack = END_SLACK * uStepLength;
  if (uDepthTerms.z == 0.0) return RayEnd(t, slack, cut, miss);
  float depth = max(NEAREST_END, uDepthToT.x / uDepthToT.y + t);
  return RayEnd(-1.0 / depth, slack / (depth * depth), cut, miss);
}

RayEnd ownEnd(vec2 pixel) {
  return rayEndAt(pixel, depthAt(pixel));
}

RayEnd knownEnd(vec2 pixel) {
  return rayEndAt(pixel, solidAt(pixel));
}

bool cutsInside(RayEnd end) {
  return end.cut && !end.miss;
}

/// For a quad of 2 x 2 pixels: its jump, and which of its rays end at lines and points, as a sum of 1, 2, 4 and 8 fifteenths.
/// corner: centre of the quad's pixel at the lower left. Twin: optics/rays/depth-jumps.ts, findJump and findThin
vec2 findJump(vec2 corner) {
  // The known pixels around, and the quad's own. In a loop, because software GL needs half a second to compile each copy of `rayEndAt`.
  vec4 known = vec4(0.0);
  vec4 places = vec4(0.0);
  vec4 slacks = vec4(0.0);
  vec4 solid = vec4(0.0);
  bool cut = false;
  bool miss = false;
  for (int i = 0; i < 4; i++) {
    float number = float(i);
    vec2 offset = vec2(mod(number, 2.0), floor(0.5 * number));
    vec4 here = vec4(equal(vec4(number), vec4(0.0, 1.0, 2.0, 3.0)));
    RayEnd around = knownEnd(corner + 2.0 * offset);
    RayEnd own = ownEnd(corner + offset);
    known += here * around.place;
    places += here * own.place;
    slacks += here * own.slack;
    solid += here * knownEnd(corner + offset).place;
    cut = cut || cutsInside(around) || cutsInside(own);
    miss = miss || around.miss || own.miss;
  }
  float thin = dot(vec4(greaterThan(solid - places, slacks)), vec4(1.0, 2.0, 4.0, 8.0)) / 15.0;
  if (!cut) return vec2(JUMP_NONE, thin);
  if (miss) return vec2(JUMP_FARTHER, thin);
  vec4 expected = vec4(known.x, 0.5 * (known.x + known.y), 0.5 * (known.x + known.z), 0.25 * dot(known, vec4(1.0)));
  vec4 off = (places - expected) / slacks;
  if (max(max(off.x, off.y), max(off.z, off.w)) > 1.0) return vec2(JUMP_FARTHER, thin);
  return vec2(min(min(off.x, off.y), min(off.z, off.w)) < -1.0 ? JUMP_NEARER : JUMP_NONE, thin);
}

/// Whether there is any shape in the picture at a quad, or at the known pixels around it.
bool hasShapes(vec2 corner) {
  float nearest = min(min(depthAt(corner), depthAt(corner + vec2(1.0, 0.0))), min(depthAt(corner + vec2(0.0, 1.0)), depthAt(corner + vec2(1.0, 1.0))));
  // A loop instead of a branch: software GL runs all branches, but leaves a loop at `break`.
  for (int i = 0; i < 1; i++) {
    if (uSolids < 0.5) break;
    nearest = min(nearest, min(solidAt(corner + vec2(2.0, 0.0)), min(solidAt(corner + vec2(0.0, 2.0)), solidAt(corner + vec2(2.0, 2.0)))));
  }
  return nearest < 1.0;
}
