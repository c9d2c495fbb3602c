/// Rings of empty cells around each cell, itself being the first; 0 where something can be seen.
uniform sampler2D uEmptySpaceDistance;

/// Whole steps from a place on the ray on in which nothing can be seen. It is asked before every step; nextLook: before this
/// place the ray stays in a cell of which is known that something can be. Source: Deakin and Knoll 2020
float countEmptySteps(CellRay ray, float along, float stepsPerLength, inout float nextLook) {
  if (along < nextLook) return 0.0;
  vec3 place = ray.origin + ray.forward * along;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float distances = floor(texture2D(uEmptySpaceDistance, placeOfCell(cell)).r * 255.0 + 0.5);
  if (distances < 0.5) {
    nextLook = along + lengthWithin(ray, place, cell, 1.0);
    return 0.0;
  }
  return max(0.0, countStepsWithin(ray, place, cell, distances, stepsPerLength));
}
