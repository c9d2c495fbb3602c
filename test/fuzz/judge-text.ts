import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { readSource } from '../../src/viewer/loading/read-source.ts';
import { sourceNames } from '../../src/viewer/model/given-source.ts';
import { readSettings } from '../../src/viewer/model/settings.ts';
import type { GivenAttributes, Reading } from '../../src/viewer/model/settings.ts';
import { startCounting, stopCounting } from './count-memory.ts';
import type { TextCase } from './fuzz-case.ts';
import { judgeCost, runSafely } from './verdict.ts';
import type { Finding, Verdict } from './verdict.ts';

/** Characters of a text that was pumped up: n, 2n, 4n. */
const lengths = [25_000, 50_000, 100_000];

/** Of four times the text, this many times the time is more than one pass over it, whatever else the machine does. */
const maxGrowth = 10;
/** Milliseconds: below this nothing can be said of growth. */
const minMs = 100;

/** Read an attribute that gets longer and longer. The longest must be quick, and its time must not grow faster than it. */
export async function judgeText(one: TextCase): Promise<Verdict> {
  const times: number[] = [];
  let verdict: Verdict | null = null;
  for (const length of lengths) {
    const count = Math.ceil(length / Math.max(1, one.pump.length));
    verdict = await judgeOne(one.attribute, one.before + one.pump.repeat(count) + one.after);
    times.push(verdict.ms);
    if (verdict.finding) return verdict;
  }
  const growth = times[2] / Math.max(times[0], 1);
  if (times[2] < minMs || growth < maxGrowth) return verdict!;
  const detail = `${times.map((ms) => ms.toFixed(0)).join(', ')} ms for ${lengths.join(', ')} characters`;
  return { ...verdict!, finding: { kind: `growth: ${one.attribute}`, detail } };
}

async function judgeOne(attribute: string, text: string): Promise<Verdict> {
  startCounting();
  const start = process.cpuUsage();
  const { outcome, finding } = await runSafely(() => read(attribute, text));
  const { user, system } = process.cpuUsage(start);
  const { peak, pausedMs } = stopCounting();
  const ms = Math.max(0, (user + system) / 1000 - pausedMs);
  return {
    outcome: outcome === 'volume' ? 'value' : outcome,
    finding: finding ?? judgeCost(ms, peak, text.length),
    ms,
    peak,
    size: text.length,
  };
}

/** Attributes that are read together with all others. */
const settings = [
  'src',
  'time',
  'playSpeed',
  'valueWindow',
  'referenceLength',
  'opacityFactor',
  'lightFactor',
  'look',
  'projection',
  'shading',
  'surfaceValues',
  'gradientOpacity',
  'transferFunction2d',
  'steps',
  'maxError',
  'detail',
  'targetFps',
  'region',
  'rings',
  'cameraOrbit',
  'cameraTarget',
  'fieldOfView',
  'minCameraOrbit',
  'maxCameraOrbit',
  'interpolationDecay',
  'interaction',
  'loading',
] as const;
/** All that can be pumped up. */
export const attributes: readonly string[] = [...settings, ...sourceNames, 'transferFunction', 'color'];

/** A colour stands in a stop of a transfer function alone. */
const stopOf = (color: string): string => `0 ${color} 1`;

const absent = Object.fromEntries(
  [...settings, ...sourceNames, 'stack', 'autoplay', 'transferFunction'].map((name) => [name, null]),
) as unknown as GivenAttributes;

async function read(attribute: string, text: string): Promise<Finding | null> {
  if (attribute === 'color') await resolveTransferFunction(stopOf(text), [0, 100]);
  else if (attribute === 'transferFunction') await resolveTransferFunction(text, [0, 100]);
  else if ((sourceNames as readonly string[]).includes(attribute)) readSource({ ...absent, [attribute]: text });
  else for (const reading of Object.values(readSettings({ ...absent, [attribute]: text }))) throwAgain(reading);
  return null;
}

/** Errors of settings are kept beside them. */
function throwAgain(reading: unknown): void {
  const { error } = (typeof reading === 'object' && reading !== null ? reading : {}) as Partial<Reading<unknown>>;
  if (error) throw error;
}
