"""Where tasks run: processes of this machine, jobs of Slurm, or a Dask cluster that is there already."""
from contextlib import contextmanager


@contextmanager
def open_cluster(name, workers, slurm):
    """A client of Dask. name: `local`, `slurm` or an address. slurm: options of SLURMCluster, a dict."""
    # Here, because it takes a second, and a wrong argument should not.
    from distributed import Client, LocalCluster

    if name == "local":
        with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            yield client
    elif name == "slurm":
        try:
            from dask_jobqueue import SLURMCluster
        except ImportError:
            raise SystemExit("got --cluster slurm; expected the package dask-jobqueue: pip install volume-view-archive[slurm]") from None
        with SLURMCluster(cores=1, processes=1, **slurm) as cluster, Client(cluster) as client:
            cluster.scale(jobs=workers)
            yield client
    else:
        with Client(name) as client:
            yield client
