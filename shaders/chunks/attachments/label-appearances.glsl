#ifdef FUNCTIONS
/// Each half has the transfer function and the appearance of its end's label. A loop, so that the code is there only once for both.
/// Twin: optics/label-groups.ts, groupShade
vec4 seeHalves(Segment segment) {
  vec4 both = vec4(0.0);
  for (int i = 0; i < 2; i++) {
    Sample end = segment.front;
    Sample other = segment.back;
    if (i == 1) end = other;
    if (i == 1) other = segment.front;
    vec4 seen = classifySegment(Segment(end, midway(end, other), segment.begin, 0.5 * segment.span, segment.visible));
    float alpha = opacityOf(end.look.a * depthOf(seen.a));
    both += (1.0 - both.a) * vec4(seen.rgb * end.look.rgb * (alpha / max(seen.a, 1.0e-30)), alpha);
  }
  return both;
}
#endif

/// The front half of a segment has the appearance of the front end's label, and the back half that of the back end's label: colour, and
/// factor of the extinction. If both are the same, the result is that of one segment. Twin: optics/attachments/labels.ts, labelShade
vec4 labelAppearancesShade(Segment segment, vec4 seen) {
#ifdef FUNCTIONS
  if (segment.front.group != segment.back.group && hasData(segment.front) && hasData(segment.back)) return seeHalves(segment);
#endif
  vec4 front = segment.front.look;
  vec4 back = segment.back.look;
#if NO_DATA
  if (!hasData(segment.front)) front = back;
  if (!hasData(segment.back)) back = front;
#endif
  float depth = depthOf(seen.a);
  float first = opacityOf(0.5 * depth * front.a);
  float second = (1.0 - first) * opacityOf(0.5 * depth * back.a);
  vec3 color = seen.rgb / max(seen.a, 1.0e-30);
  return vec4(color * (first * front.rgb + second * back.rgb), first + second);
}
