/// A ray of five stages: where it runs (interval), what is there (field), what a piece of it shows (classify, shade), and
/// what all of them come to (gather). Here it begins and ends; it is walked in walk-steps.glsl or walk-substeps.glsl. What the
/// stages do their modules say, see renderer/ray/. Twin: optics/cast-ray.ts
void main() {
  Ray ray = rayOfPixel();
  Interval interval = enterVolume(ray);
  float lengthPerT = length(uUnitToDiameters * ray.direction);
  float total = (interval.exit - interval.entry) * lengthPerT;
  Path path = Path(ray.point + ray.direction * interval.entry, ray.direction / lengthPerT, total);
  // Where the first piece of the ray ends: there are two where something is cut out.
  float limit = total;
#ifdef GAP
  limit = endBeforeGap(interval.entry, lengthPerT, path);
#endif
  Gathered gathered = beginGathering();
  if (total > 0.0) walkRay(path, limit, gathered);
  vec4 color = finishGathering(gathered, path);
  FRAGMENT_COLOR = color + (1.0 - color.a) * interval.behind;
}
