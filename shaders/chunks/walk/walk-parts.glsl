/// Walk a ray from one plane of voxel centres to the next, like walk-voxels.glsl, but divide the way between two planes into parts. The
/// gather stage gets each part as a whole (`gatherPart`). The parts have the same ends with skipping and without. Twin: optics/surfaces/jump-gather.ts
void walkRay(Path path, float limit, inout Gathered gathered) {
  PlaneWalk walk = enterPlanes(path.origin, path.forward);
  // The unit of look-ups of cells is an eighth of a voxel along the ray's main axis.
  vec3 perVoxel = abs(walk.perVoxel);
  float unit = 0.125 * min(min(perVoxel.x, perVoxel.y), perVoxel.z);
  CellRay cells = enterCells(path.origin, path.forward * unit);
  float parts = countParts();
  float at = 0.0;
  float to = 0.0;
  // The way between two planes: where it ends, the length of its parts, and how many parts are left.
  float end = 0.0;
  float part = 0.0;
  float left = 0.0;
  Sample front = sampleField(path.origin);
  Sample back = front;
  standAt(at, walk);
  // Code that only few parts need is outside of the inner loop: software GL runs all code of a loop in each iteration.
  for (int i = 0; i < MAX_SAMPLES; i++) {
    for (int k = 0; k < MAX_SAMPLES; k++) {
      at = to;
      front = back;
      if (left < 0.5) {
        Ahead ahead = lookAhead(cells, at / unit, gathered);
        if (ahead.skipped > 0.5) {
          float beyond = at + ahead.skipped * unit;
          if (beyond >= limit) {
            to = limit;
            break;
          }
          standAt(beyond, walk);
          // The way between planes that contains this place begins earlier.
          float begin = max(at, meetBehind(walk));
          if (begin > at) front = sampleField(path.origin + path.forward * begin);
          at = begin;
        }
        end = passNext(limit, walk);
        left = parts / min(1.0, ahead.spacing);
#ifdef BRICKS
        if (longer > 1.0) {
          // Planes of longer voxels, and the wall of the cell in which all are so long.
          end = min(limit, min(meetPlane(path.origin, path.forward, at + 0.1 * unit), at + toWall * unit));
          standAt(end, walk);
          left = parts * samplesPerVoxel;
        }
#endif
        part = (end - at) / left;
      }
      to = left > 1.5 ? at + part : end;
      left -= 1.0;
      back = sampleField(path.origin + path.forward * to);
      gatherPart(path, at, to, front, back, gathered);
      if (isSettled(gathered) || to >= limit) break;
    }
    lookCloser(path, at, to, front, back, gathered);
    if (isOpaque(gathered)) break;
    if (to >= limit) {
      if (limit >= path.total) break;
#ifdef GAP
      // The part that is cut out is between two pieces of the ray.
      to = gap.y;
      left = 0.0;
      limit = path.total;
      back = sampleField(path.origin + path.forward * to);
      standAt(to, walk);
#endif
    }
  }
}
