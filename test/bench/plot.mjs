// A plot of lines with marks on logarithmic axes as an SVG file: one panel a scene, all with the same axes. It brings its own
// ground, light or dark as the reader's system has it.

/** @typedef {{ x: number, y: number, label: string }} Mark - above zero */
/** @typedef {'square' | 'circle' | 'triangle'} Shape */
/** @typedef {{ shape: Shape, name: string, labels: 'above' | 'below' }} Kind - of a line: its marks, its words in the legend, and where labels stand: right above marks or left below them */
/** @typedef {{ title: string, lines: readonly (readonly Mark[])[] }} Panel - a line for each kind, possibly empty */
/**
 * @typedef {object} Plot
 * @property {string} title
 * @property {string} description - for those who do not see it
 * @property {string} xName
 * @property {string} yName
 * @property {readonly Kind[]} kinds
 * @property {readonly Panel[]} panels
 */

const columns = 2;
const panel = { width: 440, height: 330 };
const margin = { left: 58, right: 20, top: 34, bottom: 46 };
const legendHeight = 44;
const area = { width: panel.width - margin.left - margin.right, height: panel.height - margin.top - margin.bottom };

/** Pixels that are left free between the frame and the outermost marks, for their labels. */
const air = { left: 40, right: 40, top: 18, bottom: 18 };

/** Marks of a line that are closer than this share one label, pixels. */
const together = 7;

const style = `
  svg { font: 12px system-ui, sans-serif; }
  .ground { fill: #fff; } text { fill: #222; } .tick { fill: #555; } .title { font-weight: 600; font-size: 13px; } .label { font-size: 10px; }
  .grid { stroke: #ddd; } .frame { fill: none; stroke: #999; }
  .line { fill: none; stroke-width: 1.6; } .mark { stroke-width: 1.2; }
  .kind0 { --ink: #b3500f; } .kind1 { --ink: #1b63b5; } .kind2 { --ink: #0b7a5b; }
  .line { stroke: var(--ink); } .mark { fill: var(--ink); stroke: #fff; } .label { fill: var(--ink); }
  @media (prefers-color-scheme: dark) {
    .ground { fill: #14171c; } text { fill: #e4e6ea; } .tick { fill: #a8adb6; } .grid { stroke: #2c3139; } .frame { stroke: #6b727d; }
    .kind0 { --ink: #f2a25c; } .kind1 { --ink: #7ab6ff; } .kind2 { --ink: #5fd3ae; } .mark { stroke: #14171c; } .label { fill: var(--ink); }
  }`;

/**
 * @param {Plot} plot
 * @returns {string} the text of an SVG file
 * @throws {RangeError} where there is nothing to show, or a number has no logarithm
 */
export function drawPlot({ title, description, xName, yName, kinds, panels }) {
  const marks = panels.flatMap(({ lines }) => lines.flat());
  const x = makeAxis(
    marks.map((mark) => mark.x),
    { from: margin.left, to: margin.left + area.width, before: air.left, after: air.right },
  );
  const y = makeAxis(
    marks.map((mark) => mark.y),
    { from: margin.top + area.height, to: margin.top, before: air.bottom, after: air.top },
  );
  const width = columns * panel.width;
  const height = legendHeight + Math.ceil(panels.length / columns) * panel.height;
  const drawn = panels.map((one, i) => {
    const place = [(i % columns) * panel.width, legendHeight + Math.floor(i / columns) * panel.height];
    return tag('g', { transform: `translate(${place.join(' ')})` }, [
      drawFrame(one.title, { x, y, xName, yName }),
      ...one.lines.map((line, k) => drawLine(line, `kind${k}`, { ...kinds[k], x, y })),
    ]);
  });
  return `${tag(
    'svg',
    {
      xmlns: 'http://www.w3.org/2000/svg',
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      role: 'img',
      'aria-labelledby': 'title description',
    },
    [
      tag('title', { id: 'title' }, [escape(title)]),
      tag('desc', { id: 'description' }, [escape(description)]),
      tag('style', {}, [style]),
      tag('rect', { class: 'ground', width, height }, []),
      drawLegend(kinds),
      ...drawn,
    ],
  )}\n`;
}

/** @typedef {{ place: (value: number) => number, ticks: { value: number, named: boolean }[] }} Axis */

/**
 * @param {readonly number[]} values
 * @param {{ from: number, to: number, before: number, after: number }} span - pixels; margins before the minimum and after the maximum
 * @returns {Axis}
 */
function makeAxis(values, { from, to, before, after }) {
  const [min, max] = [Math.min(...values), Math.max(...values)];
  if (!(min > 0 && Number.isFinite(max)))
    throw new RangeError(`a logarithmic axis got ${min} to ${max}; expected numbers above zero`);
  const perPixel = Math.max(0.1, Math.log10(max / min)) / (Math.abs(to - from) - before - after);
  const [low, high] = [Math.log10(min) - before * perPixel, Math.log10(max) + after * perPixel];
  const ticks = [];
  for (let decade = Math.floor(low); decade <= high; decade++) {
    for (const step of [1, 2, 5]) {
      const at = Math.log10(step) + decade;
      // One decade after the other would be too far apart to be read where there are few.
      if (at >= low && at <= high)
        ticks.push({ value: Number(`${step}e${decade}`), named: step === 1 || high - low < 2.5 });
    }
  }
  return { place: (value) => from + ((Math.log10(value) - low) / (high - low)) * (to - from), ticks };
}

