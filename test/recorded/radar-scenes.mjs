// Scenes of weather radar, as pages write them.
import { inWebGl1 } from './element-scenes.mjs';

const data = '/demos/data';
const fixtures = '/test/fixtures';

const scan = { src: `${data}/storm-radar-1500.json`, 'camera-orbit': '20deg 60deg 80%' };
const winds = {
  src: `${data}/storm-radar-1500-velocity.json`,
  'transfer-function': 'radar-velocity',
  'camera-orbit': '20deg 50deg 80%',
};

const ppi = '<volume-slice type="ppi" elevation="1.3"></volume-slice>';
const sweep = '<volume-slice type="ppi" sweep="4"></volume-slice>';
const cappi = '<volume-slice type="cappi" height="4000"></volume-slice>';
const rhi = '<volume-slice type="rhi" azimuth="70"></volume-slice>';
const section = '<volume-slice type="section" from="-80000 30000" to="70000 -20000"></volume-slice>';
const cuts = { ...scan, 'opacity-factor': '0.1' };

const post = `<transform translation="20000 20000 20000"><shape>
  <appearance><material diffusecolor="orange"></material></appearance><box size="8000 8000 40000"></box>
</shape></transform>`;

/** @type {import('./element-scenes.mjs').ElementScene[]} */
const demo = [
  { name: 'radar', attributes: scan },
  { name: 'radar, no exaggeration', attributes: { ...scan, 'vertical-exaggeration': '1' } },
  { name: 'radar, heights ten times', attributes: { ...scan, 'vertical-exaggeration': '10' } },
  { name: 'radar, straight beams', attributes: { ...scan, 'beam-model': 'straight' } },
  { name: 'radar, rings', attributes: { ...scan, rings: '' } },
  { name: 'radar, rings of 25 km', attributes: { ...scan, rings: '25', 'camera-orbit': '70deg 40deg 90%' } },
  { name: 'radar, region', attributes: { ...scan, region: '-60000 -40000 0 90000 80000 9000', rings: '' } },
  { name: 'radar, from inside', attributes: { ...scan, 'camera-orbit': '100deg 75deg 10%', 'field-of-view': '70deg' } },
  {
    name: 'radar, another palette',
    attributes: {
      ...scan,
      'transfer-function': '10 #2266ff 2%, 30 #2266ff 2%, 30 #ffee33 20%, 45 #ffee33 20%, 45 #ee1122 70%',
    },
  },
  { name: 'radar, the third scan', attributes: { ...scan, src: `${data}/storm-radar.json`, time: '2' } },
  {
    name: 'radar, two files, the second one',
    attributes: { ...scan, src: `${data}/storm-radar-1500.json ${data}/storm-radar-1510.json`, time: '1' },
  },
  { name: 'radar, a shape', attributes: { ...scan, 'opacity-factor': '0.5' }, children: post },
  { name: 'radar, PPI by elevation', attributes: cuts, children: ppi },
  { name: 'radar, PPI by sweep', attributes: cuts, children: sweep },
  { name: 'radar, CAPPI', attributes: cuts, children: cappi },
  { name: 'radar, RHI', attributes: cuts, children: rhi },
  { name: 'radar, section', attributes: { ...cuts, 'camera-orbit': '-30deg 65deg 80%' }, children: section },
  {
    name: 'radar, four slices and nothing else',
    attributes: { ...scan, 'opacity-factor': '0' },
    children: ppi + cappi + rhi + section,
  },
  { name: 'radar, slices, rings and a shape', attributes: { ...cuts, rings: '50' }, children: ppi + rhi + post },
  { name: 'velocity', attributes: winds },
  { name: 'velocity, PPI', attributes: { ...winds, 'opacity-factor': '0.1' }, children: ppi },
  {
    name: 'velocity, the second scan',
    attributes: { ...winds, src: `${data}/storm-radar-velocity.json`, time: '2011-06-20T15:10:00Z' },
  },
];

const noise = '-40 #2040a0 2%, 0 #20c0a0 8%, 40 #ffcc33 20%, 80 #ff2040 50%';
const speeds = '-15 #20e060 20%, 0 gray 2%, 15 #ff4030 20%';

/**
 * Small scans of every format.
 * @type {[file: string, transferFunction: string, attributes?: Record<string, string>][]}
 */
const files = [
  ['radar/odim-2.0.h5', noise],
  ['radar/odim-2.1.h5', speeds, { moment: 'VRADH' }],
  ['radar/odim-2.2.h5', '-30 #20e060 20%, 0 gray 2%, 30 #ff4030 20%', { moment: 'VRADH' }],
  ['radar/odim-2.3.h5', noise],
  ['radar/odim-2.4-scan.h5', '0 #2040a0 5%, 1 #ffcc33 50%', { moment: 'RHOHV' }],
  ['radar/cfradial1-nc4.nc', noise],
  ['radar/cfradial1-ragged.nc', speeds, { moment: 'VEL' }],
  ['radar/cfradial2.nc', noise],
  ['nexrad/message-31.ar2v', noise],
  ['nexrad/message-1.gz', noise],
];

/** @type {import('./element-scenes.mjs').ElementScene[]} */
const small = files.map(([file, transferFunction, attributes], i) => ({
  name: `fixture ${file}`,
  attributes: {
    src: `${fixtures}/${file}`,
    'transfer-function': transferFunction,
    'camera-orbit': `${20 + 10 * i}deg 50deg 80%`,
    'opacity-factor': '2',
    ...attributes,
  },
}));

const scenes = [
  ...demo,
  ...small,
  {
    name: 'fixture radar/odim-2.1.h5, a PPI whose rays have elevations',
    attributes: {
      src: `${fixtures}/radar/odim-2.1.h5`,
      'transfer-function': noise,
      'camera-orbit': '20deg 50deg 80%',
      'opacity-factor': '0.2',
    },
    children: sweep.replace('4', '1'),
  },
];

const repeated = [
  'radar',
  'radar, straight beams',
  'radar, rings',
  'radar, region',
  'radar, from inside',
  'radar, PPI by elevation',
  'radar, four slices and nothing else',
  'radar, slices, rings and a shape',
  'velocity',
  'velocity, PPI',
  'fixture radar/odim-2.1.h5',
  'fixture radar/cfradial1-ragged.nc',
  'fixture nexrad/message-31.ar2v',
];

export const radarScenes = [...scenes, ...inWebGl1(scenes, repeated)];
