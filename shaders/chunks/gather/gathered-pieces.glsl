/// The colour that a ray has gathered, front to back: premultiplied; and the piece of the ray before, of length 0 if it is not known.
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

/// The same limit as in composite.glsl.
bool isOpaque(Gathered gathered) {
  return gathered.color.a > 0.999;
}

bool isSettled(Gathered gathered) {
  return gathered.waits || isOpaque(gathered);
}
