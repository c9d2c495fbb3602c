/// What a piece of a ray shows in a label's look; look: colour, factor of the extinction. Twin: optics/labels.ts, wear
vec4 wear(vec4 seen, vec4 look) {
  // 1 - seen.a has no digits left for small opacities.
  float depth = seen.a < 1.0e-2 ? seen.a * (1.0 + seen.a * (0.5 + seen.a / 3.0)) : -log(max(1.0 - seen.a, 1.0e-30));
  float thinned = depth * look.a;
  float alpha = thinned < 1.0e-3 ? thinned * (1.0 - 0.5 * thinned) : 1.0 - exp(-thinned);
  return vec4(seen.rgb * look.rgb * (alpha / seen.a), alpha);
}

/// Where looks differ, half of it is of either end. Twin: optics/labels.ts, labelShade
vec4 labelLooksShade(Segment segment, vec4 seen) {
  if (seen.a <= 0.0) return seen;
  vec4 front = segment.front.look;
  vec4 back = segment.back.look;
#if NO_DATA
  if (!hasData(segment.front)) front = back;
  if (!hasData(segment.back)) back = front;
#endif
  if (front == back) return wear(seen, front);
  vec4 first = wear(seen, vec4(front.rgb, 0.5 * front.a));
  return first + (1.0 - first.a) * wear(seen, vec4(back.rgb, 0.5 * back.a));
}
