import { standIn } from '../../src/viewer/model/view-socket.ts';
import type { ReflectingElement } from '../internal/reflecting-element.ts';
import { SourceAttributes } from '../internal/source-attributes.ts';

/** The names of the properties that attributes hold. */
type PropertyName = Exclude<keyof VolumeViewAttributes, keyof ReflectingElement | 'appearance'>;

/** The attributes that an author writes on `<volume-view>`. A property is null where its attribute is absent or can't be read. */
export class VolumeViewAttributes extends SourceAttributes {
  /** The texts of the attributes, by property; null where absent. The code that uses a text reads it, and reports what is wrong with it. */
  protected get given(): { readonly [Name in PropertyName]: string | null } {
    const { elementProperties } = this.constructor as typeof VolumeViewAttributes;
    const texts: Record<PropertyKey, string | null> = {};
    for (const [name, { attribute }] of elementProperties) {
      if (typeof attribute === 'string') texts[name] = this.readText(attribute) ?? standIn(this, name as string);
    }
    return texts as { [Name in PropertyName]: string | null };
  }
}
