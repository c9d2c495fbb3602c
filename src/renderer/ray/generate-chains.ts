import type { RayText } from './ray-module.ts';

/** GLSL of struct `Sample`: all that field modules find out about a place. If all places have data (NO_DATA 0), it has no `valid`. */
export function sampleStruct(fields: readonly RayText[]): string {
  const members = ['float value', ...fields.flatMap((field) => field.members ?? [])];
  return `struct Sample {
${members.map((member) => `  ${member};\n`).join('')}#if NO_DATA
  bool valid;
#endif
};

bool hasData(Sample known) {
#if NO_DATA
  return known.valid;
#else
  return true;
#endif
}
`;
}

/**
 * GLSL of `sampleField`: the value at a point of the unit cube, as a share of the transfer function's domain, and what other field
 * modules find out about the point. A module that adds `float stored` gets the stored value.
 */
export function fieldChain(fields: readonly RayText[]): string {
  const more = fields.filter(({ members }) => members);
  return `Sample sampleField(vec3 p) {
  Sample known;
  float value;
#if NO_DATA
  known.valid = sampleVolume(p, value);
#else
  sampleVolume(p, value);
#endif
  known.value = toShare(value);
${more.some(({ members }) => members!.includes('float stored')) ? '  known.stored = value;\n' : ''}${more.map(({ name }) => `  known = ${name}Field(p, known);\n`).join('')}  return known;
}
`;
}

/** GLSL of `enterVolume`: where a ray runs, after all interval modules. */
export function intervalChain(intervals: readonly RayText[]): string {
  return `Interval enterVolume(Ray ray) {
  Interval interval = Interval(uEyeT, 1.0e30, vec4(0.0));
${intervals.map(({ name }) => `  interval = ${name}Interval(ray, interval);\n`).join('')}  return interval;
}
`;
}

/** GLSL of `seeSegment`: what a piece of a ray shows, after all shade modules. */
export function shadeChain(shades: readonly RayText[]): string {
  return `vec4 seeSegment(Segment segment) {
  vec4 seen = classifySegment(segment);
${shades.map(({ name }) => `  seen = ${name}Shade(segment, seen);\n`).join('')}  return seen;
}
`;
}
