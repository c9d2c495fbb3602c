/// For pixels that an edge passes through: writes the depth on the other side of the edge, where a second ray ends, and the colour 1.
/// For all other pixels: the depth 0, so that a second ray ends before it begins.
void main() {
  Split split = splitAt(gl_FragCoord.xy);
  FRAGMENT_DEPTH = split.isSplit ? split.other : 0.0;
  FRAGMENT_COLOR = vec4(split.isSplit ? 1.0 : 0.0);
}
