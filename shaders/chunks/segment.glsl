/// A piece of a ray between two samples.
struct Segment {
  Sample front;
  Sample back;
  /// In bounding diameters; 0 where what is known begins anew after empty space.
  float span;
};
