/// Of each cell: CELL_CODES and more where nothing can be seen, by rings of such cells around it, itself being the first;
/// below that 2 to this power is how many samples a voxel it needs. Twin: optics/empty-space-distance.ts, encodeCells
uniform sampler2D uEmptySpaceDistance;

/// What brings a cell's code to the power of 2 into which its steps are cut, see optics/power-of-steps.ts
uniform float uDetailPower;

/// 1 / 2 to a power, exactly, for powers of 0, 1, 2 and 3 and more.
float halved(float power) {
  return power < 0.5 ? 1.0 : power < 1.5 ? 0.5 : power < 2.5 ? 0.25 : 0.125;
}

/// What the cell at a place says of the ray ahead. It is asked before every step; number: whole steps.
/// Source: Deakin and Knoll 2020
Ahead lookIntoCell(CellRay ray, float number) {
  vec3 place = ray.origin + ray.forward * number;
  vec3 cell = cellAt(place);
  // Whole, but for rounding.
  float code = texture2D(uEmptySpaceDistance, placeOfCell(cell)).r * 255.0;
  float rings = code - CELL_CODES + 1.0;
  bool isEmpty = rings > 0.5;
  return Ahead(
    isEmpty ? countStepsWithin(ray, place, cell, rings) : 0.0,
    isEmpty ? 1.0 : halved(code + uDetailPower)
  );
}
