/// The way of a ray through what is shown, by its length from there in bounding diameters. Twin: optics/ray-stages.ts
struct Path {
  /// Where it begins, in the unit cube; and what a unit of length brings.
  vec3 origin;
  vec3 forward;
  float total;
};

/// A piece of a ray between two samples.
struct Segment {
  Sample front;
  Sample back;
  /// Where it begins.
  float begin;
  /// Its length; 0 where what is known begins anew after empty space.
  float span;
  /// Share of what is here that reaches the eye, as far as the gather stage knows.
  float visible;
};
