/// Whether what stands at t of a ray has been cut out; what lies on a cut face has not.
bool isCutOut(float t, float slack) {
#ifdef GAP
  return t > gap.x + slack && t < gap.y - slack;
#else
  return false;
#endif
}
