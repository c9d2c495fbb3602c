/// The four gates of a sweep around a place: their places in the texture, as columns of the radial before and then of the radial
/// after it, and the rows of both radials; weights: 0 if a gate takes no part.
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

/// The stored values of these gates; the weight is 0 if a gate has no data.
struct GateValues {
  vec4 below;
  vec4 above;
  vec4 belowWeights;
  vec4 aboveWeights;
};

/// below, above: the values of their texels; noDataBelow: values below this mean no data.
GateValues valuesOfGates(GatesAround gates, vec4 below, vec4 above, float noDataBelow) {
  return GateValues(below, above, gates.below.weights * step(noDataBelow, below), gates.above.weights * step(noDataBelow, above));
}

/// The weighted mean of the gates. False if none has data. Twin: radar/interpolate-polar.ts, blend
bool blend(GateValues gates, out float value) {
  float weights = dot(gates.belowWeights + gates.aboveWeights, vec4(1.0));
  value = (dot(gates.belowWeights, gates.below) + dot(gates.aboveWeights, gates.above)) / max(weights, 0.5);
  return weights >= 0.5;
}
