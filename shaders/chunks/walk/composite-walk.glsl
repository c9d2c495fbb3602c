Ahead lookAhead(CellRay cells, float number, Gathered gathered) {
  return lookIntoCell(cells, number);
}

vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.color;
}
