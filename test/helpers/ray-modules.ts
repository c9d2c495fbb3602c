import { projectionKinds } from '../../src/optics/ray-style.ts';
import { polarTapsOf } from '../../src/radar/gpu/polar-taps.ts';
import { polarText } from '../../src/radar/gpu/polar-field-module.ts';
import { slicesText } from '../../src/radar/gpu/slices-module.ts';
import { listSamplers, maxSamplers } from '../../src/renderer/ray/compose-ray.ts';
import type { RayProgram } from '../../src/renderer/ray/compose-ray.ts';
import { boxModule } from '../../src/renderer/ray/modules/box.ts';
import { cartesianText, loadCartesianChunks } from '../../src/renderer/ray/modules/cartesian-field.ts';
import { compositeText } from '../../src/renderer/ray/modules/composite.ts';
import { clipText } from '../../src/renderer/ray/modules/clip.ts';
import { cutoutText } from '../../src/renderer/ray/modules/cutout.ts';
import { groupColumnsText, labelFunctionsText } from '../../src/renderer/ray/modules/label-functions.ts';
import { labelLooks } from '../../src/renderer/ray/modules/label-looks.ts';
import { labelsText } from '../../src/renderer/ray/modules/labels.ts';
import { cartesianTapsOf, litText, pointsModule } from '../../src/renderer/ray/modules/lit.ts';
import { styledText } from '../../src/renderer/ray/modules/styled.ts';
import { planesText } from '../../src/renderer/ray/modules/plane-slices.ts';
import { discreteText } from '../../src/renderer/ray/modules/discrete-field.ts';
import { projectionText } from '../../src/renderer/ray/modules/projection.ts';
import { sceneDepthText } from '../../src/renderer/ray/modules/scene-depth.ts';
import { columnMeansText, columnsText } from '../../src/renderer/ray/modules/columns.ts';
import { classifyText, transferFunctionText } from '../../src/renderer/ray/modules/transfer-function.ts';
import type { RayText } from '../../src/renderer/ray/ray-module.ts';
import { listRows } from './covering-array.ts';
import type { Row } from './covering-array.ts';

await loadCartesianChunks();

/** A module with its options, or none. */
export type Level = RayText | null;

const bits = [false, true] as const;


/** How cartesian volumes can lie: floats alone may hold no data, and only the shader's own filter knows that. */
const cartesian = (webgl2: boolean): RayText[] => [
  ...bits.flatMap((twoBytes) => bits.map((filterInShader) => cartesianText({ texture3d: webgl2, twoBytes, noData: false, filterInShader }))),
  cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: true }),
  ...bits.map((noData) => discreteText({ texture3d: webgl2, twoBytes: !noData, noData })),
];

/** All modules there are, by where they go, with their options. A new module is a line here. */
export function listLevels(webgl2: boolean): Record<string, readonly Level[]> {
  return {
    box: [boxModule],
    depth: [null, sceneDepthText],
    clip: [null, clipText],
    cutout: [null, cutoutText],
    slices: [null, slicesText],
    planes: [null, ...bits.map(planesText)],
    field: [...cartesian(webgl2), ...bits.flatMap((twoBytes) => bits.map((radialElevations) => polarText({ twoBytes, radialElevations })))],
    columns: [null, ...bits.map(columnsText)],
    labels: [null, ...bits.flatMap((twoBytes) => bits.map((hides) => labelsText({ texture3d: webgl2, twoBytes, hides })))],
    classify: [transferFunctionText, classifyText(columnMeansText)],
    points: [null, pointsModule],
    shade: [null, labelLooks],
    light: [null, ...[cartesianTapsOf, polarTapsOf].flatMap((taps) => bits.map((all) => litText({ taps, lights: all, cuts: all }))), styledText({ taps: cartesianTapsOf, lights: true, cuts: true }), styledText({ taps: polarTapsOf, lights: false, cuts: false })],
    gather: [compositeText, ...projectionKinds.map(projectionText)],
  };
}

