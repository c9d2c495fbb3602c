/// The gate with more weight of two (weight and value); with equal weights, the first.
vec2 heavierOf(vec2 one, vec2 other) {
  return other.x > one.x ? other : one;
}

vec2 heaviestOf(vec4 values, vec4 weights) {
  return heavierOf(heavierOf(vec2(weights.x, values.x), vec2(weights.y, values.y)), heavierOf(vec2(weights.z, values.z), vec2(weights.w, values.w)));
}

/// The values of the gates that count, and another value in place of the other gates' values.
vec4 valuesThatCount(vec4 values, vec4 weights, float other) {
  return vec4(weights.x > 0.0 ? values.x : other, weights.y > 0.0 ? values.y : other, weights.z > 0.0 ? values.z : other, weights.w > 0.0 ? values.w : other);
}

float largestOf(vec4 x) {
  return max(max(x.x, x.y), max(x.z, x.w));
}

/// Like `blend`, but across a fold only the gate with the largest weight counts. Twin: radar/interpolate-polar.ts, blend
bool blendAtFold(GateValues gates, float foldFrom, out float value) {
  bool valid = blend(gates, value);
  float heaviest = heavierOf(heaviestOf(gates.below, gates.belowWeights), heaviestOf(gates.above, gates.aboveWeights)).y;
  vec4 below = valuesThatCount(gates.below, gates.belowWeights, heaviest);
  vec4 above = valuesThatCount(gates.above, gates.aboveWeights, heaviest);
  float span = largestOf(max(below, above)) + largestOf(max(-below, -above));
  value = span > foldFrom ? heaviest : value;
  return valid;
}
