/// For each gate: the same value as in uVolume, and the data value of another moment; below -3e38 it has none.
uniform sampler2D uOverlay;

vec4 fetchBoth(SweepGates gates, out vec4 second) {
  vec4 columns = gates.columns;
  vec2 rows = gates.rows;
  vec4 one = texture2D(uOverlay, vec2(columns.x, rows.x));
  vec4 two = texture2D(uOverlay, vec2(columns.y, rows.x));
  vec4 three = texture2D(uOverlay, vec2(columns.z, rows.y));
  vec4 four = texture2D(uOverlay, vec2(columns.w, rows.y));
#if WEBGL2
  second = vec4(one.g, two.g, three.g, four.g);
#else
  second = vec4(one.a, two.a, three.a, four.a);
#endif
  return vec4(one.r, two.r, three.r, four.r);
}

#if OVERLAY_FOLDS
/// Velocities that differ by more than this are on two sides of a fold.
uniform float uOverlayFoldFrom;
#endif

/// Data value of another moment at the last place where the volume was sampled, with the same weights. False if there is none.
bool sampleOverlay(vec3 p, out float value) {
#if OVERLAY_FOLDS
  return blendAtFold(lastSecond, uOverlayFoldFrom, value);
#else
  return blend(lastSecond, value);
#endif
}
