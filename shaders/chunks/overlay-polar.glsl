#if OVERLAY_FOLDS
/// Velocities more than this apart are on two sides of a fold.
uniform float uOverlayFoldFrom;
#endif

/// Data value of another moment at a place that the volume has been sampled at, by the same weights. False where there is none.
bool sampleOverlay(vec3 p, out float value) {
#if OVERLAY_FOLDS
  return blendAtFold(lastSecond, uOverlayFoldFrom, value);
#else
  return blend(lastSecond, value);
#endif
}
