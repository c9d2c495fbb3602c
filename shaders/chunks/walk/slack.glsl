/// Two ends of a ray that are nearer to each other than this, in its t, count as the same place. Twin: optics/rays/slack.ts
float slackOf(vec3 direction) {
  vec3 along = abs(direction);
  return 1.0e-5 / max(max(along.x, along.y), along.z);
}

/// The same where a ray meets a plane: the flatter the angle, the larger the error.
float slackAt(float slope) {
  return 0.5e-5 / abs(slope);
}
