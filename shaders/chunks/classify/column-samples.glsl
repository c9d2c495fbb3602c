/// The emission of a sample's value, and the integral up to this value. The integral starts from the nearer edge of the sample's
/// column, so that the difference of two samples in different columns loses no digits. Twin: optics/transfer/columns.ts, locateShare
Sample columnsField(vec3 p, Sample known) {
#ifdef FUNCTIONS
  whichFunction = known.group;
#endif
  known.place = (known.stored - uColumnDomain.y) * uColumnDomain.x;
  vec3 column = findColumn(known.place);
  vec4 start = fetchColumn(column.x, 0.0);
  vec4 end = fetchColumn(column.x, 1.0);
  float t = (known.place - column.y) / (column.z - column.y);
  bool isNearEnd = t > 0.5;
  float row = isNearEnd ? 4.0 : 2.0;
  float beside = known.place - (isNearEnd ? column.z : column.y);
  known.column = column.x;
  known.emission = start + t * (end - start);
  known.sum = fetchColumn(column.x, row);
  known.sumRest = fetchColumn(column.x, row + 1.0) + 0.5 * beside * (known.emission + (isNearEnd ? end : start));
  return known;
}
