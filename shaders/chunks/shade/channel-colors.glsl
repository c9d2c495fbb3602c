/// The light of both ends over their brightness is the colour of a segment: light adds. Twin: optics/attachments/channel-colors.ts,
/// channelShade
vec4 channelColorsShade(Segment segment, vec4 seen) {
  vec4 light = segment.front.channels + segment.back.channels;
  if (light.a <= 0.0) return seen;
  return vec4(seen.rgb * min(light.rgb / light.a, vec3(1.0)), seen.a);
}
