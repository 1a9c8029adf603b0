"""`roam batch JOBS`: many shots and steps on this machine's cores, or on the workers of a studio's scheduler."""

from __future__ import annotations

import argparse
import json
import sys
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from tqdm import tqdm

from roam_core.atomic_write import make_folder, write_atomically
from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite, require_own
from roam_core.cli.paths import path_word
from roam_core.cli.performing import WORK
from roam_core.cli.stopping import cancelling
from roam_core.errors import RoamError
from roam_core.studio import cluster, driver
from roam_core.studio.edits import require_edit
from roam_core.studio.fields import schema
from roam_core.studio.finding import jobs_from
from roam_core.studio.jobs import as_document, require_jobs_name
from roam_core.studio.order import longest_first
from roam_core.studio.report import pictures_in, report_of, write_report
from roam_core.studio.tasks import tasks_of

FAILED = 1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument(
        "jobs",
        type=path_word,
        nargs="?",
        metavar="JOBS",
        help="a file of jobs (YAML, JSON), a folder of shots, or an .otio",
    )
    parser.add_argument("--schema", action="store_true", help="print the JSON schema of a file of jobs, and do no more")
    parser.add_argument(
        "--write", type=path_word, metavar="FILE.json", help="write the jobs that were found, and do no more"
    )
    parser.add_argument("--out", type=path_word, metavar="DIR", help="folder of the results (default: as the jobs say)")
    parser.add_argument("--retries", type=int, default=1, metavar="N", help="tries more of what fails (%(default)s)")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a step, as it ends")
    found = parser.add_argument_group("a folder of shots, or an edit")
    found.add_argument(
        "--steps", metavar="LIST", help="such as track,render,export:nuke (default: as what lies there allows)"
    )
    found.add_argument("--handles", type=int, default=0, metavar="N", help=".otio: frames more at both ends of a clip")
    found.add_argument("--inits", type=path_word, metavar="DIR", help=".otio: masks and projects, named as the clips")
    found.add_argument(
        "--timeline", type=path_word, metavar="OUT.otio", help=".otio: write the edit with the mattes above it"
    )
    where = parser.add_argument_group("where it runs")
    where.add_argument("--workers", type=int, metavar="N", help="processes on this machine (default: its cores)")
    where.add_argument("--no-dashboard", action="store_true", help="this machine: without Dask's dashboard")
    where.add_argument("--scheduler", metavar="ADDRESS", help="use the workers of this Dask scheduler, host:port")
    where.add_argument("--tls-ca", type=path_word, metavar="FILE", help="the scheduler's authority, PEM")
    where.add_argument("--tls-cert", type=path_word, metavar="FILE", help="our certificate, PEM")
    where.add_argument("--tls-key", type=path_word, metavar="FILE", help="its key, PEM")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    if arguments.schema:
        print(json.dumps(schema(), indent=1))
        return 0
    require_sense(arguments)
    found = jobs_from(
        arguments.jobs, steps=arguments.steps, handles=arguments.handles, inits=arguments.inits, out=arguments.out
    )
    for note in found.notes:
        print(note, file=sys.stderr)
    if arguments.write is not None:
        read = [arguments.jobs, *(job.init for job in found.jobs.jobs if job.init is not None)]
        require_own(arguments.write, read, overwrite=arguments.overwrite)
        write_atomically(arguments.write, json.dumps(as_document(found.jobs), indent=1).encode() + b"\n")
        print(f"Wrote {len(found.jobs.jobs)} job(s) to {arguments.write}.", file=sys.stderr)
        return 0
    tasks = tasks_of(found.jobs, overwrite=arguments.overwrite)
    out = found.jobs.out
    make_folder(out)
    outcomes: list[driver.Outcome] = []
    began, workers = time.perf_counter(), 0
    try:
        with _client(arguments) as client, _Terminal(arguments.json) as terminal, cancelling() as token:
            workers = sum(client.nthreads().values())
            _tell_where(client, workers, dashboard=not arguments.no_dashboard)
            steps = driver.run(
                client,
                WORK,
                longest_first(tasks),
                retries=arguments.retries,
                pictures=pictures_in(out),
                watcher=terminal,
                ahead=0 if arguments.scheduler is None else driver.AHEAD,
                token=token,
            )
            outcomes.extend(steps)
    finally:
        if workers:
            report = report_of(tasks, outcomes, time.perf_counter() - began, workers)
            page = write_report(report, out)
    counts = report["counts"]
    said = ", ".join(f"{number} {status}" for status, number in counts.items())
    print(f"{len(tasks)} job(s): {said}. The report is {page}.", file=sys.stderr)
    if arguments.timeline is not None:
        found.write_timeline(arguments.timeline)
    return 0 if set(counts) <= set(driver.FINISHED) else FAILED


