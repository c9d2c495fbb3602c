import { projectionKinds } from '../../src/optics/rays/ray-style.ts';
import { polarTapsOf } from '../../src/radar/gpu/polar-taps.ts';
import { polarText } from '../../src/radar/gpu/polar-field-module.ts';
import { slicesText } from '../../src/radar/gpu/slices-module.ts';
import { listSamplers, maxSamplers } from '../../src/renderer/ray/compose-ray.ts';
import type { RayProgram } from '../../src/renderer/ray/compose-ray.ts';
import { ambientText } from '../../src/renderer/ray/modules/ambient.ts';
import { bricksText } from '../../src/renderer/ray/modules/bricks.ts';
import { boxModule } from '../../src/renderer/ray/modules/box.ts';
import { cartesianText, loadCartesianChunks } from '../../src/renderer/ray/modules/cartesian-field.ts';
import { compositeText } from '../../src/renderer/ray/modules/composite.ts';
import { clipText } from '../../src/renderer/ray/modules/clip.ts';
import { cutoutText } from '../../src/renderer/ray/modules/cutout.ts';
import { groupColumnsText, labelFunctionsText } from '../../src/renderer/ray/modules/label-functions-text.ts';
import { labelAppearances } from '../../src/renderer/ray/modules/label-appearances.ts';
import { labelsText } from '../../src/renderer/ray/modules/labels.ts';
import { litText } from '../../src/renderer/ray/modules/lit.ts';
import { pointsModule } from '../../src/renderer/ray/modules/points.ts';
import { cartesianTapsOf } from '../../src/renderer/ray/modules/field-taps.ts';
import { channelColorsModule, channelsText } from '../../src/renderer/ray/modules/channels.ts';
import { overlayAppearanceText, overlayText, secondMomentText } from '../../src/renderer/ray/modules/overlay.ts';
import { patchesText } from '../../src/renderer/ray/modules/patches.ts';
import { weighedText } from '../../src/renderer/ray/modules/weighed-texels.ts';
import { styledText, stylingText } from '../../src/renderer/ray/modules/styled.ts';
import { planesText } from '../../src/renderer/ray/modules/plane-slices.ts';
import { discreteText } from '../../src/renderer/ray/modules/discrete-field.ts';
import { projectionText } from '../../src/renderer/ray/modules/projection.ts';
import { sceneDepthText } from '../../src/renderer/ray/modules/scene-depth.ts';
import { jumpsText } from '../../src/renderer/ray/modules/jumps.ts';
import { surfacesText } from '../../src/renderer/ray/modules/surfaces.ts';
import { columnMeansText, columnsText } from '../../src/renderer/ray/modules/columns.ts';
import { classifyText, transferFunctionText } from '../../src/renderer/ray/modules/transfer-function.ts';
import type { RayText } from '../../src/renderer/ray/ray-module.ts';
import { listRows } from './covering-array.ts';
import type { Row } from './covering-array.ts';

await loadCartesianChunks();

/** A module with its options, or null for no module. */
export type Level = RayText | null;

const bits = [false, true] as const;

/** Volumes whose texels have weights; of a mosaic, also with each voxel fetched. */
function weighed(webgl2: boolean): RayText[] {
  const text = weighedText(cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: false }));
  return webgl2 ? [text] : [text, { ...text, defines: { ...text.defines, FILTER_IN_SHADER: 1 } }];
}

/** How cartesian volumes can be stored: only floats may have missing data, and a filter skips these where texels hold weights. */
const cartesian = (webgl2: boolean): RayText[] => [
  ...bits.flatMap((twoBytes) =>
    bits.map((filterInShader) => cartesianText({ texture3d: webgl2, twoBytes, noData: false, filterInShader })),
  ),
  cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: true }),
  ...weighed(webgl2),
  ...(webgl2
    ? [bricksText({ twoBytes: true, noData: false, filterInShader: false, grouped: true, halved: true })]
    : []),
  ...(webgl2
    ? bits.map((filterInShader) =>
        bricksText({ twoBytes: false, noData: true, filterInShader, grouped: filterInShader, halved: false }),
      )
    : []),
  ...bits.map((noData) => discreteText({ texture3d: webgl2, twoBytes: !noData, noData })),
];

