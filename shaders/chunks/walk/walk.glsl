/// Step length in bounding diameters.
uniform float uStepLength;

/// The number of steps on a length. Twin: optics/rays/count-steps.ts
float countSteps(float total) {
  return max(1.0, ceil(total / uStepLength - 0.001));
}

/// From a unit-cube direction to a world direction in bounding diameters.
uniform mat3 uUnitToDiameters;
