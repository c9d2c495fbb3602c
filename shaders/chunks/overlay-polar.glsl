/// Data values of another moment, laid out as the volume's gates are.
uniform sampler2D uOverlay;

#if OVERLAY_FOLDS
/// Velocities more than this apart are on two sides of a fold.
uniform float uOverlayFoldFrom;
#endif

/// Data value of a gate; below -3e38 there is none. place: in the texture.
float fetchOverlayGate(vec2 place) {
  return texture2D(uOverlay, place).r;
}

vec4 fetchOverlayGates(SweepGates gates) {
  vec4 columns = gates.columns;
  vec2 rows = gates.rows;
  return vec4(fetchOverlayGate(vec2(columns.x, rows.x)), fetchOverlayGate(vec2(columns.y, rows.x)), fetchOverlayGate(vec2(columns.z, rows.y)), fetchOverlayGate(vec2(columns.w, rows.y)));
}

/// Data value of the other moment at a place that the volume has been sampled at, by the same weights. False where there is none.
bool sampleOverlay(vec3 p, out float value) {
  GateValues known = valuesOfGates(lastGates, fetchOverlayGates(lastGates.below), fetchOverlayGates(lastGates.above), -3.0e38);
#if OVERLAY_FOLDS
  return blendAtFold(known, uOverlayFoldFrom, value);
#else
  return blend(known, value);
#endif
}
