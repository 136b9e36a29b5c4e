// The long texts of the help: first line, what it does; then examples to type, then the rest.
#pragma once

namespace cd {

/// Of cdctl itself.
inline constexpr const char* main_help =
    "Finds every contact of two triangle meshes for many poses, here or on a cluster.\n"
    "Examples:\n"
    "  cdctl demo                                          a local cluster and a real vehicle\n"
    "  cdctl run --a car.obj --b post.stl --poses p.csv --out out\n"
    "  cdctl run --a car.obj --b post.stl --random 1000    the paper's kind of scenarios\n"
    "  cdctl run job.toml                                  on this machine alone\n"
    "  cdctl run job.toml --master 127.0.0.1:7600          on the cluster\n"
    "  cdctl inspect car.obj                               size, parts, closed or not\n"
    "\n"
    "Triangles only, exactly: no hulls, and no tolerance unless you ask for one. A pose maps B's "
    "coordinates into A's frame:\n"
    "x_A = R x_B + t.\n"
    "\n"
    "Exit codes: 0 done; 1 done, and contacts found (only with --fail-on); 2 wrong usage or "
    "input;\n"
    "3 incomplete (failed, cancelled); 4 master unreachable; 5 refused; 130 and 143 ended by a "
    "signal.\n"
    "Data goes to stdout, progress to stderr. NO_COLOR is honoured. `cdctl VERB --help` tells "
    "more.";

/// Of `cdctl run`.
inline constexpr const char* run_help =
    "Runs a job and reports: on this machine alone, or with --master on the cluster.\n"
    "Examples:\n"
    "  cdctl run job.toml\n"
    "  cdctl run job.toml --master 127.0.0.1:7600 --out out\n"
    "  cdctl run --a car.obj --b post.stl --unit-b mm --poses poses.csv --out out --formats "
    "csv,npz\n"
    "  cdctl run --a car.obj --b tram.obj --random 3744 --seed 1 --penetration 0.005 0.05\n"
    "  cdctl run --a a.stl --b b.stl --poses - -o csv < poses.csv > scenarios.csv\n"
    "  cdctl run job.toml --level count --fail-on cross || echo 'it clashes'\n"
    "  cdctl run job.toml --level any --tolerance 0.05     fast: separate, contact or undecided\n"
    "\n"
    "A job.toml has the keys name, unit, and the tables\n"
    "  [a] [b]    mesh = \"car.obj\", unit = \"mm\" (m, cm, mm, km, in, ft), name\n"
    "  [poses]    file = \"poses.npy\" | grid = { x = [-3, 3, 200], yaw_deg = [0, 350, 36] }\n"
    "             | random = { n = 1000, seed = 1, penetration = [0.005, 0.05] };\n"
    "             quat_order = \"xyzw\", of = \"both\", rigid_tolerance = 1e-5\n"
    "  [query]    level = \"any\" | \"count\" | \"pairs\" | \"contacts\", limit_pairs = 10_000,\n"
    "             tolerance = 0.05, ignore = [[\"wheel_*\", \"ground\"]]\n"
    "  [output]   dir = \"out\", formats = [\"text\", \"json\", \"csv\", \"npz\"]\n"
    "  [cluster]  strategy = \"best-match\", depth = { a = 12, b = 6 }, q = 20, v_kb = 4096, claim "
    "= true\n"
    "             strategy: best-match, best-match-load, random, lowest; best-match-pull: a free\n"
    "             worker takes the q most similar scenarios; earliest-finish: by time, not by q\n"
    "             analysis = \"auto\": the master finds which parts collide (always), or leaves "
    "it\n"
    "             to the workers and sends ranges of scenarios (never); auto: what costs less\n"
    "\n"
    "A tolerance above 0 stops at boxes whose diameters sum to no more. No contact is missed:\n"
    "separate stays proven, and what is left is undecided, with a length that the bodies are at\n"
    "most apart. It fixes the distribution depths. With --fail-on an undecided scenario makes the\n"
    "exit code 3 where no contact was proven.\n"
    "\n"
    "The summary (and statistics in summary.json) counts box pairs, N_b, and candidates, N_p: "
    "pairs\n"
    "of triangles that were tested. Without --master it also gives the paper's cost N_b C_b + N_p\n"
    "C_p. C_b and C_p, the time of one test of each kind, are measured on this machine after the\n"
    "run, under some of its poses, on one thread.";

} // namespace cd
