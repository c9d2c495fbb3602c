/// Stored value of the layer to share of its transfer function's domain: see uTableDomain.
uniform vec2 uOverlayDomain;

/// The layer's value at a place as a share of its domain, and 1; 0 and 0 where it has none. Twin: optics/overlay.ts, overlayField
Sample overlayField(vec3 p, Sample known) {
  float stored;
  bool valid = sampleOverlay(p, stored);
  known.overlay = vec2(0.0);
  if (valid) known.overlay = vec2((stored - uOverlayDomain.y) * uOverlayDomain.x, 1.0);
  return known;
}
