/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Empty-space distance map: 0 where something is visible, otherwise the distance to it in cells, see
/// optics/empty-space-distance.ts. Slices of cells are tiles of a 2D texture in WebGL 1 and 2: x3dom sets only the first
/// sampler3D.
uniform sampler2D uEmptySpaceDistance;

/// Columns and rows of tiles; 1 / texels across and down.
uniform vec4 uCellMosaic;

/// A ray among the cells, by its length: its origin, cells per unit of length, and length per cell.
struct CellRay {
  vec3 origin;
  vec3 forward;
  vec3 lengthPerCell;
  /// Along each axis: 1 if the ray goes up, 0 if it goes down.
  vec3 up;
};

/// origin, forward: of the ray, in the unit cube.
CellRay enterCells(vec3 origin, vec3 forward) {
  vec3 cells = uDimensions / uCells.w;
  vec3 inCells = forward * cells;
  vec3 safe = mix(inCells, vec3(1.0e-9), vec3(lessThan(abs(inCells), vec3(1.0e-9))));
  return CellRay(origin * cells, inCells, 1.0 / safe, step(vec3(0.0), safe));
}

/// Whole steps from a position on the ray in which nothing is visible. It is called before every step, so it has no branch.
/// Source: Deakin and Knoll 2020
float countEmptySteps(CellRay ray, float along, float stepsPerLength) {
  vec3 place = ray.origin + ray.forward * along;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float row = floor((cell.z + 0.5) / uCellMosaic.x);
  vec2 texel = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy + cell.xy + 0.5;
  float distances = floor(texture2D(uEmptySpaceDistance, texel * uCellMosaic.zw).r * 255.0 + 0.5);
  vec3 wall = cell + mix(vec3(1.0 - distances), vec3(distances), ray.up);
  vec3 lengths = (wall - place) * ray.lengthPerCell;
  // A hundredth of a step is a margin for rounding.
  float steps = floor(min(min(lengths.x, lengths.y), lengths.z) * stepsPerLength - 0.01);
  return distances < 0.5 ? 0.0 : max(0.0, steps);
}
