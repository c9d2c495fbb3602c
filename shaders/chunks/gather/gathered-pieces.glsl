/// What a ray has gathered: premultiplied, front to back; and the piece of the ray before, of length 0 where that is not known.
struct Gathered {
  vec4 color;
  vec3 pointBefore;
  float valueBefore;
  float spanBefore;
  /// The ray waits for a closer look at the last segment.
  bool waits;
};

Gathered beginGathering() {
  Gathered gathered;
  gathered.color = vec4(0.0);
  gathered.spanBefore = 0.0;
  gathered.waits = false;
  return gathered;
}

/// As of composite.glsl.
bool isOpaque(Gathered gathered) {
  return gathered.color.a > 0.999;
}

bool isSettled(Gathered gathered) {
  return gathered.waits || isOpaque(gathered);
}