/** Each option has both values, but not in all combinations: folds are independent of the samples' bits and of the radials' elevations. */
const polars = bits.flatMap((twoBytes) =>
  bits.map((radialElevations) =>
    polarText({ twoBytes, radialElevations, folds: twoBytes !== radialElevations, crowds: twoBytes }),
  ),
);

const secondMoments = bits.map(secondMomentText);

/** All modules, by their place in a ray, with their options. Add a line here for a new module. */
export function listLevels(webgl2: boolean): Record<string, readonly Level[]> {
  return {
    box: [boxModule],
    depth: [null, sceneDepthText],
    clip: [null, clipText],
    cutout: [null, cutoutText],
    slices: [null, slicesText],
    planes: [null, ...bits.map(planesText)],
    field: [...cartesian(webgl2), ...polars],
    columns: [null, ...bits.map(columnsText)],
    labels: [
      null,
      ...bits.flatMap((twoBytes) => bits.map((hides) => labelsText({ texture3d: webgl2, twoBytes, hides }))),
    ],
    overlay: [
      null,
      ...bits.map((holes) => overlayText({ texture3d: webgl2, twoBytes: false, filter: true, holes })),
      overlayText({ texture3d: webgl2, twoBytes: true, filter: false, holes: false }),
      ...secondMoments,
    ],
    classify: [transferFunctionText, classifyText(columnMeansText)],
    points: [null, pointsModule],
    shade: [null, labelAppearances],
    overlayAppearance: [
      null,
      ...bits.map((one) => overlayAppearanceText({ color: one, tableFilter: !one, folds: false })),
      overlayAppearanceText({ color: true, tableFilter: true, folds: true }),
    ],
    light: [
      null,
      ...[cartesianTapsOf, polarTapsOf].flatMap((taps) => bits.map((all) => litText({ taps, lights: all, cuts: all }))),
      styledText({ taps: cartesianTapsOf, lights: true, cuts: true }),
      styledText({ taps: polarTapsOf, lights: false, cuts: false }),
    ],
    occlusion: [null, ambientText],
    gather: [
      compositeText,
      ...projectionKinds.flatMap((kind) => bits.map((isExact) => projectionText(kind, { isExact }))),
      ...surfaceTexts,
      ...bits.map(jumpsText),
    ],
  };
}

/** With and without fog, unlit and lit. The rays of the demos include one without fog, on a cartesian grid. */
const surfaceTexts = [
  surfacesText({ isOne: false, fog: true, kinks: true, light: null }),
  surfacesText({ isOne: false, fog: true, kinks: true, light: { taps: cartesianTapsOf, lights: true, cuts: true } }),
  surfacesText({ isOne: true, fog: false, kinks: false, light: { taps: polarTapsOf, lights: false, cuts: false } }),
];

/** Whether a text shades with the taps of this kind of field, and not with those of the other kind. */
const tapsFit = (text: Level, isPolar: boolean): boolean =>
  !text?.chunks.includes((isPolar ? cartesianTapsOf : polarTapsOf).chunk);

/** The options of light, which have to be the same in two texts of a ray. */
const lightOf = (text: Level): string => ['LIT_LIGHTS', 'LIT_CUTS'].map((name) => text?.defines[name]).join();

/** A name that is different for different levels. */
export function nameLevel(level: Level): string {
  return level
    ? [level.name, ...Object.entries(level.defines).map(([name, value]) => `${name}=${value}`)].join(' ')
    : 'none';
}

/** Whether a gather module gathers emission and absorption, not values. */
const shows = (gather: Level | undefined): boolean =>
  gather?.name === 'composite' || gather?.name === 'surfaces' || gather?.name === 'jumps';

/** All possible rays, with and without a layer. */
export function listRays(webgl2: boolean): Row<Level>[] {
  return [...listRaysWithout(webgl2), ...listRaysWithLayer(webgl2)];
}

/**
 * Rays with a second field. It always has both of its modules; projections have none. A second moment occurs only on a radar, and a radar
 * has no other second field. In WebGL 1, rays that have no samplers left for it are left out. Modules that do not affect it have only one
 * level here.
 */
