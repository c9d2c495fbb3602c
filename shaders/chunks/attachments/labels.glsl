/// LABELS_ACROSS texels in a row. First a texel for each label: its colour (red plus twice its group), and the factor of its extinction.
/// Then a texel for each four cells: the label of a cell, or -1 if the cell has several labels.
uniform sampler2D uLabelTable;

/// The row of the first cells; 1 / the number of rows.
uniform vec2 uLabelTableRows;

/// Cells along i, j and k; 1 / voxels along the edge of a cell.
uniform vec4 uLabelCells;

vec4 fetchLabelTable(float texel, float firstRow) {
  float row = floor((texel + 0.5) / LABELS_ACROSS);
  return texture2D(uLabelTable, vec2((texel - row * LABELS_ACROSS + 0.5) / LABELS_ACROSS, (firstRow + row + 0.5) * uLabelTableRows.y));
}

/// The last appearance that was fetched, and its label: along a ray many samples have the same label.
float lastLabel = -1.0;
vec4 lastLook;

/// The appearance of a label.
vec4 lookOf(float number) {
  if (number != lastLabel) lastLook = fetchLabelTable(number, 0.0);
  lastLabel = number;
  return lastLook;
}

/// The cell that was looked up last, and its label.
vec3 lastCell = vec3(-1.0);
float lastCellLabel;

/// The only label of a cell, or -1 if it has several; cell: whole numbers.
float labelOfCell(vec3 cell) {
  if (cell != lastCell) {
    float index = cell.x + uLabelCells.x * (cell.y + uLabelCells.y * cell.z);
    float texel = floor(0.25 * index);
    vec4 four = fetchLabelTable(texel, uLabelTableRows.x);
    float place = index - 4.0 * texel;
    lastCellLabel = place < 1.5 ? (place < 0.5 ? four.x : four.y) : (place < 2.5 ? four.z : four.w);
  }
  lastCell = cell;
  return lastCellLabel;
}

/// Number of a voxel's label; index: whole numbers, inside the grid.
float fetchLabel(vec3 index) {
  vec4 texel = fetchLabelTexel(index);
#if LABEL_TWO_BYTES
#if WEBGL2
  float high = texel.g;
#else
  float high = texel.a;
#endif
  return floor(texel.r * 255.0 + 0.5) + 256.0 * floor(high * 255.0 + 0.5);
#else
  return floor(texel.r * 255.0 + 0.5);
#endif
}

/// Numbers of the labels at the corners of a box between eight voxel centres, in the order of voteOfCorners; low: the lowest corner.
void fetchLabelCorners(vec3 low, out vec4 below, out vec4 above) {
  vec3 high = min(low + 1.0, uDimensions - 1.0);
  below = vec4(fetchLabel(low), fetchLabel(vec3(high.x, low.yz)), fetchLabel(vec3(low.x, high.y, low.z)), fetchLabel(vec3(high.xy, low.z)));
  above = vec4(fetchLabel(vec3(low.xy, high.z)), fetchLabel(vec3(high.x, low.y, high.z)), fetchLabel(vec3(low.x, high.yz)), fetchLabel(high));
}

/// The number of the label at a place in a cell with several labels; position: in voxels, see optics/rays/vote.ts
float voteAt(vec3 position) {
  vec3 low = floor(position);
  vec4 below;
  vec4 above;
  fetchLabelCorners(low, below, above);
  return voteOfCorners(below, above, position - low);
}

/// Adds the appearance of the label at a place; p: unit cube. For projections, which show only values, hidden labels have no data.
/// Twin: optics/attachments/labels.ts, labelField
Sample labelsField(vec3 p, Sample known) {
  vec3 voxel = p * uDimensions;
  float number = labelOfCell(clamp(floor(voxel * uLabelCells.w), vec3(0.0), uLabelCells.xyz - 1.0));
  if (number < 0.0) number = voteAt(clamp(voxel - 0.5, vec3(0.0), uDimensions - 1.0));
  known.look = lookOf(number);
#ifdef FUNCTIONS
  known.group = floor(0.5 * known.look.r);
  known.look.r -= 2.0 * known.group;
#endif
#if LABELS_HIDE
  known.valid = known.valid && known.look.a > 0.0;
#endif
  return known;
}
