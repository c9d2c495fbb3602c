// Which part of the volume is shown, and a slice through it.
import { html, nothing } from 'lit';
import { boxAround, readRegion, writeRegion } from '../model/box.ts';
import type { Box } from '../model/box.ts';
import { changeView } from '../model/edit.ts';
import { choice, shortNumber, slider } from './fields.ts';
import type { Studio } from './studio.ts';
import { findPicture } from './view-element.ts';

/** Along which axis of the world a slice moves. */
const sliceAxes = { axial: 2, coronal: 1, sagittal: 0 } as const;

type SliceType = 'none' | keyof typeof sliceAxes;

export function renderCut(studio: Studio): unknown {
  const { words, lesson } = studio;
  const volume = findPicture()?.volume;
  if (!volume) return nothing;
  if (volume.sweeps) return html`<h2>${words.cutTitle}</h2><p>${words.cutRadar}</p>`;
  const box = boxAround(volume.dimensions, volume.indexToWorld);
  const region = readRegion(lesson.view.region, box);
  const names = volume.anatomical === false ? words.axes.plain : words.axes.patient;
  const set = (next: Box): void =>
    studio.edit((before) => changeView(before, { region: writeRegion(next, box) }), {
      mark: 'region',
      withCamera: true,
    });
  const end = (axis: number, isHigh: boolean): unknown => {
    const at = axis + (isHigh ? 3 : 0);
    const [min, max] = [box[axis], box[axis + 3]];
    const step = Number(((max - min) / 200).toPrecision(2));
    const least = 2 * step;
    return slider({
      id: `region-${at}`,
      label: isHigh ? words.cutTo : words.cutFrom,
      value: region[at],
      min,
      max,
      step,
      said: shortNumber(region[at]),
      onInput: (value) => {
        const kept = isHigh ? Math.max(value, region[axis] + least) : Math.min(value, region[axis + 3] - least);
        // The last step of a slider may stop short of its end.
        const isEnd = isHigh && max - kept < step;
        set(region.map((x, i) => (i === at ? (isEnd ? max : kept) : x)) as unknown as Box);
      },
    });
  };
  return html`<h2>${words.cutTitle}</h2>
    <p class="hint">${words.cutHint}</p>
    ${[0, 1, 2].map((axis) => html`<fieldset><legend>${names[axis]}</legend>${end(axis, false)}${end(axis, true)}</fieldset>`)}
    <button ?disabled=${lesson.view.region === undefined} @click=${() => studio.edit((before) => changeView(before, { region: null }), { withCamera: true })}>${words.cutAll}</button>
    <h2>${words.sliceTitle}</h2>
    <p class="hint">${words.sliceHint}</p>
    ${renderSlice(studio, box)}`;
}

function renderSlice(studio: Studio, box: Box): unknown {
  const { words, lesson } = studio;
  const [written = 'none', place] = (lesson.view.slice ?? 'none').split(' ');
  const type = (written in sliceAxes ? written : 'none') as SliceType;
  const set = (slice: string | null): void =>
    studio.edit((before) => changeView(before, { slice }), { mark: `slice-${type}`, withCamera: true });
  const middleOf = (one: keyof typeof sliceAxes): number => (box[sliceAxes[one]] + box[sliceAxes[one] + 3]) / 2;
  const axis = type === 'none' ? 0 : sliceAxes[type];
  const at = type === 'none' ? 0 : Number(place ?? middleOf(type));
  return html`${choice({
    id: 'slice-type',
    label: words.sliceTitle,
    value: type,
    options: words.sliceTypes,
    onChange: (value) => set(value === 'none' ? null : `${value} ${shortNumber(middleOf(value))}`),
  })}
  ${
    type === 'none'
      ? nothing
      : slider({
          id: 'slice-place',
          label: words.slicePlace,
          value: at,
          min: box[axis],
          max: box[axis + 3],
          step: Number(((box[axis + 3] - box[axis]) / 200).toPrecision(2)),
          said: shortNumber(at),
          onInput: (value) => set(`${type} ${shortNumber(value)}`),
        })
  }`;
}
