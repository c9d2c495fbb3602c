import base from './zz.config.mjs';
export default { ...base, testRunnerHtml: (framework) => `<!doctype html><html><body><script type="module">
import { VolumeScene } from '/src/x3d/scene.ts';
const P = VolumeScene.prototype; const acc = {}; let log = [];
for (const name of ['probe', 'draw', 'readPicture', 'setVolume', 'setOptics', 'setStyle', 'prepare', 'pick', 'drawPiece', 'probePixels']) { const f = P[name]; if (!f) continue; P[name] = function (...a) { const t = performance.now(); const r = f.apply(this, a); const dt = performance.now() - t; const k = name; (acc[k] ??= [0, 0]); acc[k][0]++; acc[k][1] += dt; if (dt > 50 && log.length < 400) log.push(name + ' ' + dt.toFixed(0) + (name === 'probe' ? ' lengths ' + a[0].length + ' ' + JSON.stringify(a[1]) + ' ' + a[0].map((x) => (1/x).toFixed(1)) : '')); return r; }; }
const say = () => { if (log.length || Object.keys(acc).length) { console.log('INST ' + Object.entries(acc).map(([k, [n, t]]) => k + ' ' + n + 'x ' + t.toFixed(0) + ' ms').join('; ') + '\\n    ' + log.join('\\n    ')); log = []; for (const k in acc) delete acc[k]; } };
let tries = 0; const hook = () => { if (window.afterEach) { window.afterEach(say); } else if (tries++ < 3000) setTimeout(hook, 0); }; hook();
</script><script type="module" src="${framework}"></script></body></html>`,
  reporters: [...base.reporters, { onTestRunFinished({ sessions }) { for (const s of sessions) { const walk = (x, p) => { if (!x) return; for (const t of x.tests) console.log(`T ${((t.duration ?? 0) / 1000).toFixed(2).padStart(7)} ${s.testFile.split('/').pop()} ${p} > ${t.name}`); for (const y of x.suites) walk(y, p + ' > ' + y.name); }; walk(s.testResults, ''); } } }] };
