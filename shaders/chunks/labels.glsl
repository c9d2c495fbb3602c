/// Of each label its colour and the factor of its extinction, LABELS_ACROSS in a row.
uniform sampler2D uLabelStyles;

/// 1 / its rows.
uniform float uLabelStyleRow;

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

/// Number of the label of a place; p: unit cube.
float labelAt(vec3 p) {
  vec3 position = clamp(p * uDimensions - 0.5, vec3(0.0), uDimensions - 1.0);
  vec3 low = floor(position);
  vec3 high = min(low + 1.0, uDimensions - 1.0);
  vec4 below = vec4(fetchLabel(low), fetchLabel(vec3(high.x, low.yz)), fetchLabel(vec3(low.x, high.y, low.z)), fetchLabel(vec3(high.xy, low.z)));
  vec4 above = vec4(fetchLabel(vec3(low.xy, high.z)), fetchLabel(vec3(high.x, low.y, high.z)), fetchLabel(vec3(low.x, high.yz)), fetchLabel(high));
  return voteOfCorners(below, above, position - low);
}

/// What the label of a place looks like. Where nothing but values counts, what is hidden is without data.
/// Twin: optics/labels.ts, labelField
Sample labelsField(vec3 p, Sample known) {
  float number = labelAt(p);
  float row = floor((number + 0.5) / LABELS_ACROSS);
  known.look = texture2D(uLabelStyles, vec2((number - row * LABELS_ACROSS + 0.5) / LABELS_ACROSS, (row + 0.5) * uLabelStyleRow));
#if LABELS_HIDE
  known.valid = known.valid && known.look.a > 0.0;
#endif
  return known;
}
