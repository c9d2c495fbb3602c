float countSkippedSteps(CellRay cells, float along, float stepsPerLength, inout Gathered gathered) {
  return countEmptySteps(cells, along, stepsPerLength, gathered.known);
}

vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.color;
}
