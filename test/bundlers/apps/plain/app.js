import 'volume-view';