/**
 * @param {string} title
 * @param {{ x: Axis, y: Axis, xName: string, yName: string }} axes
 */
function drawFrame(title, { x, y, xName, yName }) {
  const { left, top } = margin;
  const [right, bottom] = [left + area.width, top + area.height];
  const middle = top + area.height / 2;
  return tag('g', {}, [
    tag('text', { class: 'title', x: left, y: top - 11 }, [escape(title)]),
    ...x.ticks.flatMap(({ value, named }) => {
      const at = round(x.place(value));
      const line = tag('line', { class: 'grid', x1: at, x2: at, y1: top, y2: bottom }, []);
      return named
        ? [line, tag('text', { class: 'tick', x: at, y: bottom + 16, 'text-anchor': 'middle' }, [nameTick(value)])]
        : [line];
    }),
    ...y.ticks.flatMap(({ value, named }) => {
      const at = round(y.place(value));
      const line = tag('line', { class: 'grid', x1: left, x2: right, y1: at, y2: at }, []);
      return named
        ? [line, tag('text', { class: 'tick', x: left - 6, y: at + 4, 'text-anchor': 'end' }, [nameTick(value)])]
        : [line];
    }),
    tag('rect', { class: 'frame', x: left, y: top, width: area.width, height: area.height }, []),
    tag('text', { x: left + area.width / 2, y: bottom + 34, 'text-anchor': 'middle' }, [escape(xName)]),
    tag('text', { x: 14, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 14 ${middle})` }, [escape(yName)]),
  ]);
}

/**
 * @param {readonly Mark[]} line
 * @param {string} className
 * @param {Kind & { x: Axis, y: Axis }} how
 */
function drawLine(line, className, { shape, labels, x, y }) {
  const marks = line.map(({ x: right, y: up, label }) => ({ at: [round(x.place(right)), round(y.place(up))], label }));
  return tag('g', { class: className }, [
    tag('polyline', { class: 'line', points: marks.map(({ at }) => at.join(',')).join(' ') }, []),
    ...marks.map(({ at }) => drawMark(shape, at[0], at[1])),
    ...joinLabels(marks).map(({ at, label }) =>
      tag(
        'text',
        labels === 'above'
          ? { class: 'label', x: at[0] + 6, y: at[1] - 5 }
          : { class: 'label', x: at[0] - 7, y: at[1] + 12, 'text-anchor': 'end' },
        [escape(label)],
      ),
    ),
  ]);
}

/**
 * Labels that would stand on each other become one.
 * @param {readonly { at: number[], label: string }[]} marks
 */
function joinLabels(marks) {
  /** @type {{ at: number[], label: string }[]} */
  const joined = [];
  for (const { at, label } of marks) {
    const last = joined[joined.length - 1];
    if (last && Math.hypot(at[0] - last.at[0], at[1] - last.at[1]) < together) last.label += `, ${label}`;
    else joined.push({ at, label });
  }
  return joined;
}

/** @param {Shape} shape @param {number} x @param {number} y */
function drawMark(shape, x, y) {
  if (shape === 'circle') return tag('circle', { class: 'mark', cx: x, cy: y, r: 4.5 }, []);
  if (shape === 'square') return tag('rect', { class: 'mark', x: x - 4, y: y - 4, width: 8, height: 8 }, []);
  return tag('path', { class: 'mark', d: `M${x} ${y - 5.5}l5.2 9h-10.4z` }, []);
}

/** @param {readonly Kind[]} kinds */
function drawLegend(kinds) {
  const each = (columns * panel.width - margin.left) / kinds.length;
  return tag(
    'g',
    {},
    kinds.map(({ shape, name }, kind) => {
      const x = margin.left + kind * each;
      return tag('g', { class: `kind${kind}` }, [
        tag('line', { class: 'line', x1: x, x2: x + 28, y1: 26, y2: 26 }, []),
        drawMark(shape, x + 14, 26),
        tag('text', { x: x + 36, y: 30 }, [escape(name)]),
      ]);
    }),
  );
}

/** @param {number} value */
function nameTick(value) {
  return value >= 1000 ? `${value / 1000}k` : String(value);
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 10) / 10;
}

/** @param {string} text */
function escape(text) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {readonly string[]} content - SVG
 */
function tag(name, attributes, content) {
  const written = Object.entries(attributes)
    .map(([key, value]) => ` ${key}="${escape(String(value)).replaceAll('"', '&quot;')}"`)
    .join('');
  return content.length === 0 ? `<${name}${written}/>` : `<${name}${written}>${content.join('\n')}</${name}>`;
}
