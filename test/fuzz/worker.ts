// Runs cases, one after another, in a thread whose heap is limited. What it is asked for, and answers, is in messages.ts.
import { parentPort } from 'node:worker_threads';
import { watchMemory } from './count-memory.ts';
import { coverage } from './coverage.ts';
import { grammars } from './grammars.ts';
import { judge } from './judge.ts';
import type { Answer, Order } from './messages.ts';
import { namedCases } from './named-cases.ts';
import { mutateDraws, Random } from './random.ts';
import type { FuzzCase } from './fuzz-case.ts';
import { installStandIns } from './stand-ins.ts';

/** Draws of cases that reached code which none before them had reached. */
const kept: (readonly number[])[] = [];
/** Every so many cases, it is looked at which code has been reached. */
const lookEvery = 4;

watchMemory();
installStandIns();
parentPort!.on('message', (order: Order) => void run(order));
parentPort!.postMessage({
  type: 'ready',
  formats: Object.keys(grammars),
  named: Object.keys(namedCases),
} satisfies Answer);

async function run(order: Order): Promise<void> {
  const { made, random } = make(order);
  parentPort!.postMessage({ type: 'made', made } satisfies Answer);
  const verdict = await judge(made);
  if (random && order.type === 'draw' && order.index % lookEvery === 0 && (await coverage.grew()))
    kept.push(random.drawn);
  parentPort!.postMessage({ type: 'judged', verdict, kept: kept.length } satisfies Answer);
}

function make(order: Order): { made: FuzzCase; random?: Random } {
  if (order.type === 'given') return { made: order.made };
  if (order.type === 'named') return { made: namedCases[order.name]() };
  if (order.type === 'sound') return { made: grammars[order.format](new Random(order.index, [], true)) };
  const { format, seed, index } = order;
  // Half of the cases change one that was worth keeping.
  const own = Math.imul(seed, 0x9e3779b1) ^ Math.imul(index + 1, 0x85ebca6b);
  const given = index % 2 && kept.length > 0 ? mutateDraws(kept[(own >>> 0) % kept.length], own) : [];
  const random = new Random(own, given);
  return { made: grammars[format](random), random };
}
