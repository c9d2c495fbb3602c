import { css } from 'lit';

export const styles = css`
  :host {
    --_accent: var(--volume-accent, #3873e0);
    --_soft: color-mix(in srgb, currentColor 72%, transparent);
    --_line: color-mix(in srgb, currentColor 24%, transparent);
    --_field: color-mix(in srgb, currentColor 6%, transparent);

    display: block;
    box-sizing: border-box;
    min-inline-size: 0;
    font: 14px / 1.45 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
  }

  :host([hidden]) {
    display: none;
  }

  .editor {
    display: grid;
    gap: 12px;
  }

  p {
    margin: 0;
  }

  .hint {
    display: grid;
    place-content: center;
    min-block-size: 9rem;
    padding: 1rem;
    border: 1px dashed var(--_line);
    border-radius: 8px;
    color: var(--_soft);
    text-align: center;
  }

  .problem {
    padding: 0.5em 0.75em;
    border-radius: 6px;
    background: #5c1414;
    color: #fff1ee;
  }

  /* The same dark ground as behind a volume, so that colours look as they do there. */
  .plot {
    position: relative;
    box-sizing: border-box;
    block-size: var(--volume-chart-height, 12rem);
    /* Room for the handles at the edges, of the same ground. */
    border: solid transparent;
    border-width: 8px 12px;
    border-radius: 8px 8px 0 0;
    background: var(--volume-chart-background, linear-gradient(#262d3a, #0d1016)) border-box;
    color: #e8ecf2;
  }

  .editable {
    cursor: crosshair;
    touch-action: none;
    user-select: none;
    -webkit-user-select: none;
  }

  .chart,
  .strip {
    display: block;
    inline-size: 100%;
  }

  .chart {
    position: absolute;
    inset: 0;
    block-size: 100%;
    overflow: visible;
  }

  .strip {
    box-sizing: border-box;
    block-size: 16px;
    border: solid transparent;
    border-width: 0 12px 6px;
    border-radius: 0 0 8px 8px;
    background: var(--volume-chart-background, #0d1016) border-box;
  }

  .histogram {
    fill: rgb(232 236 242 / 0.2);
  }

  .grid,
  .curve {
    fill: none;
    vector-effect: non-scaling-stroke;
  }

  .grid {
    stroke: rgb(232 236 242 / 0.13);
  }

  .area {
    opacity: 0.78;
  }

  .curve {
    stroke: #fff;
    stroke-width: 2;
    stroke-linejoin: round;
    filter: drop-shadow(0 0 1.5px #000);
  }

  .opacities,
  .handles {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }

  .opacities span {
    position: absolute;
    inset-inline-start: 6px;
    inset-block-end: calc(100% * var(--y));
    translate: 0 100%;
    color: #d3dae4;
    text-shadow: 0 0 3px #0d1016, 0 0 3px #0d1016;
    font-size: 10px;
    line-height: 1.3;
  }

  .values {
    position: relative;
    block-size: 1.3em;
    margin-inline: 12px;
    margin-block-start: 3px;
    color: var(--_soft);
    font-size: 11px;
  }

  .values span {
    position: absolute;
    inset-inline-start: calc(100% * var(--x));
    translate: calc(-100% * var(--shift)) 0;
    white-space: nowrap;
  }

  .values small {
    margin-inline-start: 0.4em;
    font-size: inherit;
  }

  .handle {
    position: absolute;
    inset-inline-start: calc(100% * var(--x));
    inset-block-end: calc(100% * var(--y));
    box-sizing: border-box;
    inline-size: 16px;
    block-size: 16px;
    translate: -50% 50%;
    border: 2px solid #fff;
    border-radius: 50%;
    outline: none;
    background: var(--color);
    box-shadow: 0 0 0 1px #0d1016, 0 1px 4px rgb(0 0 0 / 0.6);
  }

  .handle[data-chosen] {
    z-index: 1;
    inline-size: 20px;
    block-size: 20px;
    border-width: 3px;
    box-shadow: 0 0 0 1px #0d1016, 0 0 0 3px var(--_accent), 0 1px 5px 3px rgb(0 0 0 / 0.6);
  }

  .handle:focus-visible {
    z-index: 2;
    box-shadow: 0 0 0 2px #0d1016, 0 0 0 5px #7db4ff;
  }

  .fields,
  .factors,
  .buttons,
  .foot {
    display: flex;
    flex-wrap: wrap;
    align-items: end;
    gap: 8px 12px;
  }

  .buttons {
    gap: 6px;
  }

  .foot {
    align-items: center;
    justify-content: space-between;
  }

  label {
    display: grid;
    gap: 3px;
    color: var(--_soft);
    font-size: 12px;
  }

  input,
  button,
  textarea {
    box-sizing: border-box;
    margin: 0;
    color: inherit;
    font: inherit;
  }

  input[type='number'],
  textarea,
  button {
    min-block-size: 32px;
    border: 1px solid var(--_line);
    border-radius: 6px;
    background: var(--_field);
    font-size: 14px;
  }

  input[type='number'] {
    inline-size: 6em;
    padding: 0 6px;
  }

  .fields label,
  .by-hand {
    color: inherit;
  }

  textarea {
    inline-size: 100%;
    padding: 6px;
    font: 12px / 1.5 ui-monospace, monospace;
    resize: vertical;
  }

  button {
    padding: 0 11px;
    cursor: pointer;
  }

  button:hover:enabled {
    border-color: var(--_accent);
  }

  button:disabled {
    opacity: 0.45;
    cursor: default;
  }

  input[type='color'] {
    inline-size: 44px;
    block-size: 32px;
    padding: 0;
    border: 1px solid var(--_line);
    border-radius: 6px;
    background: none;
    cursor: pointer;
  }

  input[type='color']::-webkit-color-swatch-wrapper {
    padding: 0;
  }

  input[type='color']::-webkit-color-swatch,
  input[type='color']::-moz-color-swatch {
    border: 0;
    border-radius: 5px;
  }

  input[type='range'] {
    min-inline-size: 0;
    block-size: 24px;
    accent-color: var(--_accent);
    cursor: pointer;
  }

  :is(input, button, textarea):focus-visible {
    outline: 3px solid #7db4ff;
    outline-offset: 1px;
    box-shadow: 0 0 0 1px #0d1016;
  }

  .factors {
    gap: 6px 24px;
  }

  .factor {
    flex: 1 1 13rem;
    grid-template-columns: auto minmax(0, 1fr) 4em;
    align-items: center;
    gap: 8px;
    color: inherit;
    font-size: 13px;
  }

  output {
    color: var(--_soft);
    font-size: 12px;
    text-align: end;
    white-space: nowrap;
  }

  .bands {
    columns: 16rem;
    column-gap: 24px;
    margin: 0;
    padding: 0;
    list-style: none;
  }

  .bands li {
    display: grid;
    grid-template-columns: 32px 7.2em minmax(0, 1fr) 4.5em;
    align-items: center;
    gap: 8px;
    min-block-size: 30px;
    break-inside: avoid;
    font-size: 13px;
  }

  .bands .range {
    white-space: nowrap;
  }

  .bands input[type='color'] {
    inline-size: 32px;
    block-size: 24px;
  }

  .said {
    min-block-size: 1.45em;
    color: var(--_soft);
    font-size: 12px;
  }

  .hidden {
    position: absolute;
    inline-size: 1px;
    block-size: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }

  @media (forced-colors: active) {
    .handle {
      forced-color-adjust: none;
    }

    .handle:focus-visible {
      outline: 3px solid Highlight;
    }
  }
`;
