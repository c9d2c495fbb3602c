/// 1 where two values are the same.
vec4 sameAs(vec4 a, vec4 b) {
  return vec4(equal(a, b));
}

/// The winner of two candidates (value and votes); with equal votes, the smaller value wins.
vec2 electOne(vec2 one, vec2 other) {
  return other.y > one.y || (other.y == one.y && other.x < one.x) ? other : one;
}

/// The value with the most votes of a box's corners, where a vote counts by its tri-linear weight; with equal votes, the smallest value wins.
/// below, above: corners at the lower and upper end of z, (0, 0), (1, 0), (0, 1), (1, 1); share: of the way from the lower corner to
/// the upper one. Each corner gets the votes of all corners with the same value; each pair of neighbours is compared only once.
/// Source: Hadwiger, Berger and Hauser 2003. Twin: optics/rays/vote.ts
float voteOfCorners(vec4 below, vec4 above, vec3 share) {
  if (below == vec4(below.x) && above == vec4(below.x)) return below.x;
  vec2 across = vec2(1.0 - share.x, share.x);
  vec4 face = vec4(across * (1.0 - share.y), across * share.y);
  vec4 lower = face * (1.0 - share.z);
  vec4 upper = face * share.z;
  vec4 beside = sameAs(below, below.yzwx);
  vec4 low = lower + beside * lower.yzwx + beside.wxyz * lower.wxyz + sameAs(below, below.zwxy) * lower.zwxy;
  beside = sameAs(above, above.yzwx);
  vec4 high = upper + beside * upper.yzwx + beside.wxyz * upper.wxyz + sameAs(above, above.zwxy) * upper.zwxy;
  vec4 over = sameAs(below, above);
  low += over * upper;
  high += over * lower;
  over = sameAs(below, above.yzwx);
  low += over * upper.yzwx;
  high += over.wxyz * lower.wxyz;
  over = sameAs(below, above.zwxy);
  low += over * upper.zwxy;
  high += over.zwxy * lower.zwxy;
  over = sameAs(below, above.wxyz);
  low += over * upper.wxyz;
  high += over.yzwx * lower.yzwx;
  vec2 winner = electOne(electOne(vec2(below.x, low.x), vec2(below.y, low.y)), electOne(vec2(below.z, low.z), vec2(below.w, low.w)));
  vec2 other = electOne(electOne(vec2(above.x, high.x), vec2(above.y, high.y)), electOne(vec2(above.z, high.z), vec2(above.w, high.w)));
  return electOne(winner, other).x;
}
