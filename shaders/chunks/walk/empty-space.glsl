/// A code for each cell. Codes above LAST_CODE: nothing can be seen in the cell, and what is above it counts the rings of such cells
/// around it (the cell itself is the first). Other codes: the cell needs 2 to this power samples for each voxel.
/// Twin: optics/cells/empty-space-distance.ts, encodeCells
uniform sampler2D uEmptySpaceDistance;

/// Add this to a cell's code to get the power of 2 of the parts into which its steps are cut, see optics/transfer/power-of-steps.ts
uniform float uDetailPower;

#ifndef LONG
/// The distance of samples in a cell, in steps: exactly 1 / 2 to a power, of 0, 1, 2 or 3; larger powers count as 3.
float spacingOf(float code, float power, float within) {
  power += code;
  return power < 0.5 ? 1.0 : power < 1.5 ? 0.5 : power < 2.5 ? 0.25 : 0.125;
}
#endif

/// What the cell at a place says about the ray ahead. The walk calls it before every step; number: whole steps.
/// Source: Deakin and Knoll 2020
Ahead lookAhead(CellRay ray, float number, Gathered gathered) {
  vec3 place = ray.origin + ray.forward * number;
  vec3 cell = cellAt(place);
  // A whole number, except for rounding.
  float code = texture2D(uEmptySpaceDistance, placeOfCell(cell)).r * 255.0;
  float rings = code - LAST_CODE;
  float within = countStepsWithin(ray, place, cell, max(1.0, rings));
  bool isEmpty = rings > 0.5;
  return Ahead(isEmpty ? within : 0.0, isEmpty ? 1.0 : spacingOf(code, uDetailPower, within));
}
