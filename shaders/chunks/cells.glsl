/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Columns and rows of tiles; 1 / texels across and down. Slices of cells lie as tiles in a 2D texture in either WebGL:
/// x3dom sets no sampler3D but the first.
uniform vec4 uCellMosaic;

/// A ray among the cells, by its length: where it begins, what a unit of length brings, and what brings it a cell on.
struct CellRay {
  vec3 origin;
  vec3 forward;
  vec3 lengthPerCell;
  /// Along each axis: 1 where the ray goes up, 0 where it goes down.
  vec3 up;
};

/// origin, forward: of the ray, in the unit cube.
CellRay enterCells(vec3 origin, vec3 forward) {
  vec3 cells = uDimensions / uCells.w;
  vec3 inCells = forward * cells;
  vec3 safe = mix(inCells, vec3(1.0e-9), vec3(lessThan(abs(inCells), vec3(1.0e-9))));
  return CellRay(origin * cells, inCells, 1.0 / safe, step(vec3(0.0), safe));
}

/// Where a cell lies in a texture of cells; cell: whole numbers.
vec2 placeOfCell(vec3 cell) {
  float row = floor((cell.z + 0.5) / uCellMosaic.x);
  vec2 texel = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy + cell.xy + 0.5;
  return texel * uCellMosaic.zw;
}

/// Length from a place on the ray on that stays within so many rings of cells around that of the place.
float lengthWithin(CellRay ray, vec3 place, vec3 cell, float rings) {
  vec3 wall = cell + mix(vec3(1.0 - rings), vec3(rings), ray.up);
  vec3 lengths = (wall - place) * ray.lengthPerCell;
  return min(min(lengths.x, lengths.y), lengths.z);
}

/// The same in whole steps.
float countStepsWithin(CellRay ray, vec3 place, vec3 cell, float rings, float stepsPerLength) {
  // A hundredth of a step is kept back for rounding.
  return floor(lengthWithin(ray, place, cell, rings) * stepsPerLength - 0.01);
}
