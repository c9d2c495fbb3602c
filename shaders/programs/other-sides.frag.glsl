/// The depth at which the rays of pixels end that an edge passes through, on its other side, and which those are; all others end before they begin.
void main() {
  Split split = splitAt(gl_FragCoord.xy);
  FRAGMENT_DEPTH = split.isSplit ? split.other : 0.0;
  FRAGMENT_COLOR = vec4(split.isSplit ? 1.0 : 0.0);
}
