"""How a run is carried out: by how many processes, where, and what is kept of its blocks; no two runs write one output."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from ..common.atomic_files import temporary_folder
from ..common.errors import OutputError
from ..common.feedback import Feedback
from ..common.output_locks import sole_writer
from .block_clouds import BlockClouds
from .job_runner import JobRunner, check_scheduler
from .local_processes import LocalProcesses, cores, processes_for


@dataclass(frozen=True)
class RunOptions:
    """How a run is carried out; nothing here changes its result but the seed.

    Attributes
    ----------
    workers
        Local processes; 0 takes one per core.
    scheduler
        Address of a dask scheduler instead.
    resume
        Keep finished blocks beside the output and use those of an earlier, interrupted run.
    seed
        Of the random draws.
    """

    workers: int = 0
    scheduler: str | None = None
    resume: bool = False
    seed: int = 0

    @property
    def cores(self) -> int:
        """Local processes asked for: one a core where their number is left open."""
        return cores(self.workers)


@contextmanager
def job_runner(
    output: Path, options: RunOptions, feedback: Feedback, processes: LocalProcesses | None = None, *, keep_points: bool = False
) -> Iterator[JobRunner]:
    """A runner whose files are kept beside the output with ``resume`` and vanish otherwise.

    ``processes`` are those of :func:`.local_processes.processes_for`, started already; None makes them. ``keep_points``: later jobs look at
    the points of blocks again, which are kept where files vanish with the run.

    Raises
    ------
    InputError, TetratrackError
        The scheduler's address is wrong, or nothing answers there.
    OutputError
        Another run is writing this output.
    """
    processes = processes or processes_for(options.workers, options.scheduler)
    if options.scheduler is not None:
        check_scheduler(options.scheduler)
    target = output.absolute()
    with sole_writer(target):
        if options.resume:
            folder = target.with_name(f"{target.name}.jobs")
            try:
                folder.mkdir(exist_ok=True)
            except OSError as error:
                raise OutputError(
                    f"cannot be made ({error.strerror})", source=folder, remedy="Check the folder's permissions and free space."
                ) from error
            with JobRunner(folder, options.cores, options.scheduler, feedback.is_cancelled, processes) as runner:
                yield runner
            return
        # workers of a cluster see the folder of the output, and nothing else for sure
        place = target.parent if options.scheduler else None
        with temporary_folder(place) as temporary:
            # workers of a cluster would have them sent through its network
            clouds = BlockClouds(temporary if keep_points and not options.scheduler else None)
            with JobRunner(temporary, options.cores, options.scheduler, feedback.is_cancelled, processes, clouds) as runner:
                yield runner
