import columnMeans from '../../../../shaders/chunks/classify/column-means.glsl?raw';
import labelFunctions from '../../../../shaders/chunks/classify/label-functions.glsl?raw';
import { maxGroups } from '../../../volume/labels.ts';
import type { RayText } from '../ray-module.ts';
import { columnsText } from './columns.ts';
import { classifyText } from './transfer-function.ts';

/** The maximum number of functions: the volume's own, and those of groups. */
export const room = maxGroups + 1;

const defines = { FUNCTIONS: room.toFixed(1) };

/** Finds each sample's column in the columns of its label's function. */
export function groupColumnsText(bins: boolean): RayText {
  const text = columnsText(bins);
  return { ...text, defines: { ...text.defines, ...defines } };
}

export const labelFunctionsText = classifyText({
  name: 'labelFunctions',
  defines,
  chunks: [columnMeans, labelFunctions],
  samplers: [],
});