function listRaysWithLayer(webgl2: boolean): Row<Level>[] {
  const { overlay, overlayAppearance, field, labels, light, occlusion } = listLevels(webgl2);
  const fields = [field[0], field[4], field.at(-1)!];
  const some = {
    ...Object.fromEntries(Object.entries(plainRay(webgl2)).map(([name, level]) => [name, [level]])),
    depth: [null, sceneDepthText],
    field: fields,
    overlay: overlay.slice(1),
    overlayAppearance: overlayAppearance.slice(1),
    labels: [null, labels[1]],
    shade: [null, labelAppearances],
    points: [null, pointsModule],
    light: [null, light[1], light.at(-1)!],
    occlusion,
  };
  return listRows<Level>(
    some,
    (row) =>
      (row.overlay?.defines.SECOND_MOMENT === 1) === (row.field?.name === 'polar') &&
      (row.overlay?.defines.OVERLAY_FOLDS ?? 0) === row.overlayAppearance?.defines.OVERLAY_FOLDS &&
      (row.labels !== null) === (row.shade !== null) &&
      !(row.labels && row.field?.name === 'polar') &&
      (row.points !== null) === (row.light !== null) &&
      canBeOccluded(row) &&
      (!row.light || row.light.chunks.includes(polarTapsOf.chunk) === (row.field?.name === 'polar')) &&
      listSamplers({ adaptive: false, modules: Object.values(row).filter((level) => level !== null) }).length <=
        maxSamplers(webgl2),
  );
}

const isCartesian = (field: Level | undefined): boolean => field?.name === 'cartesian' || field?.name === 'bricks';

/** Ambient occlusion needs light, and a cartesian grid. */
const canBeOccluded = ({ occlusion, light, field }: Row<Level>): boolean =>
  !occlusion || (light?.name === 'lit' && isCartesian(field));

/**
 * Rays without a second field. Slices occur only on a radar; planes and labels never do. Columns come with their means. Labels hide values
 * from projections. Light needs `points`, and lights neither projections nor volumes of labels.
 */
function listRaysWithout(webgl2: boolean): Row<Level>[] {
  return listRows<Level>(
    { ...listLevels(webgl2), overlay: [null], overlayAppearance: [null] },
    ({ depth, slices, planes, field, columns, labels, points, classify, shade, light, gather, occlusion }) =>
      canBeOccluded({ occlusion, light, field }) &&
      (webgl2 || !occlusion || !depth || !columns || !labels) &&
      (!slices || field?.name === 'polar') &&
      (!(planes || labels) || field?.name !== 'polar') &&
      (columns !== null) === (classify?.name === 'columnMeans') &&
      (!labels || (labels.defines.LABELS_HIDE === 0) === shows(gather)) &&
      (shade !== null) === (labels?.defines.LABELS_HIDE === 0) &&
      (webgl2 || light?.name !== 'styled' || !depth || !columns || (!labels && field?.name !== 'polar')) &&
      (points !== null) === (light !== null || gather?.name === 'surfaces' || gather?.name === 'jumps') &&
      (!light || (shows(gather) && !field?.defines.NEAREST && tapsFit(light, field?.name === 'polar'))) &&
      (gather?.name !== 'jumps' || (isCartesian(field) && columns !== null)) &&
      (gather?.name !== 'surfaces' ||
        (!field?.defines.NEAREST &&
          tapsFit(gather, field?.name === 'polar') &&
          (!light ||
            (gather.defines.SURFACE_FOG === 1 &&
              (gather.defines.SURFACES_LIT === 0 || lightOf(gather) === lightOf(light)))))),
  );
}

/** The program of a ray, as a layer makes it. @param substeps - whether the samples at a step's ends may cut it */
export function programOf(webgl2: boolean, row: Row<Level>, substeps = false): RayProgram {
  const modules = Object.values(row).filter((level) => level !== null);
  return {
    webgl2,
    adaptive: listSamplers({ adaptive: true, modules }).length <= maxSamplers(webgl2),
    substeps,
    modules,
  };
}

const device = (webgl2: boolean): Row<Level> => ({
  box: boxModule,
  depth: null,
  clip: null,
  cutout: null,
  slices: null,
  planes: null,
  field: cartesianText({ texture3d: webgl2, twoBytes: false, noData: false, filterInShader: false }),
  labels: null,
  columns: null,
  overlay: null,
  points: null,
  classify: transferFunctionText,
  shade: null,
  overlayAppearance: null,
  light: null,
  occlusion: null,
  gather: compositeText,
});

/** The simplest ray. */
export const plainRay = device;

