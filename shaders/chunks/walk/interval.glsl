/// t at the eye.
uniform float uEyeT;

/// Where a ray runs through what is shown, in its parameter t; entry >= exit where it does not. Twin: optics/ray-stages.ts
struct Interval {
  float entry;
  float exit;
  /// What stands at the exit, premultiplied; nothing where it is clear.
  vec4 behind;
};
