/// Surfaces, ascending: shares of the domain, far from any where there are fewer.
uniform vec4 uSurfaceValues;

/// How many surfaces are at a value or below.
float countUpTo(float value) {
#if SURFACE_COUNT == 1
  return step(uSurfaceValues.x, value);
#else
  return dot(step(uSurfaceValues, vec4(value)), vec4(1.0));
#endif
}
