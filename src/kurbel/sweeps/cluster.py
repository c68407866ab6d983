"""The workers of a cluster that runs already, by dask.distributed.

A worker that dies costs what it was computing: the scheduler gives it to another one. Parts are written by
the workers themselves where they see the folder of the run, and come over the network where they do not.
"""

from __future__ import annotations

import asyncio
import json
import logging
import warnings
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from queue import Empty, SimpleQueue
from socket import create_connection
from time import monotonic, sleep
from typing import Generic, TypeVar

from kurbel.errors import ChoiceError, FailedError
from kurbel.reading.environment import missing_extra
from kurbel.sweeps.hands import FOR_EACH
from kurbel.sweeps.versions import LIBRARIES, NONE, content_of, makers, other

try:
    from distributed import Client, Future, KilledWorker, get_worker
    from distributed.client import ClosedClientError
    from distributed.comm import CommClosedError, connect, get_address_host_port
    from distributed.security import Security
except ImportError as error:
    raise missing_extra("a scheduler needs dask.distributed", "scale") from error

Made = TypeVar("Made")
# Seconds in which a scheduler answers, or its file is there, and in which a worker has come to it.
PATIENCE, WORKERS = 10, 30
# Seconds in which one comes back when all have gone.
RETURN = 60
# How often the cluster is looked at, in seconds.
GLANCE = 1.0
SCHEMES = ("tcp://", "tls://")
# What runs the work, though no digit depends on it.
RUNNERS = ("kurbel", "dask", "distributed")


class Cluster(Generic[Made]):
    """The workers of a scheduler, to whom pieces are given by their numbers; `make` goes to them once.

    `name` is no other run's. Of the `files` that pieces are made of workers must see the same content, and
    they must have the same `libraries`.
    """

    def __init__(
        self,
        scheduler: str,
        make: Callable[[int], Made],
        name: str,
        files: Mapping[str, str],
        libraries: tuple[str, ...] = LIBRARIES,
    ) -> None:
        self._client = connected(scheduler)
        self._scheduler, self._name = scheduler, name
        try:
            self._libraries = libraries
            with _there(scheduler):
                self._made_by, self._files = checked(self._client, scheduler, libraries), files
                # A task, not data: if those who have it die, it comes anew from the scheduler.
                self._make = self._client.submit(_same, make, key=f"kurbel-{name}")
        except BaseException:
            self._client.close(timeout=PATIENCE)
            raise
        self._done: SimpleQueue[tuple[int, Future[Made]]] = SimpleQueue()
        self._given: dict[int, Future[Made]] = {}
        self._seen, self._most = monotonic(), self._looked(1)

    @property
    def most(self) -> int:
        """How many pieces are to be given at once; workers come and go."""
        if monotonic() - self._seen > GLANCE:
            self._seen, self._most = monotonic(), self._looked(self._most)
        return self._most

    def _looked(self, before: int) -> int:
        # Of a scheduler that is gone the pieces tell.
        with suppress(FailedError), _there(self._scheduler):
            threads: int = sum(self._client.nthreads().values())
            return FOR_EACH * max(1, threads)
        return before

    def give(self, number: int) -> None:
        """Have a piece made."""
        key = f"kurbel-{self._name}-{number}"
        made_by = self._libraries, self._made_by, self._files
        with _there(self._scheduler):
            future = self._client.submit(_made, self._make, number, *made_by, key=key, pure=False)
        self._given[number] = future
        future.add_done_callback(lambda done: self._done.put((number, done)))

    def take(self) -> tuple[int, Made]:
        """Return a piece that is done; raise what kept it from being made."""
        number, future = self._next()
        try:
            made = future.result()
        except KilledWorker as error:
            raise FailedError(
                f"workers that had to make part {number} died, one after the other, for want of memory or"
                " from outside; give them more memory each, or fewer threads"
            ) from error
        except ModuleNotFoundError as error:
            raise FailedError(
                f"a worker of {self._scheduler} has no {error.name}; install it there"
            ) from error
        except Exception as error:
            if future.status in ("cancelled", "lost") or isinstance(error, CommClosedError | TimeoutError):
                raise _gone(self._scheduler) from error
            raise
        del self._given[number]
        return number, made

    def _next(self) -> tuple[int, Future[Made]]:
        """Return a piece that has an end, good or bad, as long as there is anybody who works."""
        alone = None
        while True:
            with suppress(Empty):
                return self._done.get(timeout=GLANCE)
            if self._client.status not in ("running", "connecting"):
                raise _gone(self._scheduler)
            if self._has_workers():
                alone = None
            else:
                alone = alone or monotonic()
                if monotonic() - alone > RETURN:
                    raise FailedError(
                        f"all workers of {self._scheduler} have gone, and none came in {RETURN} s"
                    )

    def _has_workers(self) -> bool:
        with suppress(FailedError), _there(self._scheduler):
            return bool(self._client.nthreads())
        return True

    def end(self, at_once: bool) -> None:
        """Let the cluster go; what is given is cancelled."""
        with suppress(Exception):
            self._client.cancel([*self._given.values(), self._make], force=True)
        with suppress(Exception):
            self._client.close(timeout=PATIENCE)


@contextmanager
def _there(scheduler: str) -> Iterator[None]:
    """Raise FailedError where a client cannot reach the scheduler any longer, or has been closed for that."""
    try:
        yield
    except (OSError, RuntimeError, ClosedClientError) as error:
        raise _gone(scheduler) from error


def _gone(scheduler: str) -> FailedError:
    return FailedError(f"the scheduler at {scheduler} is gone, or it dropped the work")


