/// A candidate among the eight corners of a box, and how it does; weights: of the corners. winner: value and votes.
void standForElection(float candidate, vec4 below, vec4 above, vec4 lower, vec4 upper, inout vec2 winner) {
  float votes = dot(lower, vec4(equal(below, vec4(candidate)))) + dot(upper, vec4(equal(above, vec4(candidate))));
  if (votes > winner.y || (votes == winner.y && candidate < winner.x)) winner = vec2(candidate, votes);
}

/// The value that most of a box's corners vote for by their tri-linear weights; of several with as many the smallest.
/// below, above: corners at the lower and upper end of z, (0, 0), (1, 0), (0, 1), (1, 1); share: of the way from the lower corner to
/// the upper one. Source: Hadwiger, Berger and Hauser 2003. Twin: optics/vote.ts
float voteOfCorners(vec4 below, vec4 above, vec3 share) {
  if (below == vec4(below.x) && above == vec4(below.x)) return below.x;
  vec2 across = vec2(1.0 - share.x, share.x);
  vec4 face = vec4(across * (1.0 - share.y), across * share.y);
  vec4 lower = face * (1.0 - share.z);
  vec4 upper = face * share.z;
  vec2 winner = vec2(below.x, -1.0);
  standForElection(below.x, below, above, lower, upper, winner);
  standForElection(below.y, below, above, lower, upper, winner);
  standForElection(below.z, below, above, lower, upper, winner);
  standForElection(below.w, below, above, lower, upper, winner);
  standForElection(above.x, below, above, lower, upper, winner);
  standForElection(above.y, below, above, lower, upper, winner);
  standForElection(above.z, below, above, lower, upper, winner);
  standForElection(above.w, below, above, lower, upper, winner);
  return winner.x;
}
