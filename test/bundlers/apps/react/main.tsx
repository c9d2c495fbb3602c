import { createRoot } from 'react-dom/client';
import { Scan } from './scan';

createRoot(document.getElementById('root')!).render(<Scan />);
