"""Makes an archive of scans ready for <volume-view>: batches of scans, each a run of volume-view-prepare, on a Dask cluster."""

__version__ = "0.1.0"
