"""Where a batch runs: on this machine's cores, or on a Dask or Ray cluster through joblib."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Literal

from keyphase.errors import MissingPackageError, ParameterError

Backend = Literal["cores", "dask", "ray"]


@contextmanager
def running_on(backend: Backend, address: str | None) -> Iterator[None]:
    """Let joblib's Parallel run on the backend; `address` is that of a cluster's scheduler.

    Raises MissingPackageError where the cluster's package is not installed, ParameterError for an
    address without a cluster.
    """
    if backend == "cores":
        if address is not None:
            raise ParameterError("--address is that of a cluster; add --backend dask or ray.")
        yield
        return
    try:
        with _dask(address) if backend == "dask" else _ray(address):
            yield
    except ModuleNotFoundError as error:
        raise MissingPackageError(
            f"--backend {backend} needs the package '{error.name}', which is not installed; "
            f'install it: pip install "keyphase[{backend}]".'
        ) from error


@contextmanager
def _dask(address: str | None) -> Iterator[None]:
    from distributed import Client  # pyright: ignore[reportMissingImports]
    from joblib import parallel_config

    local = {} if address else {"dashboard_address": None, "host": "127.0.0.1"}
    with Client(address, **local), parallel_config(backend="dask"):
        yield


@contextmanager
def _ray(address: str | None) -> Iterator[None]:
    import ray  # pyright: ignore[reportMissingImports]
    from joblib import parallel_config
    from ray.util.joblib import register_ray  # pyright: ignore[reportMissingImports]

    ray.init(address=address, include_dashboard=False, ignore_reinit_error=True)
    register_ray()
    with parallel_config(backend="ray"):
        yield
