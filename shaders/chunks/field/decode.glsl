/// Stored value of a texel: 0..1 for 8 bit, 0..65535 for 16 bit (the low byte in the first channel, as in memory, the
/// high byte in the other; whole numbers stay exact), the value itself for floats. It is linear in the texel, so a linear filter may come
/// before it.
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
