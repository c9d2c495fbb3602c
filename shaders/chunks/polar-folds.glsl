/// The heavier of two gates, weight and value; of two as heavy the first.
vec2 heavierOf(vec2 one, vec2 other) {
  return other.x > one.x ? other : one;
}

vec2 heaviestOf(vec4 values, vec4 weights) {
  return heavierOf(heavierOf(vec2(weights.x, values.x), vec2(weights.y, values.y)), heavierOf(vec2(weights.z, values.z), vec2(weights.w, values.w)));
}

/// Least and largest value so far, with one more.
vec2 widen(vec2 range, float value, float weight) {
  return weight > 0.0 ? vec2(min(range.x, value), max(range.y, value)) : range;
}

vec2 widenByAll(vec2 range, vec4 values, vec4 weights) {
  return widen(widen(widen(widen(range, values.x, weights.x), values.y, weights.y), values.z, weights.z), values.w, weights.w);
}

/// As `blend`, but across a fold the gate with the greatest weight stands alone. Twin: radar/interpolate-polar.ts, blend
bool blendAtFold(GateValues gates, float foldFrom, out float value) {
  bool valid = blend(gates, value);
  vec2 range = widenByAll(widenByAll(vec2(3.0e38, -3.0e38), gates.below, gates.belowWeights), gates.above, gates.aboveWeights);
  if (range.y - range.x > foldFrom) value = heavierOf(heaviestOf(gates.below, gates.belowWeights), heaviestOf(gates.above, gates.aboveWeights)).y;
  return valid;
}
