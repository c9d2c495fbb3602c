import base from './web-test-runner.config.mjs';
import { readdirSync, readFileSync, appendFileSync } from 'node:fs';
import { relative } from 'node:path';
const out = process.env.CPUOUT ?? '/tmp/u/cpu.jsonl';
function cpu() {
  const procs = new Map();
  for (const pid of readdirSync('/proc')) {
    if (!/^\d+$/.test(pid)) continue;
    try {
      const s = readFileSync(`/proc/${pid}/stat`, 'utf8');
      const r = s.slice(s.lastIndexOf(')') + 2).split(' ');
      procs.set(+pid, { ppid: +r[1], t: (+r[11] + +r[12]) / 100, tc: (+r[13] + +r[14]) / 100, pid });
    } catch {}
  }
  const sums = {};
  const isMine = (pid) => { for (let p = pid; p > 1; p = procs.get(p)?.ppid ?? 0) if (p === process.pid) return true; return false; };
  for (const [pid, p] of procs) if (isMine(pid)) {
    let c; try { c = readFileSync(`/proc/${pid}/cmdline`, 'utf8').replaceAll('\0', ' '); } catch { continue; }
    const k = pid === process.pid ? 'wtr' : !c.includes('--type=') ? (c.includes('chrom') ? 'main' : 'node') : c.split('--type=')[1].split(' ')[0];
    sums[k] = (sums[k] ?? 0) + p.t;
    sums[k + ':' + pid] = p.t;
  }
  return sums;
}
const begun = new Map();
const live = {};
const reporter = {
  start({ sessions }) {
    sessions.on('session-status-updated', ({ id, status, testFile }) => {
      if (!begun.has(id)) { begun.set(id, { c: cpu(), t: Date.now() }); }
      if (status === 'FINISHED') {
        const now = cpu(); const b = begun.get(id); const d = {};
        for (const k in now) if (k.includes(':')) { const x = now[k] - (b.c[k] ?? 0); const g = k.split(':')[0]; if (x > 0) d[g] = (d[g] ?? 0) + x; }
        appendFileSync(out, JSON.stringify({ f: relative(process.cwd(), testFile), wall: (Date.now() - b.t) / 1000, ...d }) + '\n');
      }
    });
  },
  stop() { appendFileSync(out, JSON.stringify({ f: 'TOTAL', ...Object.fromEntries(Object.entries(cpu()).filter(([k]) => !k.includes(':'))) }) + '\n'); },
};
export default { ...base, concurrency: +(process.env.CONC ?? 1), reporters: [...base.reporters, reporter] };
