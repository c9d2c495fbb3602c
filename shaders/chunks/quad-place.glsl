/// Where a quad of 2 x 2 pixels is: its place among all, 0..1; and the known pixels at its corners, in device coordinates of the
/// whole picture: their middle, and how far they are from it.
struct QuadPlace {
  vec2 at;
  vec2 middle;
  vec2 reach;
};
