import type { PictureDifference } from './compare-pictures.ts';
import type { StudyMethod } from '../../src/renderer/study.ts';
import { methodNames } from './results.ts';
import type { FunctionResults, SceneResults, StudyResults } from './results.ts';

/** A table as text, for the page, for CSV and for the docs. */
export interface Table {
  readonly id: string;
  readonly title: string;
  readonly columns: readonly string[];
  readonly rows: readonly (readonly (string | number)[])[];
}

const methods: readonly StudyMethod[] = ['printed', 'plain', 'shipped'];

/** Every table of the study. */
export function listTables(results: StudyResults): Table[] {
  return [
    listScenes(results),
    compareAtVoxel(results),
    listErrors(results),
    listTimes(results),
    listResolution(results),
    listBits(results),
  ];
}

function listScenes({ scenes }: StudyResults): Table {
  return {
    id: 'scenes',
    title: 'Volumes and limits: how far it has converged and how exact it is, 1/255',
    columns: [
      'volume',
      'voxels',
      'bits',
      'steps, one per voxel',
      'pixels hit',
      'transfer function',
      'steps of the limit',
      'to half as many: RMSE',
      'P99',
      'to float64, 16 rays: RMSE',
      'worst',
      'paper: O_f',
      'L_f',
    ],
    rows: each(scenes, (scene, { name, limit, paper }) => [
      [
        scene.name,
        scene.dimensions.join(' × '),
        scene.bits,
        scene.voxelSteps,
        `${Math.round(scene.covered * 100)} %`,
        name,
        limit.steps,
        error(limit.half.rms),
        error(limit.half.p99),
        error(limit.reference.rms),
        error(limit.reference.worst),
        digits(paper.opacity),
        digits(paper.light),
      ],
    ]),
  };
}

function compareAtVoxel({ scenes }: StudyResults): Table {
  return {
    id: 'one-step-a-voxel',
    title: 'One sample per voxel: RMSE and 99th percentile, 1/255',
    columns: [
      'volume',
      'transfer function',
      'steps',
      ...methods.flatMap((m) => [`${methodNames[m]}: RMSE`, 'P99']),
      'samples per step',
    ],
    rows: each(scenes, (scene, { name, errors, samplesPerStep }) => [
      [
        scene.name,
        name,
        scene.voxelSteps,
        ...methods.flatMap((method) =>
          both(errors.find((row) => row.method === method && row.steps === scene.voxelSteps)!),
        ),
        samplesPerStep.toFixed(2),
      ],
    ]),
  };
}

function listErrors({ scenes }: StudyResults): Table {
  return {
    id: 'error-against-steps',
    title: 'Error against steps: RMSE and 99th percentile, 1/255',
    columns: ['volume', 'transfer function', 'steps', ...methods.flatMap((m) => [`${methodNames[m]}: RMSE`, 'P99'])],
    rows: each(scenes, (scene, { name, errors }) =>
      errors
        .filter(({ method }) => method === 'shipped')
        .map(({ steps }) => [
          scene.name,
          name,
          steps,
          ...methods.flatMap((method) => both(errors.find((row) => row.method === method && row.steps === steps)!)),
        ]),
    ),
  };
}

function listTimes({ scenes, timeSize, repeats }: StudyResults): Table {
  return {
    id: 'time-against-steps',
    title: `Time against steps, ${timeSize} × ${timeSize} pixels, smooth transfer function: ms, medians of ${repeats}`,
    columns: ['volume', 'voxels along each axis', 'steps', ...methods.map((m) => methodNames[m])],
    rows: scenes.flatMap(({ name, times }) =>
      times
        .filter(({ method }) => method === 'shipped')
        .map(({ percent, steps }) => [
          name,
          `${percent} %`,
          steps,
          ...methods.map((method) => {
            const found = times.find((row) => row.method === method && row.percent === percent && row.steps === steps);
            return found ? milliseconds(found.ms) : '';
          }),
        ]),
    ),
  };
}

function listResolution({ scenes }: StudyResults): Table {
  return {
    id: 'resolution',
    title:
      "Error against resolution (the paper's figure 7): RMSE, 1/255; in brackets against the limit of the coarser grid itself",
    columns: ['volume', 'transfer function', 'voxels along each axis', 'steps', ...methods.map((m) => methodNames[m])],
    rows: each(scenes, (scene, { name, errors, resolution }) => [
      ...(resolution[0]?.rows ?? [])
        .filter(({ method }) => method === 'shipped')
        .map(({ steps }) => [
          scene.name,
          name,
          '100 %',
          steps,
          ...methods.map((method) => error(errors.find((row) => row.method === method && row.steps === steps)!.rms)),
        ]),
      ...resolution.flatMap(({ percent, data, rows }) => [
        ...rows
          .filter(({ method }) => method === 'shipped')
          .map(({ steps }) => [
            scene.name,
            name,
            `${percent} %`,
            steps,
            ...methods.map((method) => {
              const row = rows.find((one) => one.method === method && one.steps === steps)!;
              return `${error(row.full.rms)} (${error(row.own.rms)})`;
            }),
          ]),
        [scene.name, name, `${percent} %`, 'limit', '', '', error(data.rms)],
      ]),
    ]),
  };
}

function listBits({ scenes }: StudyResults): Table {
  return {
    id: 'bits',
    title: '16-bit data in 8 bits over their full range, against the limit of 16 bits: RMSE and 99th percentile, 1/255',
    columns: [
      'volume',
      'transfer function',
      '8 bits, limit: RMSE',
      'P99',
      '8 bits, one sample per voxel: RMSE',
      'P99',
      '16 bits, one sample per voxel: RMSE',
      'P99',
    ],
    rows: each(scenes, (scene, { name, errors, eightBits }) =>
      eightBits
        ? [
            [
              scene.name,
              name,
              ...both(eightBits.limit),
              ...both(eightBits.atVoxel),
              ...both(errors.find((row) => row.method === 'shipped' && row.steps === scene.voxelSteps)!),
            ],
          ]
        : [],
    ),
  };
}

function each(
  scenes: readonly SceneResults[],
  list: (scene: SceneResults, fn: FunctionResults) => (string | number)[][],
): (string | number)[][] {
  return scenes.flatMap((scene) => scene.functions.flatMap((fn) => list(scene, fn)));
}

function both({ rms, p99 }: PictureDifference): [string, string] {
  return [error(rms), error(p99)];
}

/** Two digits behind the point for what can be seen, more for what can't. */
export function error(value: number): string {
  if (value === 0) return '0';
  if (value >= 10) return value.toFixed(1);
  return value >= 0.1 ? value.toFixed(2) : String(Number(value.toPrecision(1)));
}

function milliseconds(value: number): string {
  return value >= 10 ? value.toFixed(0) : value.toFixed(1);
}

function digits(value: number): string {
  return String(Number(value.toPrecision(3)));
}

/** RFC 4180; a cell such as "12.3 (4.5)" stays one cell. */
export function toCsv({ columns, rows }: Table): string {
  const cell = (value: string | number): string => {
    const text = String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [columns, ...rows].map((row) => `${row.map(cell).join(',')}\r\n`).join('');
}

export function toMarkdown({ columns, rows }: Table): string {
  const line = (cells: readonly (string | number)[]): string => `| ${cells.join(' | ')} |`;
  const rule = line(
    columns.map((_, i) => (rows.every((row) => row[i] === '' || /^[\d.]/.test(String(row[i]))) ? '--:' : '---')),
  );
  return [line(columns), rule, ...rows.map(line)].join('\n');
}
