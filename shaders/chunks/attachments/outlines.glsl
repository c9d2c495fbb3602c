/// Edges at which the picture jumps, from xy to zw, in device coordinates; and their number: -1 if there are too many for the array.
uniform vec4 uOutlines[MAX_OUTLINES];
uniform float uOutlineCount;

/// Whether an edge runs between the pixels from which a quad is interpolated. Twin: optics/attachments/plane-outlines.ts, meetsOutline
bool meetsOutlines(QuadPlace place) {
  vec2 reach = 1.25 * place.reach;
  for (int i = 0; i < MAX_OUTLINES; i++) {
    if (float(i) >= uOutlineCount) break;
    vec2 from = uOutlines[i].xy - place.middle;
    vec2 to = uOutlines[i].zw - place.middle;
    bool apart = any(greaterThan(min(from, to), reach)) || any(lessThan(max(from, to), -reach));
    vec2 along = abs(to - from);
    if (!apart && abs(from.x * to.y - from.y * to.x) <= along.x * reach.y + along.y * reach.x) return true;
  }
  return uOutlineCount < 0.0;
}
