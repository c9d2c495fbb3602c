/// Whether the place at t of a ray has been cut out; a place on a cut face has not.
bool isCutOut(float t, float slack) {
#ifdef GAP
  return t > gap.x + slack && t < gap.y - slack;
#else
  return false;
#endif
}