def connected(scheduler: str) -> Client:
    """Return the client of a scheduler, by its address or a file that it wrote."""
    by_file = scheduler.endswith(".json")
    if not by_file and not scheduler.startswith(SCHEMES):
        raise ChoiceError(
            f'scheduler "{scheduler[:60]}" is no address; write tcp://HOST:8786, tls://HOST:8786, or the'
            " scheduler.json that dask scheduler --scheduler-file wrote"
        )
    _quiet()
    address = _noted(scheduler) if by_file else scheduler
    if address.startswith("tls://"):
        _check_certificates(scheduler)
    try:
        # In a thread: that of a notebook has a loop that runs already.
        with ThreadPoolExecutor(1) as pool:
            pool.submit(asyncio.run, _greet(address, scheduler)).result()
        # Other versions are refused, and not warned of.
        with warnings.catch_warnings(action="ignore"):
            return Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        if _listens(address):
            raise _stranger(scheduler, f"has not greeted as a scheduler within {PATIENCE} s") from error
        raise FailedError(
            f"no scheduler answered at {scheduler} within {PATIENCE} s; start one by: dask scheduler"
        ) from error


async def _greet(address: str, scheduler: str) -> None:
    """Return if a scheduler answers as one; a client waits without end for what never greets it.

    Raises FailedError for what answers otherwise, TimeoutError and OSError for what does not, and ValueError
    for what is no address.
    """
    get_address_host_port(address)
    about = Security().get_connection_args("client")
    greeting = asyncio.ensure_future(connect(address, timeout=PATIENCE, **about))
    await asyncio.wait([greeting], timeout=PATIENCE)
    if not greeting.done():
        greeting.cancel()
        raise TimeoutError
    # Of bytes that are no greeting anything may come.
    if error := greeting.exception():
        if isinstance(error, OSError):
            raise error
        raise _stranger(scheduler, "is no scheduler") from error
    greeting.result().abort()


def _listens(address: str) -> bool:
    """Whether anybody can be reached at an address, also one who never greets as a scheduler does."""
    try:
        with create_connection(get_address_host_port(address), PATIENCE):
            return True
    except (OSError, ValueError):
        return False


def _stranger(scheduler: str, why: str) -> FailedError:
    return FailedError(
        f"what answers at {scheduler} {why}; name the port that dask scheduler prints, 8786 if it is given no"
        " other"
    )


def _noted(file: str) -> str:
    """Return the address in the file of a scheduler, which may be just starting."""
    end = monotonic() + PATIENCE
    while True:
        try:
            with open(file, encoding="utf-8") as noted:
                return str(json.load(noted)["address"])
        except (OSError, ValueError, KeyError, TypeError) as error:
            if monotonic() > end:
                raise FailedError(
                    f"there is no address of a scheduler in {file}, and none came in {PATIENCE} s; start one"
                    f" by: dask scheduler --scheduler-file {file}"
                ) from error
        sleep(0.05)


def _check_certificates(scheduler: str) -> None:
    if Security().get_connection_args("client").get("ssl_context") is None:
        raise FailedError(
            f"{scheduler} needs certificates; name them in the configuration of Dask, distributed.comm.tls,"
            " as its scheduler and workers do"
        )


def _quiet() -> None:
    """Keep dask's log from the terminal: of connections that end, the sentences here say what matters."""
    for name in logging.root.manager.loggerDict:
        if name.partition(".")[0] == "distributed":
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)


def checked(client: Client, scheduler: str, libraries: tuple[str, ...]) -> dict[str, str]:
    """Return by what workers and this process make the same bytes; raise FailedError if one is by others."""
    try:
        client.wait_for_workers(1, timeout=WORKERS)
    except TimeoutError as error:
        raise FailedError(
            f"the scheduler at {scheduler} has no workers, and none came in {WORKERS} s; start some by:"
            f" dask worker {scheduler}"
        ) from error
    found = client.get_versions(packages=[*RUNNERS, *libraries])
    ours = _packages(found["client"], libraries)
    for worker, versions in found["workers"].items():
        _refuse_others(worker, ours, _packages(versions, libraries))
    own = makers(libraries)
    # The same versions, but perhaps another state of the source.
    for worker, theirs in client.run(makers, libraries, on_error="return").items():
        if isinstance(theirs, Exception):
            raise FailedError(f"worker {worker} cannot run kurbel: {theirs}; install there what is here")
        _refuse_others(worker, own, theirs)
    return own


def _packages(versions: Mapping[str, Mapping[str, str]], libraries: tuple[str, ...]) -> dict[str, str]:
    packages = versions["packages"]
    python = ".".join(packages["python"].split(".")[:2])
    return {"python": python} | {name: packages.get(name) or NONE for name in (*RUNNERS, *libraries)}


def _refuse_others(worker: str, ours: Mapping[str, str], theirs: Mapping[str, str]) -> None:
    if differences := other(ours, theirs):
        raise FailedError(
            f"worker {worker} has {differences}; its bytes might differ: install there what is here"
        )


def _same(one: Made) -> Made:
    return one


def _made(
    make: Callable[[int], Made],
    number: int,
    libraries: tuple[str, ...],
    made_by: Mapping[str, str],
    files: Mapping[str, str],
) -> Made:
    """Make a piece on a worker; one that came later was not asked by what it computes."""
    worker = get_worker().address
    _refuse_others(worker, made_by, makers(libraries))
    for path, content in files.items():
        if content_of(path) != content:
            raise FailedError(
                f"worker {worker} does not see {path} as it is here; put it where all see it by the same name"
            )
    return make(number)
