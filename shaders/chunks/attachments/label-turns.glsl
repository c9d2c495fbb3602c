#ifdef LABEL_TWO_BYTES
/// The sum of the votes of some of a box's corners; below, above: 1 at a corner that counts, in the order of voteOfCorners.
float countVotes(vec4 below, vec4 above, vec3 share) {
  vec2 across = vec2(1.0 - share.x, share.x);
  vec4 face = vec4(across * (1.0 - share.y), across * share.y);
  return dot(below, face) * (1.0 - share.z) + dot(above, face) * share.z;
}

/// About where a cubic that is positive at first and negative at last is 0, as a share of its way.
float crossZero(vec4 values) {
  vec3 piece = values.y <= 0.0 ? vec3(values.xy, 0.0) : values.z <= 0.0 ? vec3(values.yz, 1.0) : vec3(values.zw, 2.0);
  return (piece.z + clamp(piece.x / max(1.0e-9, piece.x - piece.y), 0.0, 1.0)) / 3.0;
}

/// The votes of some corners along a way, at its ends and thirds.
vec4 countAlong(vec4 below, vec4 above, vec3 begin, vec3 end) {
  return vec4(
    countVotes(below, above, begin),
    countVotes(below, above, mix(begin, end, 1.0 / 3.0)),
    countVotes(below, above, mix(begin, end, 2.0 / 3.0)),
    countVotes(below, above, end)
  );
}

/// Where a ray may meet a label although it meets it at neither end of a way, as a share of the way; -1 if no other label can win. A label
/// needs more than half of the votes to win against another one, and more than a third against two others.
/// from, to: in the unit cube, between the same planes of voxel centres. Twin: optics/attachments/labels.ts, labelTurn
float labelTurn(vec3 from, vec3 to) {
  vec3 begin = clamp(from * uDimensions - 0.5, vec3(0.0), uDimensions - 1.0);
  vec3 end = clamp(to * uDimensions - 0.5, vec3(0.0), uDimensions - 1.0);
  vec3 middle = 0.5 * (begin + end);
  if (labelOfCell(clamp(floor((middle + 0.5) * uLabelCells.w), vec3(0.0), uLabelCells.xyz - 1.0)) >= 0.0) return -1.0;
  vec3 low = floor(middle);
  vec4 below;
  vec4 above;
  fetchLabelCorners(low, below, above);
  if (below == vec4(below.x) && above == vec4(below.x)) return -1.0;
  begin -= low;
  end -= low;
  float first = voteOfCorners(below, above, begin);
  float last = voteOfCorners(below, above, end);
  vec4 ones = countAlong(sameAs(below, vec4(first)), sameAs(above, vec4(first)), begin, end);
  vec4 theirs = countAlong(sameAs(below, vec4(last)), sameAs(above, vec4(last)), begin, end);
  vec4 others = first == last ? 1.0 - ones : 1.0 - ones - theirs;
  vec2 inner = innerBounds(others);
  if (max(max(others.x, others.w), max(inner.x, inner.y)) <= (first == last ? 0.5 : 1.0 / 3.0) + 1.0e-5) return -1.0;
  if (first != last) return crossZero(ones - theirs);
  float most;
  float top = topOfCubic(others, most) / 3.0;
  return top > 0.0 ? top : 0.5;
}

/// Whether two samples have labels that let different amounts of light through, or have different functions.
bool differInStyle(Sample a, Sample b) {
#ifdef FUNCTIONS
  if (a.group != b.group) return true;
#endif
  return a.look.a != b.look.a;
}
#else
float labelTurn(vec3 from, vec3 to) {
  return -1.0;
}

bool differInStyle(Sample a, Sample b) {
  return false;
}
#endif
