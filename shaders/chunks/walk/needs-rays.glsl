/// For each quad of 2 x 2 pixels: whether shapes end its rays where the lattice before does not show it, see depth-jumps.glsl.
uniform sampler2D uDepthJumps;

/// Pixels whose brightest channel is at most this count as black.
uniform float uFaint;

/// Whether a quad needs rays because of shapes. Twin: optics/rays/depth-jumps.ts, needsRays
bool needsRaysAtJumps(QuadPlace place, Surroundings s) {
  vec4 largest = max(max(s.a, s.b), max(s.c, s.d));
  bool dark = max(max(largest.r, largest.g), max(largest.b, largest.a)) <= uFaint;
  return texture2D(uDepthJumps, place.at).r > (dark ? 0.75 : 0.25);
}
