"""Where a batch runs: a cluster of this machine, bound to itself alone, or a scheduler that the user names."""

from __future__ import annotations

import logging
import multiprocessing
import os
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from roam_core.errors import RoamError
from roam_core.installation import studio_module

HERE = "127.0.0.1"
DASHBOARD = 8787
"""Port of the dashboard; another one where that is taken."""
ENGINE_THREADS = 2
"""Threads that the engine can use."""
CACHE_SHARE = 0.2
"""Of a worker's memory, for decoded pictures."""
MOST_CACHE = 512
"""Megabytes of decoded pictures beyond which a command gains nothing."""
TOPIC = "roam"
CONNECT_SECONDS = 15


@dataclass(frozen=True)
class Encryption:
    """The files of a scheduler that speaks TLS: the authority's certificate, ours, and its key."""

    authority: Path
    certificate: Path
    key: Path


def cores() -> int:
    """Cores that this process may use; a container's limits count."""
    return int(studio_module("dask.system").CPU_COUNT)


@dataclass(frozen=True)
class Shares:
    """What each worker of this machine has: threads of the engine, bytes of memory, megabytes of decoded pictures."""

    workers: int
    threads: int
    memory: int
    cache: int

    @classmethod
    def of(cls, cores: int, memory: int, wanted: int | None = None) -> Shares:
        """The machine's cores and memory (bytes), shared among as many workers as cores, or as many as are wanted."""
        workers = max(1, wanted or cores)
        share = memory // workers
        cache = max(32, min(MOST_CACHE, int(share * CACHE_SHARE) >> 20))
        return cls(workers, max(1, min(ENGINE_THREADS, cores // workers)), share, cache)

    @classmethod
    def here(cls, wanted: int | None = None) -> Shares:
        """The shares of this machine; a container's limits count."""
        system = studio_module("distributed.system")
        return cls.of(cores(), system.MEMORY_LIMIT, wanted)

    @property
    def environment(self) -> dict[str, str]:
        """What tells a worker of its share."""
        return {"ROAM_THREADS": str(self.threads), "ROAM_CACHE_MB": str(self.cache), "MALLOC_TRIM_THRESHOLD_": "65536"}


@contextmanager
def local(shares: Shares, *, dashboard: bool = True, loading: Sequence[str] = ()) -> Iterator[Any]:
    """A client of a cluster of this machine for the length of a `with` block: processes that take one step at a time.

    Scheduler, workers and dashboard are bound to 127.0.0.1. What they say to one another is encrypted with a key that
    only this run has, so that no other user of the machine can give them work. `loading` names the modules that workers
    need: where the system can fork, one process loads them, and workers are forks of it.
    """
    distributed = studio_module("distributed")
    studio_module("cryptography")
    if dashboard:
        studio_module("bokeh")
    with (
        _settings(),
        _forking(shares, loading),
        distributed.LocalCluster(
            n_workers=shares.workers,
            threads_per_worker=1,
            processes=True,
            host=HERE,
            protocol="tls://",
            security=distributed.Security.temporary(),
            dashboard_address=f"{HERE}:{DASHBOARD}" if dashboard else f"{HERE}:0",
            memory_limit=shares.memory,
            env=shares.environment,
            preload=[__name__],
            scheduler_kwargs={"dashboard": dashboard},
            silence_logs=logging.CRITICAL,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def dask_setup(_worker: Any) -> None:
    """Called by Dask on each worker of ours as it starts (`preload`): Ctrl-C is for the batch, which stops its workers.

    A terminal sends it to all processes. A worker that heard of it would end in the middle of a step.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextmanager
def _forking(shares: Shares, loading: Sequence[str]) -> Iterator[None]:
    """Have workers be forks of one process that has loaded `loading`, for the length of a `with` block, on Linux.

    That process has one thread, for it gets a worker's environment: so it can be forked at any time. It serves later
    clusters of this process too. Elsewhere, and where a module cannot be loaded there, each worker loads what it needs.
    """
    if sys.platform != "linux":
        yield
        return
    dask, utils = studio_module("dask"), studio_module("distributed.utils")
    with dask.config.set({"distributed.worker.multiprocessing-method": "forkserver"}):
        utils.get_mp_context()  # the first time it sets a list of its own
        multiprocessing.set_forkserver_preload(["distributed.nanny", *loading])
        environment = dask.config.get("distributed.nanny.pre-spawn-environ") | shares.environment
        with _with_environment(environment), _deaf_to_interrupts():
            import_module("multiprocessing.forkserver").ensure_running()
        yield


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """Have a process that is begun in this `with` block, and its forks, not hear Ctrl-C from their first moment on.

    Until it has loaded its modules the process would end in a traceback, and a fork until `dask_setup` is called. Here
    Ctrl-C waits for the end of the block.
    """
    import_module("multiprocessing.resource_tracker").ensure_running()  # as it begins it lets Ctrl-C through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _with_environment(wanted: Mapping[str, Any]) -> Iterator[None]:
    """Have a process that is begun in this `with` block get these variables; the others are left alone."""
    before = {name: os.environ.get(name) for name in wanted}
    os.environ.update({name: str(value) for name, value in wanted.items()})
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


@contextmanager
def named(address: str, encryption: Encryption | None = None) -> Iterator[Any]:
    """A client of the scheduler at `address` for the length of a `with` block.

    Raises `RoamError` where none answers there, it has another encryption, or no workers.
    """
    distributed = studio_module("distributed")
    if "://" not in address:
        address = f"{'tls' if encryption else 'tcp'}://{address}"
    with _settings():
        try:
            client = distributed.Client(address, security=_security(encryption), timeout=CONNECT_SECONDS)
        except (OSError, ValueError, TypeError) as error:
            raise RoamError(
                f"No scheduler answers at {address}: {error}. Name it as host:port, with TLS if it has it."
            ) from None
        with client:
            try:
                client.wait_for_workers(1, timeout=CONNECT_SECONDS)
            except TimeoutError:
                raise RoamError(
                    f"The scheduler at {address} has no workers; start some that see the same folders as this machine."
                ) from None
            yield client


def dashboard_of(client: Any) -> str:
    """The address of the dashboard; "" where there is none."""
    return str(client.dashboard_link) if "dashboard" in client.scheduler_info().get("services", {}) else ""


def tell(message: Mapping[str, Any]) -> None:
    """Called by a step on a worker: have the batch hear of it."""
    studio_module("distributed").get_worker().log_event(TOPIC, dict(message))


def _security(encryption: Encryption | None) -> Any:
    if encryption is None:
        return None
    for path in (encryption.authority, encryption.certificate, encryption.key):
        if not path.is_file():
            raise RoamError(f"{path} does not exist; --tls-ca, --tls-cert and --tls-key name files in PEM.")
    return studio_module("distributed").Security(
        tls_ca_file=str(encryption.authority),
        tls_client_cert=str(encryption.certificate),
        tls_client_key=str(encryption.key),
        require_encryption=True,
    )


@contextmanager
def _settings() -> Iterator[None]:
    """Dask's settings for a batch, and its log kept off the terminal."""
    dask = studio_module("dask")
    wanted = {
        "distributed.scheduler.allowed-failures": 0,  # a step that loses its worker is repeated by us
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: one that dies loses one step
        "distributed.worker.daemon": True,
        "distributed.comm.timeouts.connect": f"{CONNECT_SECONDS}s",
        "distributed.admin.low-level-log-length": 100,
    }
    log = logging.getLogger("distributed")
    before = log.level
    log.setLevel(logging.CRITICAL)
    try:
        with dask.config.set(wanted):
            yield
    finally:
        log.setLevel(before)


def process_name() -> str:
    """Something that no other batch is called."""
    return f"{os.getpid()}-{os.urandom(6).hex()}"
