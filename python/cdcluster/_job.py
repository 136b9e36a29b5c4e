"""Jobs as `cdctl run` takes them."""
import os

from . import _native
from ._toml import toml_text


class Job:
    """A job as `cdctl run` takes it: two bodies, scenes, motions or shot lines."""

    def __init__(self, native):
        self._job = native

    @staticmethod
    def from_toml(text, folder="."):
        """Reads the text of a job file; paths in it are relative to `folder`."""
        return Job(_native.Job.from_toml(text, os.fspath(folder)))

    @staticmethod
    def from_file(file):
        """Reads a job file."""
        return Job(_native.Job.from_file(os.fspath(file)))

    @staticmethod
    def from_folder(folder):
        """Takes the job of a results folder, with the inputs that the folder keeps."""
        return Job(_native.Job.from_folder(os.fspath(folder)))

    @property
    def name(self):
        """The job's name; empty without one."""
        return self._job.name

    @staticmethod
    def of(job, folder="."):
        """The job itself, that of a dict with the tables of a job file, or that of a job file's path."""
        if isinstance(job, Job):
            return job
        return Job.from_toml(toml_text(job), folder) if isinstance(job, dict) else Job.from_file(job)
