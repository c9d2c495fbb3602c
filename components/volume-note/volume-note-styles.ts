import { css } from 'lit';

export const styles = css`
  :host {
    display: block;
  }

  :host([hidden]) {
    display: none;
  }

  ::slotted(:first-child) {
    margin-block-start: 0;
  }

  ::slotted(:last-child) {
    margin-block-end: 0;
  }

  /* In the page, outside of a view. */
  :host(:is(:state(linked), [data-state-linked])) {
    display: flow-root;
    border-radius: 6px;
  }

  :host(:is(:state(active), [data-state-active])) {
    background: var(--volume-note-highlight, rgb(47 125 225 / 0.16));
    box-shadow: 0 0 0 4px var(--volume-note-highlight, rgb(47 125 225 / 0.16));
  }

  button {
    float: inline-start;
    box-sizing: border-box;
    min-inline-size: 24px;
    block-size: 24px;
    margin: 0;
    margin-inline-end: 8px;
    border: 0;
    padding: 0 6px;
    border-radius: 999px;
    background: var(--volume-note-color, #2f7de1);
    color: #fff;
    font: 600 13px / 1 system-ui, sans-serif;
    font-variant-numeric: tabular-nums;
    cursor: pointer;
  }

  button:focus-visible {
    outline: 3px solid var(--volume-view-focus-color, currentColor);
    outline-offset: 2px;
  }

  @media (forced-colors: active) {
    :host(:is(:state(active), [data-state-active])) {
      outline: 2px solid Highlight;
    }
  }
`;
