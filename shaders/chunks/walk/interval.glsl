/// t at the eye.
uniform float uEyeT;

/// Where a ray runs through the shown part of the volume, in its parameter t; entry >= exit if it misses that part. Twin: optics/rays/ray-stages.ts
struct Interval {
  float entry;
  float exit;
  /// The colour at the exit (of a slice, for example), premultiplied; 0 if there is none.
  vec4 behind;
};
