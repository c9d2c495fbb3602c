#ifdef TAPS_IN_LOOP
/// Six taps, in a loop, because each copy of their code takes long to compile. The loop ends at its bottom: if a loop ends at its top,
/// software GL runs it once more for no ray. Twin: optics/rays/gradient.ts, differ
vec3 changePerVoxel(Sample known, vec3 from) {
  vec3 steps = tapSteps(from);
#ifdef BRICKS
  // Changes are those from one of the finest voxels to the next, also where voxels are larger.
  vec3 perTap = voxelScale / FINEST_VOXELS;
#if !FILTER_IN_SHADER
  if (!mayLackData) return changeInAtlas(from) * perTap;
#endif
#endif
  vec3 sums = vec3(0.0);
  vec3 counts = vec3(0.0);
  for (int i = 0; i < 6; i++) {
    float axis = floor(0.5 * float(i) + 0.01);
    float side = float(i) - 2.0 * axis < 0.5 ? -1.0 : 1.0;
    vec3 unit = vec3(equal(vec3(axis), vec3(0.0, 1.0, 2.0)));
    float stored;
    bool counted = tapField(from + side * unit * steps, stored);
    float value = toShare(stored);
#if NO_DATA
    // A place without data has no gradient.
    counted = counted && hasData(known);
#endif
#if FOLDS
    counted = counted && !isFolded(known.value, value);
#endif
    if (counted) {
      sums += side * (value - known.value) * unit;
      counts += unit;
    }
    if (i == 5) break;
  }
#ifdef BRICKS
  sums *= perTap;
#endif
  return sums / max(counts, 1.0);
}
#endif
