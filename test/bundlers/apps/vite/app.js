import 'bootstrap/dist/css/bootstrap.min.css';
import 'volume-view';
