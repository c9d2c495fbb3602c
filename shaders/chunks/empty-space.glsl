/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Rings of empty cells around each cell, itself being the first; 0 where something can be seen. Slices of cells lie as
/// tiles in a 2D texture in either WebGL: x3dom sets no sampler3D but the first.
uniform sampler2D uEmptySpaceDistance;

/// Columns and rows of tiles; 1 / texels across and down.
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

/// Whole steps from a place on the ray on in which nothing can be seen. It is asked before every step, and so has no branch.
/// Source: Deakin and Knoll 2020
float countEmptySteps(CellRay ray, float along, float stepsPerLength) {
  vec3 place = ray.origin + ray.forward * along;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float row = floor((cell.z + 0.5) / uCellMosaic.x);
  vec2 texel = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy + cell.xy + 0.5;
  float distances = floor(texture2D(uEmptySpaceDistance, texel * uCellMosaic.zw).r * 255.0 + 0.5);
  vec3 wall = cell + mix(vec3(1.0 - distances), vec3(distances), ray.up);
  vec3 lengths = (wall - place) * ray.lengthPerCell;
  // A hundredth of a step is kept back for rounding.
  float steps = floor(min(min(lengths.x, lengths.y), lengths.z) * stepsPerLength - 0.01);
  return distances < 0.5 ? 0.0 : max(0.0, steps);
}
