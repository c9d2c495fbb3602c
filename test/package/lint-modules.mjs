// A rule that cannot fail is no rule: files that break the architecture's order are linted in a copy, and must be refused.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, realpathSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { projectRoot } from '../../scripts/shared-data.mjs';
import { check, finish } from './checks.mjs';

const copy = realpathSync(mkdtempSync(join(tmpdir(), 'volume-view-lint-')));
for (const name of ['.oxlintrc.json', 'tsconfig.json', 'package.json', 'scripts', 'types']) {
  cpSync(join(projectRoot, name), join(copy, name), { recursive: true });
}
symlinkSync(join(projectRoot, 'node_modules'), join(copy, 'node_modules'), 'junction');

// Put together here, so that a search for such marks in the checkout does not find this file.
const MARKER = ['TO', 'DO'].join('');
const FOCUS = 'only';

const many = (/** @type {number} */ count) =>
  Array.from({ length: count }, (_, i) => `export { a${i} } from './b${i}.ts';`).join('\n');

/** @type {[path: string, text: string, message: RegExp][]} */
const refused = [
  ['src/viewer/frames/a.ts', many(21), /imports from 21 files; at most 20 are allowed/],
  ['src/volume/a.ts', `export { x } from '../optics/b.ts';`, /volume may not import from optics/],
  ['src/optics/a.ts', `export type { X } from '../x3d/b.ts';`, /optics may not import from x3d/],
  ['src/formats/a.ts', `export * from '../renderer/b.ts';`, /formats may not import from renderer/],
  ['src/quality/a.ts', `export const load = () => import('../formats/b.ts');`, /quality may not import from formats/],
  ['src/renderer/a.ts', `export type X = import('../x3d/b.ts').X;`, /renderer may not import from x3d/],
  ['src/renderer/a.ts', `const x = await import('../radar/gpu/b.ts');`, /renderer may not import from radar\/gpu/],
  ['src/formats/a.ts', `const x = await import('#rare/worker/b.ts');`, /formats may not import from worker/],
  [
    'src/formats/base/a.ts',
    `const x = await import('#rare/formats/b.ts');`,
    /formats\/base may not import from formats\/\./,
  ],
  ['src/radar/a.ts', `export * from './gpu/b.ts';`, /radar may not import from radar\/gpu/],
  ['src/x3d/a.ts', `export * from '../viewer/b.ts';`, /x3d may not import from viewer/],
  ['src/x3d/nodes/a.ts', `export * from '../../viewer/cuts/b.ts';`, /x3d\/nodes may not import from viewer/],
  [
    'src/optics/transfer/a.ts',
    `export * from '../rays/b.ts';`,
    /optics\/transfer may not import from optics\/rays; it may from: nowhere/,
  ],
  ['src/viewer/cuts/a.ts', `export type { B } from '../view/b.ts';`, /viewer\/cuts may not import from viewer\/view/],
  [
    'src/viewer/cuts/a.ts',
    `export const load = () => import('../session/b.ts');`,
    /viewer\/cuts may not import from viewer\/session/,
  ],
  ['src/viewer/other/a.ts', `export * from '../model/b.ts';`, /viewer\/other is not among the folders of viewer/],
  [
    'components/volume-clip/a.ts',
    `export * from '../volume-view/b.ts';`,
    /volume-clip may not import from components\/volume-view/,
  ],
  ['src/x3d/a.ts', `export * from '../../components/b.ts';`, /x3d may not import from components/],
  ['src/x3d/a.ts', `export * from '../sources/b.ts';`, /x3d may not import from sources/],
  ['src/viewer/a.ts', `export * from '../x3d/b.ts';`, /viewer may not import from x3d/],
  ['src/viewer/a.ts', `export type X = import('../../components/b.ts').X;`, /viewer may not import from components/],
  ['src/viewer/a.ts', `export * from '../editor/b.ts';`, /viewer may not import from editor/],
  ['components/a.ts', `export * from '../demos/b.ts';`, /components may not import from demos/],
  ['components/a.ts', `export { default } from '../shaders/b.glsl?raw';`, /components may not import from shaders/],
  ['src/x3d/a.ts', `export { html } from 'lit';`, /only components and packages may import lit/],
  ['components/a.ts', `export * from 'x3dom';`, /only x3d may import x3dom/],
  ['src/editor/a.ts', `export * from '../viewer/b.ts';`, /editor may not import from viewer/],
  ['src/messages/a.ts', `export * from '../optics/b.ts';`, /messages may not import from optics/],
  ['components/a.ts', `export { update } from '@shoelace-style/localize';`, /only messages may import/],
  [
    'components/a.ts',
    "import { html } from 'lit';\nexport const a = (b: string) => html`<p>${b}, metres</p>`;",
    /a template says "metres"/,
  ],
  [
    'components/a.ts',
    'import { html } from \'lit\';\nexport const a = () => html`<i title="Größe"></i>`;',
    /a template says "Größe"/,
  ],
  ['src/volume/a.ts', `export const width = (): number => document.body.clientWidth;`, /document/],
  ['src/index.ts', `export const answer = 42;`, /re-exports only/],
  ['src/x3d/a.ts', `// ${MARKER}: later\nexport const a = 1;`, /unfinished/],
  [
    'src/viewer/view/a.ts',
    `export const a = (view: { b: number }): unknown => (view as unknown as Record<string, unknown>)._presenter;`,
    /_presenter is private to its object/,
  ],
  [
    'src/viewer/view/a.ts',
    `export class A {\n  private _b = 1;\n  isSame(other: A): boolean {\n    return other._b === this._b;\n  }\n}`,
    /_b is private to its object/,
  ],
  [
    'components/volume-clip/a.ts',
    `export const a = (view: Element): unknown => 'x' in view && (view as { x?: { y?: unknown } } & Record<string, unknown>)?._clips;`,
    /_clips is private/,
  ],
  [
    'components/volume-clip/a.ts',
    `export function a({ _volume: b }: Record<string, unknown>): unknown {\n  return b;\n}`,
    /_volume is private/,
  ],
  ['src/x3d/nodes/a.ts', `export interface A {\n  readonly _atlas?: string;\n}`, /_atlas is private/],
  ['components/volume-clip/a.ts', `export interface A {\n  _inPane(): void;\n}`, /_inPane is private/],
  ['test/browser/a.test.ts', `it.${FOCUS}('a', () => {});`, /focused or skipped/],
];
/** @type {[path: string, text: string][]} */
const accepted = [
  ['src/viewer/frames/a.ts', many(20)],
  ['src/viewer/view/viewer.ts', many(21)],
  ['src/optics/a.ts', `export { x } from '../volume/b.ts';\nexport { e } from '../core/errors.ts';`],
  ['src/renderer/a.ts', `export { default } from '../../shaders/b.glsl?raw';`],
  ['src/radar/gpu/a.ts', `export { x } from '../b.ts';\nexport { y } from '../../renderer/c.ts';`],
  ['components/a.ts', `export { html } from 'lit';\nexport const load = () => import('../src/x3d/b.ts');`],
  [
    'components/a.ts',
    'import { html } from \'lit\';\nexport const a = (b: string) => html`<p part="hint" title=${b}>${b} · 5 &gt; 4</p>`;',
  ],
  ['src/x3d/nodes/a.ts', `export type { B } from '../../viewer/model/b.ts';`],
  ['src/viewer/cuts/a.ts', `export type { B } from '../model/b.ts';`],
  [
    'components/volume-clip/a.ts',
    `export type { B } from '../volume-view/b.ts';\nexport { c } from '../internal/c.ts';`,
  ],
  ['src/x3d/a.ts', `export const a = (node: { _vf: unknown }): unknown => node._vf;`],
  [
    'components/volume-clip/a.ts',
    `export class A {\n  private _b = 1;\n  get b(): number {\n    return this._b;\n  }\n}`,
  ],
  ['components/volume-clip/a.ts', `export const a = ({ b: _b, ...rest }: Record<string, unknown>): unknown => rest;`],
  ['src/index.ts', `export { VolumeView } from '../components/volume-view/volume-view.ts';`],
];
/**
 * Lint files, each by itself but all in one run of the linter: each gets a name of its own, but for `src/index.ts`, which rules name.
 * @param {readonly (readonly [path: string, text: string])[]} files
 * @returns {string[]} what the linter says of each; empty where it finds nothing
 */
