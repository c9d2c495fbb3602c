import { css } from 'lit';

/** Styles of the editor's chart: histogram, curve, handles, scales. */
export const chartStyles = css`
  /* The same dark background as behind a volume, so that colours look the same. */
  .plot {
    position: relative;
    box-sizing: border-box;
    block-size: var(--volume-chart-height, 12rem);
    /* Room for the handles at the edges, with the same background. */
    border: solid transparent;
    border-width: 8px 12px;
    border-radius: 8px 8px 0 0;
    background: var(--volume-chart-background, linear-gradient(#262d3a, #0d1016)) border-box;
    color: #e8ecf2;
  }

  /* Values rise from left to right, in any writing direction of the page. */
  .plot,
  .strip,
  .values {
    direction: ltr;
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

  .offset {
    direction: ltr;
    margin-inline: 12px;
    color: var(--_soft);
    font-size: 11px;
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
    box-shadow: 0 0 0 2px #0d1016, 0 0 0 5px var(--_focus);
  }

  @media (forced-colors: active) {
    .handle {
      forced-color-adjust: none;
    }

    .handle:focus-visible {
      outline: 3px solid Highlight;
    }
  }

  @media (forced-colors: active) {
    .plot,
    .strip {
      outline: 1px solid CanvasText;
      outline-offset: -1px;
    }

    .histogram {
      fill: CanvasText;
      fill-opacity: 0.35;
    }
  }
`;
