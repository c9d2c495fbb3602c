/// Of each cell: CELL_CODES and more where nothing can be seen, by rings of such cells around it, itself being the first;
/// below that 2 to this power is how many samples a voxel it needs. Twin: optics/empty-space-distance.ts, encodeCells
uniform sampler2D uEmptySpaceDistance;

/// Voxels of the finest axis that a step is long; 0 where cells have no say in how finely they are sampled.
uniform float uVoxelsPerStep;

/// What is known of the cell that the ray is in.
struct Known {
  /// Before this place the ray stays in a cell in which something can be seen.
  float nextLook;
  /// Substeps of each step in it, at the least.
  float leastSubsteps;
};

/// Whole steps from a place on the ray on in which nothing can be seen; less than 1 where there is none. It is asked before every step.
/// Source: Deakin and Knoll 2020
float countEmptySteps(CellRay ray, float along, float stepsPerLength, inout Known known) {
  if (along < known.nextLook) return 0.0;
  vec3 place = ray.origin + ray.forward * along;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float code = floor(texture2D(uEmptySpaceDistance, placeOfCell(cell)).r * 255.0 + 0.5);
  if (code < CELL_CODES - 0.5) {
    known = Known(along + lengthWithin(ray, place, cell, 1.0), min(MAX_SUBSTEPS, ceil(exp2(code) * uVoxelsPerStep - 0.01)));
    return 0.0;
  }
  known.leastSubsteps = 1.0;
  return countStepsWithin(ray, place, cell, code - CELL_CODES + 1.0, stepsPerLength);
}
