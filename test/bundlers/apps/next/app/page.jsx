'use client';

import dynamic from 'next/dynamic';

const Scan = dynamic(() => import('./scan'), { ssr: false });

export default function Page() {
  return <Scan />;
}
