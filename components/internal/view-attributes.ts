import { oldAttributes, readAttribute, removeOldAttributes, renameAttribute } from './deprecated.ts';
import { noticeRoot } from './notice-root.ts';
import { ReflectingElement } from './reflecting-element.ts';

/** How a `<volume-view>` reads and writes its attributes, with their old names. */
export class ViewAttributes extends ReflectingElement {
  static override get observedAttributes(): string[] {
    return [...super.observedAttributes, ...oldAttributes];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    noticeRoot(this);
  }

  override attributeChangedCallback(name: string, old: string | null, value: string | null): void {
    super.attributeChangedCallback(renameAttribute(name), old, value);
  }

  protected override readText(attribute: string): string | null {
    return readAttribute(this, attribute);
  }

  /** The text that describes the present view, where a person may have changed it; by default the text of the attribute. */
  protected readSeen(attribute: 'camera-orbit' | 'camera-target'): string | null {
    return this.readText(attribute);
  }

  protected override writeText(attribute: string, text: string | null): void {
    super.writeText(attribute, text);
    removeOldAttributes(this, attribute);
  }
}
