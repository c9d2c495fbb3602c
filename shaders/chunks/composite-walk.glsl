/// Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
bool isSettled(Gathered gathered) {
  return gathered.color.a > 0.999;
}

float countSkippedSteps(CellRay cells, float along, float stepsPerLength, inout Gathered gathered) {
  return countEmptySteps(cells, along, stepsPerLength, gathered.known);
}

vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.color;
}
