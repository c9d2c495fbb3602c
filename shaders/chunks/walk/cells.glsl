/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Columns of tiles, and 1 / columns; 1 / texels across and down. Slices of cells are tiles of a 2D texture in both
/// versions of WebGL, because x3dom sets only the first sampler3D.
uniform vec4 uCellMosaic;

/// A ray in the grid of cells: where it begins, how far a step moves it, and how many steps it takes from one cell to the next.
struct CellRay {
  vec3 origin;
  vec3 forward;
  vec3 stepsPerCell;
  /// Along each axis: 1 if the coordinate increases along the ray, 0 if it decreases.
  vec3 up;
};

/// What the cells say about the ray ahead of a place.
struct Ahead {
  /// Whole steps that can't change what is gathered; below 1 if there are none.
  float skipped;
  /// The maximum distance of samples that begin there, in steps: 1, a half, a quarter or an eighth; more only in bricks of coarser levels.
  float spacing;
};

/// origin: of the ray, in the unit cube; forward: how far a step moves it.
CellRay enterCells(vec3 origin, vec3 forward) {
  vec3 cells = uDimensions / uCells.w;
  vec3 inCells = forward * cells;
  vec3 safe = mix(inCells, vec3(1.0e-9), vec3(lessThan(abs(inCells), vec3(1.0e-9))));
  return CellRay(origin * cells, inCells, 1.0 / safe, step(vec3(0.0), safe));
}

/// The place of a cell in a texture of cells; cell: whole numbers.
vec2 placeOfCell(vec3 cell) {
  float row = floor((cell.z + 0.5) * uCellMosaic.y);
  vec2 texel = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy + cell.xy + 0.5;
  return texel * uCellMosaic.zw;
}

/// How many whole steps, from a place on the ray, stay within a number of rings of cells around the cell of that place.
float countStepsWithin(CellRay ray, vec3 place, vec3 cell, float rings) {
  vec3 wall = cell + mix(vec3(1.0 - rings), vec3(rings), ray.up);
  vec3 steps = (wall - place) * ray.stepsPerCell;
  // A margin of a hundredth of a step allows for rounding.
  return floor(min(min(steps.x, steps.y), steps.z) - 0.01);
}

/// The cell that a place on the ray is in.
vec3 cellAt(vec3 place) {
  return clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
}
