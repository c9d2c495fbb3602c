/// The values of surfaces, ascending, as shares of the domain; unused slots have a value far from any other.
uniform vec4 uSurfaceValues;

/// The number of surfaces at or below a value.
float countUpTo(float value) {
#if SURFACE_COUNT == 1
  return step(uSurfaceValues.x, value);
#else
  return dot(step(uSurfaceValues, vec4(value)), vec4(1.0));
#endif
}
