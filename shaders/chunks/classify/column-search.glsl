/// The column of a share, and where the column begins and ends: by bisection, if edges are too near to each other for bins.
vec3 findColumn(float share) {
  vec2 range = vec2(0.0, uColumnTexels.x - 1.0);
  for (int i = 0; i < MAX_SEARCHES; i++) {
    float middle = floor(0.5 * (range.x + range.y) + 0.5);
    if (fetchColumn(middle, 6.0).x <= share) range.x = middle;
    else range.y = middle - 1.0;
    if (range.y < range.x + 0.5) break;
  }
  return vec3(range.x, fetchColumn(range.x, 6.0).xy);
}
