import { css } from 'lit';

export const styles = css`
  :host {
    container-type: inline-size;
  }

  .stage {
    position: relative;
    display: grid;
    gap: var(--volume-compare-gap, 8px);
    grid-template-columns: minmax(0, 1fr);
  }

  ::slotted(volume-view) {
    inline-size: 100%;
  }

  .caption {
    grid-area: caption-1;
    margin-block-end: calc(4px - var(--volume-compare-gap, 8px));
    font-weight: 600;
    unicode-bidi: plaintext;
    overflow-wrap: anywhere;
  }

  .caption + .caption {
    grid-area: caption-2;
  }

  .named {
    grid-template-areas: 'caption-1' 'view-1' 'caption-2' 'view-2';
  }

  .named ::slotted(volume-view) {
    grid-area: view-1;
  }

  .named ::slotted(volume-view:nth-of-type(2)) {
    grid-area: view-2;
  }

  @container (inline-size >= 480px) {
    .stage {
      grid-template-columns: repeat(2, minmax(0, 1fr));
    }

    .named {
      grid-template-areas: 'caption-1 caption-2' 'view-1 view-2';
    }
  }

  .stage.slider {
    gap: 0 8px;
    grid-template: 'caption-1 caption-2' 'view view' / minmax(0, 1fr) minmax(0, 1fr);
  }

  .slider .caption {
    margin-block-end: 4px;
  }

  .slider .caption + .caption {
    text-align: end;
  }

  .slider ::slotted(volume-view:nth-of-type(n)) {
    grid-area: view;
  }

  .slider ::slotted(volume-view:nth-of-type(2)) {
    clip-path: var(--_clip);
  }

  .divider {
    position: absolute;
    grid-area: view;
    z-index: 1;
    inset-block: 0;
    inset-inline-start: calc(var(--_at) - 22px);
    inline-size: 44px;
    cursor: ew-resize;
    touch-action: pan-y;
    outline: none;
    user-select: none;
    -webkit-user-select: none;
    /* Only the line and the knob take the pointer: next to them the picture is turned. */
    pointer-events: none;
  }

  .line,
  .knob {
    position: absolute;
    pointer-events: auto;
  }

  .line {
    inset-block: 0;
    inset-inline: 14px;
    background: linear-gradient(var(--volume-compare-color, #fff) 0 0) center / 2px 100% no-repeat;
    filter: drop-shadow(0 0 1px rgb(0 0 0 / 0.9));
  }

  .knob {
    inset-block-start: calc(50% - 22px);
    inset-inline-start: 0;
    inline-size: 44px;
    block-size: 44px;
  }

  .knob svg {
    display: block;
    box-sizing: border-box;
    inline-size: 36px;
    block-size: 36px;
    margin: 4px;
    border-radius: 50%;
    background: var(--volume-compare-color, #fff);
    box-shadow: 0 0 3px rgb(0 0 0 / 0.9);
    fill: none;
    stroke: var(--volume-compare-sign-color, #111);
    stroke-width: 2;
  }

  .divider:focus-visible svg {
    outline: 3px solid var(--volume-view-focus-color, #5ab0ff);
    outline-offset: 2px;
  }

  @media (forced-colors: active) {
    .line {
      background: CanvasText;
      inset-inline: 21px;
    }
  }

  /* On paper both pictures are there. */
  @media print {
    .stage,
    .stage.slider {
      gap: 8px;
      grid-template: none / repeat(2, minmax(0, 1fr));
    }

    .stage.named {
      grid-template-areas: 'caption-1 caption-2' 'view-1 view-2';
    }

    .stage.named .caption {
      margin-block-end: -4px;
      text-align: start;
    }

    .slider:not(.named) ::slotted(volume-view:nth-of-type(n)) {
      grid-area: auto;
    }

    .named ::slotted(volume-view:nth-of-type(n)) {
      grid-area: view-1;
    }

    .named ::slotted(volume-view:nth-of-type(2n)) {
      grid-area: view-2;
    }

    .slider ::slotted(volume-view:nth-of-type(2)) {
      clip-path: none;
    }

    .divider {
      display: none;
    }
  }
`;
