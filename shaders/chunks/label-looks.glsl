/// The front half of it has the look of the front end, and the back half that of the back end; looks: colour, factor of the extinction.
/// Where they are the same, that is as if it were one. Twin: optics/labels.ts, labelShade
vec4 labelLooksShade(Segment segment, vec4 seen) {
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
