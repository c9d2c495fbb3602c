import type { TextureUnit } from './texture-unit.ts';

export type Uniforms = Readonly<Record<string, number | readonly number[]>>;

/** What a program reads. */
export interface ProgramInputs {
  readonly uniforms: Uniforms;
  readonly units: readonly TextureUnit[];
}

/** All of several inputs, each sampler once: the first texture that is there for it. */
export function joinInputs(...several: readonly ProgramInputs[]): ProgramInputs {
  const units = new Map<string, TextureUnit>();
  for (const unit of several.flatMap((one) => one.units)) if (!units.has(unit.samplerName)) units.set(unit.samplerName, unit);
  return { uniforms: Object.assign({}, ...several.map(({ uniforms }) => uniforms)) as Uniforms, units: [...units.values()] };
}
