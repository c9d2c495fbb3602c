/// Rings of empty cells around each cell, itself being the first; 0 where something can be seen.
uniform sampler2D uEmptySpaceDistance;

/// Whole steps from a place on the ray on in which nothing can be seen. It is asked before every step, and so has no branch.
/// Source: Deakin and Knoll 2020
float countEmptySteps(CellRay ray, float along, float stepsPerLength) {
  vec3 place = ray.origin + ray.forward * along;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float distances = floor(texture2D(uEmptySpaceDistance, placeOfCell(cell)).r * 255.0 + 0.5);
  float steps = countStepsWithin(ray, place, cell, distances, stepsPerLength);
  return distances < 0.5 ? 0.0 : max(0.0, steps);
}
