/// The four gates of a sweep around a place: where their texture has them, by columns of the radial before it and then of the one
/// after it, and the rows of both; weights, 0 where a gate takes no part.
struct SweepGates {
  vec4 columns;
  vec2 rows;
  vec4 weights;
};

/// The gates of the sweeps below and above a place.
struct GatesAround {
  SweepGates below;
  SweepGates above;
};

/// What is stored in them, 0 weights where they have no data.
struct GateValues {
  vec4 below;
  vec4 above;
  vec4 belowWeights;
  vec4 aboveWeights;
};

/// below, above: what their texels hold; noDataBelow: of these.
GateValues valuesOfGates(GatesAround gates, vec4 below, vec4 above, float noDataBelow) {
  return GateValues(below, above, gates.below.weights * step(noDataBelow, below), gates.above.weights * step(noDataBelow, above));
}

/// Mean of what gates hold. False where they have no data. Twin: radar/interpolate-polar.ts, blend
bool blend(GateValues gates, out float value) {
  float weights = dot(gates.belowWeights + gates.aboveWeights, vec4(1.0));
  value = (dot(gates.belowWeights, gates.below) + dot(gates.aboveWeights, gates.above)) / max(weights, 0.5);
  return weights >= 0.5;
}