def require_sense(arguments: argparse.Namespace) -> None:
    """Refuse options that say nothing together."""
    if arguments.jobs is None:
        raise RoamError("Name a file of jobs, a folder of shots, or an .otio (or --schema).")
    if arguments.write is not None:
        require_jobs_name(arguments.write)  # nor is a picture of a plate written over
    if arguments.timeline is not None and arguments.jobs.suffix.lower() != ".otio":
        raise RoamError("--timeline is for an edit (.otio).")
    if arguments.timeline is not None and arguments.write is None:
        require_edit(arguments.timeline)
        require_own(arguments.timeline, [arguments.jobs], overwrite=arguments.overwrite)
    given = [arguments.tls_ca, arguments.tls_cert, arguments.tls_key]
    if any(given) and not all(given):
        raise RoamError("--tls-ca, --tls-cert and --tls-key go together; name all three.")
    if any(given) and arguments.scheduler is None:
        raise RoamError("--tls-ca, --tls-cert and --tls-key are for a scheduler; name it with --scheduler.")
    if arguments.scheduler is not None and arguments.workers is not None:
        raise RoamError("--workers is for this machine; a scheduler has its own.")
    if arguments.workers is not None and arguments.workers < 1:
        raise RoamError("--workers has to be 1 or more.")
    if arguments.retries < 0 or arguments.handles < 0:
        raise RoamError("--retries and --handles have to be 0 or more.")


@contextmanager
def _client(arguments: argparse.Namespace) -> Iterator[Any]:
    if arguments.scheduler is not None:
        tls = arguments.tls_ca and cluster.Encryption(arguments.tls_ca, arguments.tls_cert, arguments.tls_key)
        with cluster.named(arguments.scheduler, tls) as client:
            yield client
        return
    shares = cluster.Shares.here(arguments.workers)
    with cluster.local(shares, dashboard=not arguments.no_dashboard, loading=WORK.modules) as client:
        yield client


def _tell_where(client: Any, workers: int, *, dashboard: bool) -> None:
    link = cluster.dashboard_of(client) if dashboard else ""
    print(f"{workers} worker(s){f'; the dashboard is {link}' if link else ''}.", file=sys.stderr)


class _Terminal(driver.Watcher):
    """How a batch gets on, for who looks on: a bar on a terminal, else a line for each step that ends."""

    def __init__(self, as_json: bool) -> None:
        self._as_json = as_json
        self._bar: Any = None
        self._at: dict[str, str] = {}
        self._lock = threading.Lock()

    def __enter__(self) -> _Terminal:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def begun(self, steps: int) -> None:
        if sys.stderr.isatty():
            self._bar = tqdm(total=steps, unit="step", leave=False, smoothing=0.1)

    def more(self, steps: int) -> None:
        if self._bar is not None:
            self._bar.total += steps

    def moved(self, message: Mapping[str, Any]) -> None:
        if self._bar is not None:
            with self._lock:
                self._at[str(message.get("job"))] = str(message.get("frame"))
                self._show()

    def ended(self, outcome: driver.Outcome) -> None:
        if self._as_json:
            print_json(outcome)
        line = f"{outcome['job']}  {outcome['step']}  {outcome['status']}  {outcome['seconds']:.1f} s"
        is_idle = bool(outcome.get("idle")) and outcome["status"] == "done"
        if (is_idle or outcome["status"] in ("failed", "skipped")) and outcome.get("said"):
            line += f"  {outcome['said'].splitlines()[-1].removeprefix('roam: ')}"
        if self._bar is None:
            if not self._as_json:
                print(line, file=sys.stderr)
            return
        with self._lock:
            self._at.pop(outcome["job"], None)
            if is_idle or outcome["status"] == "failed":
                self._bar.write(line, file=sys.stderr)
            self._bar.update()
            self._show()

    def _show(self) -> None:
        shown = [f"{job} {frame}" for job, frame in list(self._at.items())[-3:]]
        self._bar.set_postfix_str(", ".join(shown))
