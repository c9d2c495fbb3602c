/// The mean emission between two samples. Twin: optics/transfer/columns.ts, meanOverColumns
vec4 meanOfSamples(Sample from, Sample to) {
  float width = to.place - from.place;
  bool isOneColumn = from.column == to.column;
  vec4 across = ((to.sum - from.sum) + (to.sumRest - from.sumRest)) / (isOneColumn ? 1.0 : width);
  return isOneColumn ? 0.5 * (from.emission + to.emission) : across;
}

vec4 emissionAt(float share) {
#ifdef FUNCTIONS
  whichFunction = 0.0;
#endif
  float place = (share / uTableDomain.x + uTableDomain.y - uColumnDomain.y) * uColumnDomain.x;
  vec3 column = findColumn(place);
  vec4 start = fetchColumn(column.x, 0.0);
  return start + (place - column.y) / (column.z - column.y) * (fetchColumn(column.x, 1.0) - start);
}
