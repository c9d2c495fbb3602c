/// Where two things that end a ray are nearer to each other than this, in its t, they are at one place. Twin: optics/slack.ts
float slackOf(vec3 direction) {
  vec3 along = abs(direction);
  return 1.0e-5 / max(max(along.x, along.y), along.z);
}

/// The same where a ray meets a plane: the flatter it does, the farther it is off.
float slackAt(float slope) {
  return 0.5e-5 / abs(slope);
}
