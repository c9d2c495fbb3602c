/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Columns of tiles, and 1 / columns; 1 / texels across and down. Slices of cells lie as tiles in a 2D texture in either WebGL:
/// x3dom sets no sampler3D but the first.
uniform vec4 uCellMosaic;

/// A ray among the cells, by its steps: where it begins, what a step brings, and how many steps bring it a cell on.
struct CellRay {
  vec3 origin;
  vec3 forward;
  vec3 stepsPerCell;
  /// Along each axis: 1 where the ray goes up, 0 where it goes down.
  vec3 up;
};

/// What lies ahead of a place on a ray.
struct Ahead {
  /// Whole steps on which nothing can change what is gathered; below 1 where there is none.
  float skipped;
  /// Of a step that begins there, the share from sample to sample, at the most: 1 or a half, a quarter, an eighth.
  float spacing;
};

/// origin, forward: of the ray, in the unit cube, and what a step brings.
CellRay enterCells(vec3 origin, vec3 forward) {
  vec3 cells = uDimensions / uCells.w;
  vec3 inCells = forward * cells;
  vec3 safe = mix(inCells, vec3(1.0e-9), vec3(lessThan(abs(inCells), vec3(1.0e-9))));
  return CellRay(origin * cells, inCells, 1.0 / safe, step(vec3(0.0), safe));
}

/// Where a cell lies in a texture of cells; cell: whole numbers.
vec2 placeOfCell(vec3 cell) {
  float row = floor((cell.z + 0.5) * uCellMosaic.y);
  vec2 texel = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy + cell.xy + 0.5;
  return texel * uCellMosaic.zw;
}

/// Steps from a place on the ray on that stay within so many rings of cells around that of the place.
float stepsWithin(CellRay ray, vec3 place, vec3 cell, float rings) {
  vec3 wall = cell + mix(vec3(1.0 - rings), vec3(rings), ray.up);
  vec3 steps = (wall - place) * ray.stepsPerCell;
  return min(min(steps.x, steps.y), steps.z);
}

/// The same in whole steps.
float countStepsWithin(CellRay ray, vec3 place, vec3 cell, float rings) {
  // A hundredth of a step is kept back for rounding.
  return floor(stepsWithin(ray, place, cell, rings) - 0.01);
}

/// The cell that a place on the ray is in.
vec3 cellAt(vec3 place) {
  return clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
}
