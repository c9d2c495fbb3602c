import { Component, CUSTOM_ELEMENTS_SCHEMA, signal, ViewChild } from '@angular/core';
import type { ElementRef } from '@angular/core';
import type { VolumeInfo, VolumeView } from 'volume-view';
import type { VolumeTour } from 'volume-view/elements/volume-tour.js';
import 'volume-view';

@Component({
  selector: 'app-scan',
  schemas: [CUSTOM_ELEMENTS_SCHEMA],
  template: `
    <volume-view id="scan" src="/volume.nii.gz" alt="A phantom" controls [valueWindow]="window" (load)="loaded($event)">
      <volume-note position="0 0 0">{{ middle() }}</volume-note>
    </volume-view>
    <volume-tour #tour for="scan" duration="0" (step-change)="moved()">
      <volume-step><h2>From the front</h2></volume-step>
      <volume-step camera-orbit="90deg 90deg auto"><h2>From the side</h2></volume-step>
    </volume-tour>
    <output>{{ range() }}</output>
    <p>Step {{ step() }}</p>
  `,
})
export class Scan {
  readonly window: VolumeView['valueWindow'] = [-200, 1200];
  readonly range = signal('');
  readonly middle = signal('The middle');
  readonly step = signal<number | null>(null);
  @ViewChild('tour') tour!: ElementRef<VolumeTour>;

  loaded({ detail }: CustomEvent<VolumeInfo>): void {
    this.range.set(detail.range.join(' to '));
  }

  moved(): void {
    this.step.set(this.tour.nativeElement.step);
  }
}
