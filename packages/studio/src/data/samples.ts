// Volumes of ours to begin with, and whose they are.
import { unzipSync } from 'fflate';
import { loadPart } from './parts.ts';

export interface Sample {
  /** Of its part, and of its words. */
  readonly name: 'brain' | 'torso' | 'storm';
  readonly credits: string;
  readonly licence: string;
}

/** The licence is short where the data have a notice of their own, which the credits name. */
export const samples: readonly Sample[] = [
  {
    name: 'brain',
    credits:
      'MNI152 template (ICBM 2009a nonlinear symmetric), © 1993–2009 Louis Collins, McConnell Brain Imaging Centre, Montreal Neurological Institute, McGill University',
    licence: 'Use, copy, modify and distribute freely, with this notice (MNI)',
  },
  { name: 'torso', credits: 'A synthetic torso, computed by the authors of volume-view', licence: 'MIT' },
  { name: 'storm', credits: 'A synthetic thunderstorm, computed by the authors of volume-view', licence: 'MIT' },
];

/** The files of a sample, as if a person had chosen them. */
export async function loadSample(name: Sample['name']): Promise<File[]> {
  const packed = unzipSync(await loadPart(`sample-${name}`));
  return Object.entries(packed).map(([path, bytes]) => new File([bytes], path));
}
