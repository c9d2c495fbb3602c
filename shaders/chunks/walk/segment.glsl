/// The path of a ray through the shown part of the volume, measured by the length from its begin, in bounding diameters.
/// Twin: optics/rays/ray-stages.ts
struct Path {
  /// Where it begins, in the unit cube; and how far a unit of length moves it.
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
  /// Its length; 0 for the first sample after skipped empty space.
  float span;
  /// The share of its light that reaches the eye, if the gather stage knows it.
  float visible;
};
