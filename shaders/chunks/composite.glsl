/// What a ray has gathered: premultiplied, front to back.
struct Gathered {
  vec4 color;
  Known known;
};

Gathered beginGathering() {
  return Gathered(vec4(0.0), Known(0.0, 1.0));
}

/// Emission and absorption. Twin: optics/ray-gather.ts, composite
void gatherSegment(Segment segment, inout Gathered gathered) {
  segment.visible = 1.0 - gathered.color.a;
  gathered.color += segment.visible * seeSegment(segment);
}

/// Early ray termination: what is left could change the picture by a quarter of 1/255 at most.
bool isSettled(Gathered gathered) {
  return gathered.color.a > 0.999;
}

float chooseSubsteps(Sample front, Sample back, Gathered gathered) {
#ifdef FUNCTIONS
  float wanted = countSubstepsOf(front, back, 1.0 - gathered.color.a);
#else
  float wanted = countSubsteps(hasData(front) ? front.value : back.value, hasData(back) ? back.value : front.value, 1.0 - gathered.color.a);
#endif
  return max(wanted, gathered.known.leastSubsteps);
}
