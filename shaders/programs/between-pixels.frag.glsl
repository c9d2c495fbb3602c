/// Interpolates all pixels of a picture from every second pixel along each axis.
void main() {
  vec2 pixel = floor(gl_FragCoord.xy);
  vec2 quad = floor(0.5 * pixel);
  FRAGMENT_COLOR = interpolateBetween(lookAround(quad), pixel - 2.0 * quad);
}