/** Tells levels apart. */
export function nameLevel(level: Level): string {
  return level ? [level.name, ...Object.entries(level.defines).map(([name, value]) => `${name}=${value}`)].join(' ') : 'none';
}

/** All rays that can occur: slices are a radar's, planes and labels are not, columns come with their means, labels hide what is projected, and light knows where it is, and shines neither on that nor between labels; styles are left out where WebGL 1 has no sampler left for them. */
export function listRays(webgl2: boolean): Row<Level>[] {
  return listRows(listLevels(webgl2), ({ depth, slices, planes, field, columns, labels, points, classify, shade, light, gather }) =>
    (!slices || field?.name === 'polar') && (!(planes || labels) || field?.name !== 'polar') && (columns !== null) === (classify?.name === 'columnMeans') &&
    (!labels || (labels.defines.LABELS_HIDE === 0) === (gather?.name === 'composite')) && (shade !== null) === (labels?.defines.LABELS_HIDE === 0) &&
    (points !== null) === (light !== null) && (webgl2 || light?.name !== 'styled' || !depth || !columns || (!labels && field?.name !== 'polar')) && (!light || (gather?.name === 'composite' && !field?.defines.NEAREST && light.chunks.includes(polarTapsOf.chunk) === (field?.name === 'polar'))));
}

/** The program of a ray, as a layer makes it. */
export function programOf(webgl2: boolean, row: Row<Level>): RayProgram {
  const modules = Object.values(row).filter((level) => level !== null);
  return { webgl2, adaptive: listSamplers({ adaptive: true, modules }).length <= maxSamplers(webgl2), modules };
}

const device = (webgl2: boolean): Row<Level> => ({
  box: boxModule, depth: null, clip: null, cutout: null, slices: null, planes: null,
  field: cartesianText({ texture3d: webgl2, twoBytes: false, noData: false, filterInShader: false }),
  labels: null, columns: null, points: null, classify: transferFunctionText, shade: null, light: null, gather: compositeText,
});

/** The plainest ray. */
export const plainRay = device;

/** Labels in groups: there are enough programs without each pair of modules with these. */
function listGroupRays(webgl2: boolean): Row<Level>[] {
  const groups = (bins: boolean): Row<Level> => ({
    ...plainRay(webgl2), labels: labelsText({ texture3d: webgl2, twoBytes: false, hides: false, groups: true }), columns: groupColumnsText(bins), classify: labelFunctionsText, shade: labelLooks,
  });
  const field = cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: true });
  return [
    { ...groups(true), depth: sceneDepthText, planes: planesText(false) },
    { ...groups(false), field, points: pointsModule, light: litText({ taps: cartesianTapsOf, lights: true, cuts: true }) },
    { ...groups(true), field: discreteText({ texture3d: webgl2, twoBytes: false, noData: true }) },
  ];
}

/** What the demos show: heads, an abdomen, a storm, with shapes among them, and labels; a radar's reflectivity and velocity, with slices. */
export function listDemoRays(webgl2: boolean): Row<Level>[] {
  const plain = plainRay(webgl2);
  const radar = { ...plain, field: polarText({ twoBytes: false, radialElevations: false }) };
  const deep = { ...plain, field: cartesianText({ texture3d: webgl2, twoBytes: true, noData: false, filterInShader: !webgl2 }) };
  return [...listGroupRays(webgl2), plain, deep, { ...plain, depth: sceneDepthText }, { ...plain, clip: clipText }, { ...plain, cutout: cutoutText }, { ...plain, planes: planesText(false) }, { ...plain, labels: labelsText({ texture3d: webgl2, twoBytes: false, hides: false }), shade: labelLooks }, radar, { ...radar, slices: slicesText },
    { ...deep, points: pointsModule, light: litText({ taps: cartesianTapsOf, lights: false, cuts: false }) }, { ...radar, points: pointsModule, light: litText({ taps: polarTapsOf, lights: false, cuts: false }) },
    { ...plain, points: pointsModule, light: styledText({ taps: cartesianTapsOf, lights: true, cuts: false }) }];
}
