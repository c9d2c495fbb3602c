/// The place of a cubic's local maximum, from its values at 0, 1, 2 and 3; -1 if it has none between these. value: the maximum.
/// Twin: optics/rays/cubic.ts
float topOfCubic(vec4 values, out float value) {
  float first = values.y - values.x;
  float second = values.z - 2.0 * values.y + values.x;
  float third = values.w - values.x + 3.0 * (values.y - values.z);
  float linear = first - 0.5 * second + third / 3.0;
  float square = 0.5 * (second - third);
  float inner = square * square - 0.5 * third * linear;
  value = values.x;
  if (inner <= 0.0) return -1.0;
  // Of the two roots of the slope, the one where the slope falls, in the form that loses no digits.
  float root = sqrt(inner);
  float top = square <= 0.0 ? linear / (root - square) : abs(third) > 1.0e-20 ? -2.0 * (square + root) / third : -1.0;
  if (top <= 0.0 || top >= 3.0) return -1.0;
  value = values.x + top * (linear + top * (square + top * third / 6.0));
  return top;
}

/// The two inner Bernstein coefficients of a cubic: it stays between the smallest and the largest of these and of its values at both ends.
vec2 innerBounds(vec4 values) {
  return vec2(dot(values, vec4(-5.0, 18.0, -9.0, 2.0)), dot(values, vec4(2.0, -9.0, 18.0, -5.0))) / 6.0;
}

/// The place of its local minimum.
float bottomOfCubic(vec4 values) {
  float value;
  return topOfCubic(-values, value);
}
