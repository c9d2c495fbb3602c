/// A pixel for each quad of 2 x 2 pixels of a lattice: whether rays end there where the lattice before says nothing of it.
void main() {
  vec2 corner = 2.0 * floor(gl_FragCoord.xy) + 0.5;
  float jump = JUMP_NONE;
  // Software GL runs through all branches, but not through loops that end.
  for (int i = 0; i < 1; i++) {
    if (!hasShapes(corner)) break;
    jump = findJump(corner);
  }
  FRAGMENT_COLOR = vec4(jump);
}
