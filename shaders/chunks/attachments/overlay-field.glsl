/// From a stored value of the layer to a share of its transfer function's domain: see uTableDomain.
uniform vec2 uOverlayDomain;

/// The layer's value at a place as a share of its domain; far below MIN_OVERLAY if it has none. A separate flag would cost a second
/// member in all samples. Twin: optics/attachments/overlay.ts, overlayField
Sample overlayField(vec3 p, Sample known) {
  float stored;
  bool valid = sampleOverlay(p, stored);
  known.overlay = valid ? max((stored - uOverlayDomain.y) * uOverlayDomain.x, MIN_OVERLAY) : 2.0 * MIN_OVERLAY;
  return known;
}
