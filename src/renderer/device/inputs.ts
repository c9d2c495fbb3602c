import type { TextureUnit } from './texture-unit.ts';

export type Uniforms = Readonly<Record<string, number | readonly number[]>>;

/** The uniforms and textures that a program reads. */
export interface ProgramInputs {
  readonly uniforms: Uniforms;
  readonly units: readonly TextureUnit[];
}

/** Merge several inputs. Each sampler is there once, with the first of its textures; of uniforms, the last value counts. */
export function joinInputs(...several: readonly ProgramInputs[]): ProgramInputs {
  const units = new Map<string, TextureUnit>();
  for (const unit of several.flatMap((one) => one.units))
    if (!units.has(unit.samplerName)) units.set(unit.samplerName, unit);
  return {
    uniforms: Object.assign({}, ...several.map(({ uniforms }) => uniforms)) as Uniforms,
    units: [...units.values()],
  };
}
