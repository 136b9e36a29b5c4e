"""Results as arrays."""
import os

import numpy as np

from ._native import InputError

_KINDS = ("separate", "touch", "cross", "inside", "contact", "undecided", "failed", "near")


class Results:
    """The answers for scenarios, in arrays of which element i is that of scenario `first` + i.

    A scenario is a pose; in a scene a pair of bodies at a step. Arrays that the question does not
    fill are empty.

    kind (N,) u1: 0 separate, 1 touch, 2 cross, 3 inside, 4 contact, 5 undecided, 6 failed, 7 near.
    count, near_count (N,) u8: pairs in contact, and near ones, also those that a limit cut off.
    offsets (N + 1,) u8, pairs (M, 2) u4, pair_class (M,) u1: the pairs of scenario i are those from
    offsets[i] up to offsets[i + 1]; classes are 1 touch, 2 coplanar, 3 proper, 4 near.
    point_offsets (M + 1,) u8, points (K, 3) f8: the points that each pair shares, in the world.
    pair_distance (M,) f8: of near pairs, at level contacts.
    distance (N,) f8, witness (N, 2) u4, witness_points (N, 2, 3) f8: NaN where there is none.
    step, body_a, body_b (N,): of a scene; bodies are indices of `body_names`.
    motion_end, motion_depth, t0, t1, run_offsets, runs (R, 5): of motions, as in results.npz.
    hits (M, 2) u4, hit_depth, hit_flags, hit_rank (M,): of shot lines, as in shots.npz: triangle of A and line.
    bundle (N,) u8: of shot lines in a scene, the bundle of each scenario in its step.
    map_a, map_b (T,) u8: with maps, the scenarios in which each triangle is in contact or near.
    failures: reasons, by scenario. digest: SHA-256 over all results; empty while some are missing.
    """

    def __init__(self, native, save=None):
        self._native = native
        self._save = save

    def __len__(self):
        return len(self._native)

    @property
    def hit(self):
        """Whether each scenario is in contact, (N,) bool."""
        kind = self._native.kind
        return (kind >= 1) & (kind <= 4)

    def pairs_of(self, scenario):
        """The pairs of a scenario, (m, 2) u4: a view of `pairs`."""
        offsets = self._native.offsets
        if not 0 <= scenario < len(self) or not len(offsets):
            raise IndexError(f"there are no pairs of scenario {scenario} of {len(self)}")
        return self._native.pairs[offsets[scenario]:offsets[scenario + 1]]

    @property
    def hits(self):
        """Of shot lines, the triangle of A and the line of each hit, (M, 2) u4: those of `pairs`."""
        return self._native.pairs[:len(self._native.hit_depth)]

    @property
    def index(self):
        """The number of each scenario, (N,) u8: `first` + i unless earlier scenarios have no result."""
        index = self._native.index
        return index if len(index) else self.first + np.arange(len(self), dtype=np.uint64)

    def save(self, folder, overwrite=False):
        """Writes the folder that `cdctl run --out` and `cdctl results --out` write.

        `open`, `cdctl view`, `report`, `diff` and `verify` read it. Needs the poses and files of the
        question as they were; results of a cluster are fetched again, with their poses. Raises
        InputError if the folder holds another run and `overwrite` is not set, or if inputs have changed.
        """
        if self._save is None:
            raise InputError("a window of results has no folder; ask for all poses at once, or use run(job, out=)")
        self._save(os.fspath(folder), overwrite)

    def to_pandas(self):
        """A table with a row for each scenario. Needs pandas."""
        import pandas  # Not needed otherwise.

        native = self._native
        columns = {"scenario": self.index}
        if len(native.step):
            names = np.array(native.body_names, dtype=object)
            columns |= {"step": native.step, "body_a": names[native.body_a], "body_b": names[native.body_b]}
        columns |= {"class": np.array(_KINDS, dtype=object)[native.kind], "count": native.count}
        for name in ("near_count", "distance"):
            if len(getattr(native, name)):
                columns[name] = getattr(native, name)
        return pandas.DataFrame(columns)

    def __repr__(self):
        return f"<cdcluster.Results of {len(self)} scenarios, {int(self.hit.sum())} in contact>"


for _name in ("first", "kind", "count", "near_count", "surfaces_only", "offsets", "pairs", "pair_class",
              "point_offsets", "points", "pair_distance", "hit_depth", "hit_flags", "hit_rank", "distance",
              "witness", "witness_points", "step", "bundle", "body_a", "body_b", "body_names", "motion_end",
              "motion_depth", "t0", "t1", "run_offsets", "runs", "map_a", "map_b", "failures", "digest"):
    setattr(Results, _name, property(lambda self, name=_name: getattr(self._native, name)))
