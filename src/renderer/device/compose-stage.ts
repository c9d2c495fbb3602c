import language100 from '../../../shaders/chunks/walk/language-100.glsl?raw';
import language300 from '../../../shaders/chunks/walk/language-300.glsl?raw';

/** The texts of one shader program. */
export interface ShaderTexts {
  readonly vertex: string;
  readonly fragment: string;
}

export type Defines = Readonly<Record<string, number | string>>;

/** The stage whose text is composed, and the options of that text. */
export interface ComposedStage {
  /** True: GLSL ES 3.00; false: GLSL ES 1.00. */
  readonly webgl2: boolean;
  readonly stage: 'VERTEX_STAGE' | 'FRAGMENT_STAGE';
  readonly defines?: Defines;
}

/** Compose the text of one of a program's two stages: version, defines, language and chunks. */
export function composeStage({ webgl2, stage, defines }: ComposedStage, chunks: readonly string[]): string {
  const all = { [stage]: 1, WEBGL2: Number(webgl2), ...defines };
  return [
    webgl2 ? '#version 300 es\n' : '',
    Object.entries(all)
      .map(([name, value]) => `#define ${name} ${value}\n`)
      .join(''),
    webgl2 ? language300 : language100,
    ...chunks,
  ]
    .join('\n')
    .trimStart();
}