/** Labels in groups: only some rays, because a pair of these with every other module would give too many programs. */
function listGroupRays(webgl2: boolean): Row<Level>[] {
  const groups = (bins: boolean): Row<Level> => ({
    ...plainRay(webgl2),
    labels: labelsText({ texture3d: webgl2, twoBytes: false, hides: false, groups: true }),
    columns: groupColumnsText(bins),
    classify: labelFunctionsText,
    shade: labelAppearances,
  });
  const field = cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: true });
  return [
    { ...groups(true), depth: sceneDepthText, planes: planesText(false) },
    {
      ...groups(false),
      field,
      points: pointsModule,
      light: litText({ taps: cartesianTapsOf, lights: true, cuts: true }),
    },
    { ...groups(true), field: discreteText({ texture3d: webgl2, twoBytes: false, noData: true }) },
  ];
}

/** Transfer functions of value and gradient: light, styles and surfaces share the chunks that compute gradients. */
function listPatchRays(webgl2: boolean): Row<Level>[] {
  const plain: Row<Level> = { ...plainRay(webgl2), points: pointsModule };
  const dim = { taps: cartesianTapsOf, lights: false, cuts: false };
  const bright = { taps: cartesianTapsOf, lights: true, cuts: true };
  const ofRadar = { taps: polarTapsOf, lights: false, cuts: true };
  return [
    { ...plain, classify: patchesText(dim) },
    { ...plain, classify: patchesText(bright), planes: planesText(false), light: styledText(bright) },
    {
      ...plain,
      classify: patchesText(bright),
      field: cartesianText({ texture3d: webgl2, twoBytes: false, noData: true, filterInShader: true }),
      gather: surfacesText({ isOne: false, fog: true, kinks: true, light: bright }),
    },
    {
      ...plain,
      classify: patchesText(ofRadar),
      field: polarText({ twoBytes: true, radialElevations: false, folds: false, crowds: false }),
      light: litText(ofRadar),
    },
  ];
}

/** The rays of the demos: heads, an abdomen and a storm, with shapes and labels; a radar's reflectivity and velocity, with slices. */
export function listDemoRays(webgl2: boolean): Row<Level>[] {
  const plain = plainRay(webgl2);
  const radar = {
    ...plain,
    field: polarText({ twoBytes: false, radialElevations: false, folds: false, crowds: false }),
  };
  const deep = {
    ...plain,
    field: cartesianText({ texture3d: webgl2, twoBytes: true, noData: false, filterInShader: !webgl2 }),
  };
  const lamps = { taps: cartesianTapsOf, lights: true, cuts: false };
  return [
    ...listGroupRays(webgl2),
    ...listPatchRays(webgl2),
    plain,
    deep,
    { ...plain, depth: sceneDepthText },
    { ...plain, clip: clipText },
    { ...plain, cutout: cutoutText },
    { ...plain, planes: planesText(false) },
    { ...plain, labels: labelsText({ texture3d: webgl2, twoBytes: false, hides: false }), shade: labelAppearances },
    radar,
    { ...radar, slices: slicesText },
    {
      ...deep,
      points: pointsModule,
      gather: surfacesText({
        isOne: true,
        fog: false,
        kinks: true,
        light: { taps: cartesianTapsOf, lights: false, cuts: false },
      }),
    },
    { ...deep, points: pointsModule, light: litText({ taps: cartesianTapsOf, lights: false, cuts: false }) },
    {
      ...deep,
      points: pointsModule,
      light: litText({ taps: cartesianTapsOf, lights: false, cuts: true }),
      occlusion: ambientText,
    },
    { ...radar, points: pointsModule, light: litText({ taps: polarTapsOf, lights: false, cuts: false }) },
    { ...plain, points: pointsModule, light: styledText(lamps) },
    {
      ...plain,
      points: pointsModule,
      gather: surfacesText({ isOne: true, fog: false, kinks: true, light: lamps, styling: stylingText(lamps) }),
    },
    { ...plain, channels: channelsText(webgl2), channelColors: channelColorsModule },
    ...bits.map((isExact) => ({ ...plain, gather: projectionText('max', { isLocal: true, isExact }) })),
    {
      ...plain,
      overlay: overlayText({ texture3d: webgl2, twoBytes: false, filter: true, holes: false }),
      overlayAppearance: overlayAppearanceText({ color: false, tableFilter: true, folds: false }),
    },
    {
      ...radar,
      overlay: secondMoments[1],
      overlayAppearance: overlayAppearanceText({ color: true, tableFilter: true, folds: true }),
    },
  ];
}
