import { css } from 'lit';

export const styles = css`
  :host {
    --_gap: var(--volume-workspace-gap, 8px);

    container-type: inline-size;
  }

  .workspace {
    display: grid;
    gap: var(--_gap);
  }

  /* A phone: everything in one column. */
  .stage {
    display: grid;
    gap: var(--_gap);
    min-inline-size: 0;
  }

  ::slotted(volume-view) {
    inline-size: 100%;
  }

  .side[hidden] {
    display: none;
  }

  .error {
    margin-block-end: var(--_gap);
  }

  .side {
    display: grid;
    gap: var(--_gap);
    align-content: start;
    min-inline-size: 0;
  }

  .side > *,
  ::slotted([slot='side']) {
    margin-block-start: 0;
  }

  volume-slice-view {
    inline-size: 100%;
  }

  /* A tablet: the panes in a row below the volume. */
  @container (inline-size >= 480px) {
    .stage.two {
      grid-template-columns: repeat(2, minmax(0, 1fr));
    }

    .stage.three {
      grid-template-columns: repeat(3, minmax(0, 1fr));
    }

    .panes ::slotted(volume-view) {
      grid-column: 1 / -1;
    }
  }

  /* A desktop: two by two, no higher than the screen. */
  @container (inline-size >= 720px) {
    .stage.panes {
      grid-template-columns: repeat(2, minmax(0, 1fr));
      grid-auto-rows: minmax(0, 1fr);
      aspect-ratio: 4 / 3;
      max-block-size: 100vh;
      inline-size: 100%;
    }

    .stage.one {
      aspect-ratio: 8 / 3;
    }

    .one ::slotted(volume-view) {
      grid-column: auto;
    }

    .two ::slotted(volume-view) {
      grid-row: 1 / 3;
      grid-column: 1;
    }

    .three ::slotted(volume-view) {
      grid-column: auto;
    }

    .panes ::slotted(volume-view),
    .panes volume-slice-view {
      block-size: 100%;
      min-block-size: 0;
      max-block-size: none;
      aspect-ratio: auto;
    }

    .side {
      grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr));
    }
  }

  /* A wide desktop: the companions are in a column of their own. */
  @container (inline-size >= 1100px) {
    .workspace.sided {
      grid-template-columns: minmax(0, 1fr) 18rem;
      align-items: start;
    }

    .side {
      grid-template-columns: minmax(0, 1fr);
    }
  }
`;
