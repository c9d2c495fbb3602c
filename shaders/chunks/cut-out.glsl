/// Whether what stands at t of a ray has been cut out.
bool isCutOut(float t) {
#ifdef GAP
  return t > gap.x && t < gap.y;
#else
  return false;
#endif
}
