/// Shows a picture of the volume that was drawn before.
uniform sampler2D uGathered;

/// 1 / pixels across and down.
uniform vec2 uGatheredPixel;

void main() {
  FRAGMENT_COLOR = texture2D(uGathered, gl_FragCoord.xy * uGatheredPixel);
}
