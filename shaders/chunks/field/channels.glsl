/// Adds the light of the volume's channels at a place: red, green, blue and brightness; p: unit cube.
/// Twin: optics/attachments/channel-colors.ts, channelField
Sample channelsField(vec3 p, Sample known) {
  known.channels = filterChannels(p);
  return known;
}
