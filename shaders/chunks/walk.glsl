/// Step length in bounding diameters.
uniform float uStepLength;

/// Unit-cube direction to world direction in bounding diameters.
uniform mat3 uUnitToDiameters;