function lint(files) {
  const paths = files.map(([path], i) => (path === 'src/index.ts' ? path : path.replace(/\/a\./, `/a${i}.`)));
  assert.equal(new Set(paths).size, files.length, 'each file has a name of its own');
  paths.forEach((path, i) => {
    mkdirSync(dirname(join(copy, path)), { recursive: true });
    writeFileSync(join(copy, path), files[i][1]);
  });
  const oxlint = join(projectRoot, 'node_modules/oxlint/bin/oxlint');
  const { status, stdout } = spawnSync(process.execPath, [oxlint, '--deny-warnings', '--format', 'json', ...paths], {
    cwd: copy,
    encoding: 'utf8',
  });
  const { diagnostics, number_of_files: linted } = JSON.parse(stdout);
  assert.equal(linted, files.length, 'all files are linted');
  assert.equal(status, diagnostics.length > 0 ? 1 : 0);
  for (const path of paths) rmSync(join(copy, path));
  return paths.map((path) =>
    diagnostics
      .filter((/** @type {{ filename: string }} */ { filename }) => filename === path)
      .map((/** @type {{ message: string }} */ { message }) => message)
      .join('\n'),
  );
}

const ofRefused = lint(refused.map(([path, text]) => [path, text]));
for (const [i, [path, text, message]] of refused.entries()) {
  await check(`lint refuses in ${path}: ${JSON.stringify(text)}`, () => assert.match(ofRefused[i], message));
}
const ofAccepted = lint(accepted);
for (const [i, [path, text]] of accepted.entries()) {
  await check(`lint accepts in ${path}: ${JSON.stringify(text)}`, () => assert.equal(ofAccepted[i], ''));
}

rmSync(copy, { recursive: true });
finish();
