import { css } from 'lit';

/** Styles of the editor's chart of values and gradients. */
export const planeStyles = css`
  .plane {
    block-size: var(--volume-chart-height, 16rem);
    border-radius: 8px;
  }

  /* Shapes are clipped at the edge; grips may extend over it. */
  .plane .chart {
    overflow: hidden;
  }

  .plane canvas {
    position: absolute;
    inset: 0;
    inline-size: 100%;
    block-size: 100%;
  }

  .opacities .axis {
    inset: 2px 6px auto auto;
    translate: none;
  }

  .patch {
    fill: var(--color);
    fill-opacity: var(--fill);
    stroke: var(--color);
    stroke-opacity: 0.7;
    vector-effect: non-scaling-stroke;
  }

  .patch[data-chosen] {
    stroke: #fff;
    stroke-opacity: 1;
    stroke-width: 1.5;
  }

  .handle.size {
    inline-size: 14px;
    block-size: 14px;
    border-radius: 3px;
  }
`;
