/// A ray has five stages: where it runs (interval), the values on it (field), what a piece of it shows (classify, shade), and how
/// all pieces add up (gather). Here the ray begins and ends; walk-steps.glsl or walk-substeps.glsl walk it. The modules define the
/// stages, see renderer/ray/. Twin: optics/rays/cast-ray.ts
void main() {
  Ray ray = rayOfPixel();
  Interval interval = enterVolume(ray);
  float lengthPerT = length(uUnitToDiameters * ray.direction);
  float total = (interval.exit - interval.entry) * lengthPerT;
  Path path = Path(ray.point + ray.direction * interval.entry, ray.direction / lengthPerT, total);
  // Where the first piece of the ray ends: a ray has two pieces if a box is cut out of its middle.
  float limit = total;
#ifdef GAP
  limit = endBeforeGap(interval.entry, lengthPerT, path);
#endif
  Gathered gathered = beginGathering();
  if (total > 0.0) walkRay(path, limit, gathered);
  vec4 color = finishGathering(gathered, path);
  FRAGMENT_COLOR = color + (1.0 - color.a) * interval.behind;
}
