/// What makes a share of the volume's own domain one of a group's: factor and shift, a column each.
uniform mat4 uFunctionShares;

#ifdef SUBSTEPS
/// Into how many substeps a group's transfer function cuts a step; from, to: shares of the volume's own domain.
float countSubstepsIn(float group, float from, float to, float visible) {
  vec4 map = group < 0.5 ? vec4(1.0, 0.0, 0.0, 0.0) : uFunctionShares * vec4(equal(vec4(group), vec4(1.0, 2.0, 3.0, 4.0)));
  whichFunction = group;
  return countSubsteps(map.x * from + map.y, map.x * to + map.y, visible);
}

/// The same for the groups of both ends, of which one has data or both: the larger number counts. Twin: optics/label-groups.ts, groupClassify
float countSubstepsOf(Sample from, Sample to, float visible) {
#if NO_DATA
  Sample last = to;
  if (!hasData(to)) to = from;
  if (!hasData(from)) from = last;
#endif
  float count = countSubstepsIn(from.group, from.value, to.value, visible);
  return from.group == to.group ? count : max(count, countSubstepsIn(to.group, from.value, to.value, visible));
}
#endif

/// A place between two, of the label of one of them; p does not matter to what is found out of its value.
Sample midway(Sample end, Sample other) {
#if FOLDS
  if (isFolded(end.value, other.value)) return end;
#endif
  end.stored = 0.5 * (end.stored + other.stored);
  end.value = toShare(end.stored);
  return columnsField(vec3(0.0), end);
}
