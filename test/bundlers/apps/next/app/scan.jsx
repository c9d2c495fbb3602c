'use client';

import { useState } from 'react';
import 'volume-view';

export default function Scan() {
  const [range, setRange] = useState('');
  return (
    <>
      <volume-view
        src="/volume.nii.gz"
        alt="A phantom"
        controls
        valueWindow={[-200, 1200]}
        onload={({ detail }) => setRange(detail.range.join(' to '))}
      />
      <output>{range}</output>
    </>
  );
}
