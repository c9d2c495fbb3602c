vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.color;
}
