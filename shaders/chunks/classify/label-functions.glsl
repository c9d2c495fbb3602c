/// From a share of the volume's own domain to a share of a group's domain: factor and shift, a column for each group.
uniform mat4 uFunctionShares;

#ifdef SUBSTEPS
/// The number of substeps of a step by a group's transfer function; from, to: shares of the volume's own domain.
float countSubstepsIn(float group, float from, float to, float visible) {
  vec4 map = group < 0.5 ? vec4(1.0, 0.0, 0.0, 0.0) : uFunctionShares * vec4(equal(vec4(group), vec4(1.0, 2.0, 3.0, 4.0)));
  whichFunction = group;
  return countSubsteps(map.x * from + map.y, map.x * to + map.y, visible);
}

/// The same for the groups of both ends; the larger number counts. At least one end has data. Twin: optics/label-groups.ts, groupClassify
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

/// A sample midway between two, with the label of the first one. `columnsField` uses only the value, so its p does not matter.
Sample midway(Sample end, Sample other) {
#if FOLDS
  if (isFolded(end.value, other.value)) return end;
#endif
  end.stored = 0.5 * (end.stored + other.stored);
  end.value = toShare(end.stored);
  return columnsField(vec3(0.0), end);
}
