/// Adds its place to a sample: the shading of a piece of a ray needs the places of its ends. Twin: optics/rays/lit.ts, pointField
Sample pointsField(vec3 p, Sample known) {
  known.point = p;
  return known;
}
