/// Writes a pixel for each quad of 2 x 2 pixels of a lattice: whether shapes end its rays where the lattice before does not show
/// it (red), and which of its rays end at lines and points (green).
void main() {
  vec2 corner = 2.0 * floor(gl_FragCoord.xy) + 0.5;
  vec2 found = vec2(JUMP_NONE, 0.0);
  for (int i = 0; i < 1; i++) {
    if (!hasShapes(corner)) break;
    found = findJump(corner);
  }
  FRAGMENT_COLOR = vec4(found, 0.0, 1.0);
}
