/// Stored value of a texel: 0..1 for 8 bit, 0..65535 for 16 bit (the low byte in the first channel, as in memory, the high one
/// in the other; whole numbers come out as such), the value itself for floats. Linear in the texel, so that it may come after a linear filter.
float decodeTexel(vec4 texel) {
#if TWO_BYTES
#if WEBGL2
  return texel.r * 255.0 + texel.g * 65280.0;
#else
  return texel.r * 255.0 + texel.a * 65280.0;
#endif
#else
  return texel.r;
#endif
}
