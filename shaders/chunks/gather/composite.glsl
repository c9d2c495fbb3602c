/// The colour that a ray has gathered, front to back: premultiplied.
struct Gathered {
  vec4 color;
};

Gathered beginGathering() {
  return Gathered(vec4(0.0));
}

/// Emission and absorption. Twin: optics/rays/ray-gather.ts, composite
void gatherSegment(Segment segment, inout Gathered gathered) {
  segment.visible = 1.0 - gathered.color.a;
  gathered.color += segment.visible * seeSegment(segment);
}

/// Early ray termination: the rest of the ray could change the picture by a quarter of 1/255 at most.
bool isSettled(Gathered gathered) {
  return gathered.color.a > 0.999;
}

#ifdef SUBSTEPS
float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
#ifdef FUNCTIONS
  return countSubstepsOf(front, back, 1.0 - gathered.color.a);
#else
  return countSubsteps(hasData(front) ? front.value : back.value, hasData(back) ? back.value : front.value, 1.0 - gathered.color.a);
#endif
}
#endif
