/// Walk a ray from one plane of voxel centres to the next, independent of the step length. Between two planes a tri-linear value is a cubic
/// function of the length; the gather stage gets each such piece (`gatherPiece`). Pieces have the same ends with skipping and without, except in bricks.
/// Twin: optics/rays/cast-ray.ts, walkKinks
void walkRay(Path path, float limit, inout Gathered gathered) {
  PlaneWalk walk = enterPlanes(path.origin, path.forward);
  // The unit of look-ups of cells is an eighth of a voxel along the ray's main axis.
  vec3 perVoxel = abs(walk.perVoxel);
  float unit = 0.125 * min(min(perVoxel.x, perVoxel.y), perVoxel.z);
  CellRay cells = enterCells(path.origin, path.forward * unit);
  float at = 0.0;
  Sample front = sampleField(path.origin);
  standAt(at, walk);
  for (int i = 0; i < MAX_SAMPLES; i++) {
    Ahead ahead = lookAhead(cells, at / unit, gathered);
    bool isEnd = false;
    if (ahead.skipped > 0.5) {
      float beyond = at + ahead.skipped * unit;
      isEnd = beyond >= limit;
      if (!isEnd) {
        standAt(beyond, walk);
        // The piece that contains this place begins earlier.
        float begin = max(at, meetBehind(walk));
        if (begin > at) front = sampleField(path.origin + path.forward * begin);
        at = begin;
      }
    }
    if (!isEnd) {
#ifdef BRICKS
      // Voxels of bricks differ in their lengths.
      float to = min(limit, meetPlaneOrFace(path.origin, path.forward, at, 0.1 * unit));
#else
      float to = passNext(limit, walk);
#endif
      Sample back = sampleField(path.origin + path.forward * to);
      gatherPiece(path, at, to, front, back, gathered);
      if (isSettled(gathered)) break;
      at = to;
      front = back;
      isEnd = to >= limit;
    }
    if (isEnd) {
#ifdef GAP
      if (limit < path.total) {
        // The part that is cut out is between two pieces of the ray.
        at = gap.y;
        limit = path.total;
        front = sampleField(path.origin + path.forward * at);
        standAt(at, walk);
        continue;
      }
#endif
      break;
    }
  }
}
