/// t at the eye.
uniform float uEyeT;

/// Where a ray runs through what is shown, in its parameter t; entry >= exit where it does not. Twin: optics/ray-stages.ts
struct Interval {
  float entry;
  float exit;
  /// What stands at the exit, premultiplied; nothing where it is clear.
  vec4 behind;
#ifdef GAP
  /// A part of it that is cut out: between entry and exit when it is found, or beyond all.
  vec2 gap;
#endif
};

/// Of a ray that nothing has ended yet.
Interval beginInterval() {
  Interval interval;
  interval.entry = uEyeT;
  interval.exit = 1.0e30;
  interval.behind = vec4(0.0);
#ifdef GAP
  interval.gap = vec2(1.0e30);
#endif
  return interval;
}

/// Whether what stands at t has been cut out.
bool isCutOut(Interval interval, float t) {
#ifdef GAP
  return t > interval.gap.x && t < interval.gap.y;
#else
  return false;
#endif
}
