/** Styles of the curve of values over time. Colours follow the text of the page. */
export const curveStyles = `
.curve {
  margin-block-start: 0.75em;
  --_curve: var(--volume-readout-curve-color, currentColor);
}
.curve .hint, .curve .read {
  margin: 0;
}
.curve progress {
  inline-size: 6em;
  accent-color: var(--_curve);
}
.plot {
  display: grid;
  grid-template-columns: auto minmax(0, 1fr);
  gap: 4px 6px;
  margin-block: 0.75em 0.5em;
  color: var(--_soft);
  font-size: 12px;
  direction: ltr; /* Time runs from left to right, as in most media players. */
}
.values {
  display: grid;
  justify-items: end;
  block-size: 120px;
}
.values span {
  grid-area: 1 / 1;
  position: relative;
  inset-block-start: calc(100% * (1 - var(--at)));
  block-size: 0;
  line-height: 0;
}
.times {
  grid-column: 2;
  position: relative;
  block-size: 1.4em;
}
.times span {
  position: absolute;
  inset-inline-start: calc(100% * var(--at));
  translate: calc(-100% * var(--at)) 0;
  white-space: nowrap;
}
.area {
  position: relative;
  grid-column: 2;
  grid-row: 1;
  block-size: 120px;
  color: var(--_curve);
  cursor: pointer;
  touch-action: pan-y;
}
.area:focus-visible {
  outline: 2px solid var(--volume-view-focus-color, currentColor);
  outline-offset: 6px;
}
.area svg {
  display: block;
  inline-size: 100%;
  block-size: 100%;
  overflow: visible;
}
.area path {
  fill: none;
  stroke: currentColor;
  stroke-width: 1.5px;
  stroke-linejoin: round;
  stroke-linecap: round;
  vector-effect: non-scaling-stroke;
}
.area .lines {
  stroke: var(--_line);
  stroke-width: 1px;
}
.area .points {
  stroke-width: 4px;
}
.area .now {
  stroke-dasharray: 1 4;
}
.area .current {
  stroke-width: 10px;
}
.area .pointed {
  stroke-width: 8px;
  stroke-opacity: 0.6;
}
.curve summary {
  cursor: pointer;
  min-block-size: 24px;
}
.scroll {
  max-block-size: 14em;
  overflow: auto;
}
.curve table {
  border-collapse: collapse;
}
.curve th, .curve td {
  padding: 0.1em 0.75em 0.1em 0;
  text-align: start;
  font-weight: normal;
}
.curve thead th {
  color: var(--_soft);
}
.curve tr[aria-current] {
  font-weight: 600;
}
@container (max-width: 20rem) {
  .times .between { display: none; }
}
@media (forced-colors: active) {
  .area path { stroke: CanvasText; }
  .area .lines { stroke: GrayText; }
}`;
