/// Cells along i, j and k, and voxels along the edge of each.
uniform vec4 uCells;

/// Rings of empty cells around each cell, itself being the first; 0 where something can be seen. Slices of cells lie as
/// tiles in a 2D texture in either WebGL: x3dom sets no sampler3D but the first.
uniform sampler2D uEmptiness;

/// Columns and rows of tiles; 1 / texels across and down.
uniform vec4 uCellMosaic;

float fetchRings(vec3 cell) {
  float row = floor((cell.z + 0.5) / uCellMosaic.x);
  vec2 origin = vec2(cell.z - row * uCellMosaic.x, row) * uCells.xy;
  return floor(texture2D(uEmptiness, (origin + cell.xy + 0.5) * uCellMosaic.zw).r * 255.0 + 0.5);
}

/// Whole steps from a point on in which nothing can be seen; p: unit cube; forward: one step, in the unit cube.
/// Source: Deakin and Knoll 2020
float countEmptySteps(vec3 p, vec3 forward) {
  vec3 place = p * uDimensions / uCells.w;
  vec3 cell = clamp(floor(place), vec3(0.0), uCells.xyz - 1.0);
  float rings = fetchRings(cell);
  if (rings < 0.5) return 0.0;
  vec3 stride = forward * uDimensions / uCells.w;
  stride = mix(stride, vec3(1.0e-9), vec3(lessThan(abs(stride), vec3(1.0e-9))));
  vec3 wall = mix(cell + 1.0 - rings, cell + rings, step(vec3(0.0), stride));
  vec3 steps = (wall - place) / stride;
  // A hundredth of a step is kept back for rounding.
  return max(0.0, floor(min(min(steps.x, steps.y), steps.z) - 0.01));
}
