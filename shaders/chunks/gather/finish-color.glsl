/// The colour of a ray that gathers colours: what it has gathered.
vec4 finishGathering(Gathered gathered, Path path) {
  return gathered.color;
}
