import { fieldChunks } from '../../src/renderer/ray/compose-ray.ts';
import type { FieldModule } from '../../src/renderer/ray/ray-module.ts';
import { valueUniforms } from '../../src/renderer/ray/uniforms.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { runChunk } from './gl.ts';
import type { TestGl } from './gl.ts';

/** The value, and whether there is data. */
const both =
  'vec4 sampleBoth(vec3 p) { float value; bool there = sampleVolume(p, value); return vec4(value, there ? 1.0 : 0.0, 0.0, 0.0); }\n';

/** Stored values (0..255, 0..65535, or floats) that a field module returns at points of the unit cube; NaN for no data. */
export function sampleOnGpu(test: TestGl, volume: Volume, field: FieldModule, at: readonly Vector3[]): number[] {
  const { uniforms, units } = field.inputs();
  const got = runChunk(test, {
    defines: field.defines,
    chunks: [...fieldChunks([field]), both],
    result: 'sampleBoth(a.xyz)',
    a: at.map((p) => [...p, 0]),
    uniforms: { ...uniforms, ...valueUniforms({ volume, field, domain: [0, 1] }) },
    units,
  });
  return got.map(([value, there]) => (there > 0.5 ? value * field.storedScale : NaN));
}
