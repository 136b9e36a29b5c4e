// Help texts of the verbs: the first line says what the verb does, then come examples and the rest.
#pragma once

namespace cd {

inline constexpr const char* main_help =
    R"(Finds every contact of two triangle meshes for many poses, here or on a cluster.
Examples:
  cdctl demo                                          a local cluster and two vehicles
  cdctl run --a car.obj --b post.stl --poses p.csv --out out
  cdctl run --a car.obj --b post.stl --random 1000    the paper's kind of scenarios
  cdctl run job.toml                                  on this machine alone
  cdctl run job.toml --master 127.0.0.1:7600          on the cluster
  cdctl inspect car.obj                               size, parts, closed or not

Triangles only, exactly: no hulls, and no tolerance. A pose maps B's coordinates into A's
frame: x_A = R x_B + t.

Exit codes: 0 done; 1 done, and contacts found (only with --fail-on); 2 wrong usage or input;
3 incomplete (failed, cancelled); 4 master unreachable; 5 refused; 130 and 143 ended by a signal.
Data goes to stdout, progress to stderr. NO_COLOR is honoured. `cdctl VERB --help` tells more.)";

inline constexpr const char* run_help =
    R"(Runs a job and reports: on this machine alone, or with --master on the cluster.
Examples:
  cdctl run job.toml
  cdctl run job.toml --master 127.0.0.1:7600 --out out
  cdctl run --a car.obj --b post.stl --unit-b mm --poses poses.csv --out out --formats csv,npz
  cdctl run --a car.obj --b tram.obj --random 3744 --seed 1 --penetration 0.005 0.05
  cdctl run --a a.stl --b b.stl --poses - -o csv < poses.csv > scenarios.csv
  cdctl run job.toml --level count --fail-on cross || echo 'it clashes'
  cdctl run job.toml --dry-run                        checks inputs, estimates time and size
  cdctl run out                                       runs a results folder again
  cdctl run job.toml --reuse out --out new            runs only the poses that out lacks

A job.toml has the keys name, unit, and the tables
  [a] [b]    mesh = "car.obj", unit = "mm" (m, cm, mm, km, in, ft), name
             precision = "float" rounds coordinates (default: double if float loses digits);
             up = "y" turns y up to z up (default: the file's axes are not turned);
             origin = [0, 0, 0.5]: the point of the mesh that poses move and turn about;
             the default unit is the one that the file declares (COLLADA, FBX, 3MF, ...),
             or else the job's
  [poses]    file = "poses.npy" | grid = { x = [-3, 3, 200], yaw_deg = [0, 350, 36] }
             | random = { n = 1000, seed = 1, penetration = [0.005, 0.05] };
             unit = "mm" (of their lengths), quat_order = "xyzw", of = "both",
             rigid_tolerance = 1e-5. A .csv names its columns: x,y,z,qx,qy,qz,qw, or some of
             x, y, z, roll_deg, pitch_deg, yaw_deg (or _rad), or m00 to m23; with [motion] also
             vx, vy, vz, ax, ay, az, and wx, wy, wz in radians a second (or wx_deg, ...)
  [shots]    lines through a, instead of [b] and [poses]: spacing = 0.01, tile = 64,
             azimuth_deg = [0, 355, 72], elevation_deg = [-30, 90, 13], jitter = { seed = 1 },
             first = true: only the first hits; or file = "rays.npy", form = "rays" | "ends"
  [query]    level = "any" | "count" | "pairs" | "contacts", limit_pairs = 10_000,
             clearance = 0.005: also finds what is at most this far apart, in the job's unit
             (at level any, a scenario that is near takes two searches);
             level = "distance": how far the bodies are apart, with up_to = 2.5 if not farther;
             ignore = [["wheel_*", "ground"]]: parts of a with parts of b;
             or "a/wheel_*", with the body's name; \ before / * ? [ in names;
             maps = true: from level count on, map.csv and map.npz say in how many scenarios each
             triangle was in contact, and groups.csv each pair of parts, also at level count
  [output]   dir = "out", formats = ["csv", "csv-pairs", "npz", "h5", "json", "text", "vtp",
             "glb"]
  [cluster]  strategy = "earliest-finish", depth = "auto" | { a = 12, b = 6 }, v_kb = 4096
             strategy: as --strategy; with the paper's also q = 20 and claim = true
             analysis = "auto": the master finds which parts collide (always), or leaves it
             to the workers and sends ranges of scenarios (never); auto: what costs less
             depth: where a body's tree is cut into the blocks that travel; auto: into blocks
             of some 64 KiB
             hints = false: with earliest-finish, workers do not hear ahead what they will need

If a run into a folder is interrupted or killed, the same command resumes it. A finished
folder has summary.json, run.json, records (all results), the formats, and inputs/.

--reuse needs an earlier run with equal meshes and query. It takes the results of scenarios whose
poses have the same numbers there, whatever their index, except failed ones; with maps = true only
of those whose pairs are all listed. Digest, map and files are those of a run without it.

--stats (and statistics in summary.json) counts box pairs, N_b, and candidates, N_p: pairs
of triangles that were tested. Without --master it also gives the paper's cost N_b C_b + N_p
C_p. C_b and C_p, the time of one test of each kind, are measured on this machine after the
run, under some of its poses, on one thread. With --master it tells what travelled for the job:
geometry, by who gave it; how often a worker's cache held what a scenario needed; results.)";

inline constexpr const char* demo_help =
    R"(Starts a local cluster, runs a job on two vehicles, shows it in the browser.
Examples:
  cdctl demo                          on a terminal: until Ctrl-C, with the page's address
  cdctl demo --no-wait
  cdctl demo --scenarios 5000 --out results
  cdctl demo --vehicles debian        real ones, of the packages openfoam-examples, sumo-tools
  cdctl demo --a car.obj --b tram.obj)";

inline constexpr const char* inspect_help =
    R"(Shows what a mesh file holds.
Examples:
  cdctl inspect car.obj
  cdctl inspect post.stl --unit mm
  cdctl inspect car.obj --png car.png)";

inline constexpr const char* submit_help =
    R"(Hands a job to the master and prints its id.
Examples:
  cdctl submit job.toml
  job=$(cdctl submit job.toml -o name) && cdctl watch "$job"
  cdctl submit large.toml --priority -5       let all other jobs go first)";

inline constexpr const char* job_help =
    R"(Checks job files.
Examples:
  cdctl job check scene.toml)";

inline constexpr const char* check_help =
    R"(Checks a job with [bodies] and says which pairs of bodies it tests; runs nothing.
Examples:
  cdctl job check scene.toml
  cdctl job check scene.toml -o csv > coverage.csv

Reads meshes and poses, expands instances, parts and rules, and pairs the bodies' boxes at each
step. It prints the bodies; for each rule how many pairs of bodies it names, and about how many
it decides, since later rules win; and what becomes of the pairs at all steps:
  tested    their boxes come within reach of the clearance or up_to: a scenario each
  apart     their boxes show that they are farther apart
  ignored   by the rules
  fixed     neither body moves: step 0 has tested them
  absent    one of them is absent at the step
csv has a row of these for each step. docs/scenes.md has all.)";

inline constexpr const char* watch_help =
    R"(Follows a job to its end.
Examples:
  cdctl watch j-5692)";

inline constexpr const char* wait_help =
    R"(Waits for a job's end. Prints no progress, only why the job is waiting.
Examples:
  cdctl wait j-5692 --fail-on cross)";

inline constexpr const char* results_help =
    R"(Exports the results of a folder in more formats, or fetches those of a job on a master.
Examples:
  cdctl results out --formats npz,csv-pairs           more formats; runs nothing
  cdctl results out --formats h5                      the arrays for MATLAB and Julia
  cdctl results out --formats vtp,glb                 heat maps for ParaView and Blender
  cdctl results out -o csv > scenarios.csv
  cdctl results j-5692 --out out --formats csv,npz

Scenarios and triangles are numbered from 0; triangles are in the order of the mesh file.
Classes: 0 separate, 1 touch, 2 cross, 3 inside, 4 contact, 5 undecided, 6 failed. Classes of
pairs: 1 touch, 2 coplanar, 3 proper.
  cut             the list of pairs ends at limit_pairs; the count is still exact
  surfaces_only   a body is open, so containment was not tested
  insides_skipped triangles are ignored, so that nothing is said of the rest's insides
  distance_bound  undecided scenarios: the bodies are at most this far apart
npz and h5: the pairs of scenario i are pairs[offsets[i]:offsets[i+1]], the points of pair j
points_world[point_offsets[j]:point_offsets[j+1]], in the job's unit.
vtp: a.vtp and b.vtp (by the bodies' names) have in how many scenarios each triangle was in
contact; at level contacts contacts.vtp has the shared points. glb: a.glb and b.glb, whose
materials name the numbers of scenarios that their colour stands for. Both need a contact map:
level pairs or contacts, or count with maps. docs/formats.md and docs/exports.md have all.)";

inline constexpr const char* priority_help =
    R"(Changes the priority of a job that waits or runs.
Examples:
  cdctl priority j-5692 -5              let all other jobs go first
  cdctl priority j-5692 3 --credential admin.pem

Nothing that runs is stopped: the job's next work goes out in its new turn.)";

inline constexpr const char* cancel_help =
    R"(Ends a job early, or one of its scenarios, which fails then.
Examples:
  cdctl cancel j-5692
  cdctl cancel j-5692 --scenario 17     it takes too long; the job goes on without it)";

inline constexpr const char* explain_help =
    R"(Shows who answered a scenario and, while its job runs, how each worker
scores for it.
Examples:
  cdctl explain j-5692 17
  cdctl explain j-5692 17 -o json)";

inline constexpr const char* get_help =
    R"(Lists jobs, workers or meshes.
Examples:
  cdctl get jobs
  cdctl get workers -o wide)";

inline constexpr const char* status_help =
    R"(Shows the cluster; the last line names the bottleneck.
Examples:
  cdctl status)";

inline constexpr const char* version_help =
    R"(Prints version, commit, compiler, SIMD target and libraries.
Examples:
  cdctl version -o json)";

inline constexpr const char* config_help =
    R"(Shows the user's settings, and where each comes from.
Examples:
  cdctl config
  cdctl config -o json
  mkdir -p ~/.config/cdcluster
  echo 'master = "node-1:7600"' >> ~/.config/cdcluster/cdctl.toml

The file has these keys, each with the meaning of the option of its name:
  master      "node-1:7600"; then `run` uses this master, too, and --master here uses none
  credential  a file, or "none"
  formats     ["csv", "npz"]: what jobs and results have whose job file does not say
  level       "pairs": what jobs ask that do not say; kinds of jobs without it ask for pairs
  tree-cache  a folder, or "off"
Paths may begin with ~/, or else at the file's folder. An option precedes the environment
(CDCTL_MASTER, CDCTL_CREDENTIAL, CDCTL_TREE_CACHE), which precedes the file; a job file precedes
the file's formats and level. CDCTL_CONFIG names another file, or none.)";

inline constexpr const char* doctor_help =
    R"(Looks for what is wrong on this machine and with a cluster.
Examples:
  cdctl doctor
  cdctl doctor --master node-1:7600
  cdctl doctor --master node-1:7600 --http node-1:7680

It prints a line for each thing: ok, warn or FAIL. The versions of the workers, the ports at which
they serve each other, and the size of the master's disk are read from the master's HTTP port
(cdmaster --http); without it these are left out.

Exit codes: 0 nothing failed; 1 a line says FAIL.)";

inline constexpr const char* completion_help =
    R"(Prints a script that completes verbs, options, files and job ids in a shell.
Examples:
  source <(cdctl completion bash)           in ~/.bashrc
  source <(cdctl completion zsh)            in ~/.zshrc, after compinit
  cdctl completion fish | source            in ~/.config/fish/config.fish)";

inline constexpr const char* remove_help =
    R"(Removes jobs, with results, poses and meshes that no other job uses, or single meshes.
Examples:
  cdctl rm j-5692 j-a01c --yes
  cdctl rm j-5692 --cancel --yes      also while it runs
  cdctl rm 3f9c27a1 --yes             a mesh, for admins)";

inline constexpr const char* drain_help =
    R"(Drains workers: each finishes its running scenarios, returns the rest, and exits with code 0.
Examples:
  cdctl drain w-3
  cdctl drain --all
  cdctl drain w-3 --now               does not wait for running scenarios)";

inline constexpr const char* join_help =
    R"(Gets a credential for a master with a token.
Examples:
  cdctl join node-1:7600 --token T
  cdctl join node-1:7600 --token-file token --credential me.pem)";

inline constexpr const char* token_help =
    R"(Tokens with which others join.
Examples:
  cdctl token create --ttl 1h --uses 50
  cdctl token create --role submitter)";

inline constexpr const char* create_help =
    R"(Prints a token. Needs the credential of an admin.
Examples:
  cdctl token create --ttl 1h --uses 50
  cdctl token create --role submitter --credential admin.pem)";

inline constexpr const char* verify_help =
    R"(Runs a sample of a run's scenarios again here, decided by integers alone, and compares.
Examples:
  cdctl verify out
  cdctl verify out --sample 100000 --seed 7
  cdctl verify j-5692

Exit codes: 0 all records are the same; 1 one differs; 3 some scenario could not be run.)";

inline constexpr const char* view_help =
    R"(Shows a run, or the cluster, in the browser: classes, contact maps, scenarios in 3D.
Examples:
  cdctl view out
  cdctl view                                          the cluster and its jobs
  cdctl view out --port 8080 --no-browser
  cdctl view j-5692 --master node-1:7600

The page is served on 127.0.0.1 alone. The printed address has a key that is good until the
program ends: with Ctrl-C, or 30 minutes after the last request. From another machine:
ssh -L 8080:127.0.0.1:8080 HOST, with --port 8080.)";

inline constexpr const char* diff_help =
    R"(Compares the contacts of two runs.
Examples:
  cdctl diff old new
  cdctl diff old new --out changes --fail-on new
  cdctl diff j-5692 new -o json

Scenarios are matched by their index if all poses are equal, else by the column id if both pose
files have it, else by the numbers of their poses. A group is a part of A and a part of B in
contact; its sums are over the scenarios that both runs tested:
  new             in no scenario of OLD
  grown, shrunk   in more or fewer scenarios, or in as many with more or fewer pairs
  resolved        not in NEW, and all scenarios of OLD that had it were tested again
  not comparable  not in NEW, but some scenario that had it was not tested again; or at level
                  count, if OLD and NEW did not test the same scenarios in contact
--out writes diff.csv (scenarios with another class, count, or, for equal meshes and queries,
other pairs), diff_groups.csv, and diff_triangles.csv (bodies with an equal mesh).

Exit codes: 0 done; 1 differences (only with --fail-on); 3 nothing to compare, or with --fail-on
no difference, but some scenario of both has no class in one of them.)";

inline constexpr const char* extract_help =
    R"(Writes scenarios of a run as a job of their own, as pictures, or as 3D scenes.
Examples:
  cdctl extract out 41230 --out case && cdctl run case/job.toml
  cdctl extract out 100-199 --out case
  cdctl extract j-5692 41230 --out case
  cdctl extract out 41230 --out case --minimal
  cdctl extract out 41230 --as png
  cdctl extract out 100-199 --as vtp --out steps      ParaView: open steps/scenarios.pvd
  cdctl extract out 41230 --as glb                    Blender, f3d, slides

A case has a.npz and b.npz (all triangles; by the bodies' names), poses.csv in the form that was
tested, job.toml, and expected.json with the class and the digest that `cdctl run`
must give. A picture shows the bodies, and in red the triangles in contact that the
run listed (levels pairs and contacts).

vtp and glb run the scenarios again here, exactly and with shared points, whatever the run's
level. They have both bodies at the pose, triangles in contact in red (proper) and yellow (touch,
coplanar), and shared segments as lines. vtp: contacts-N.vtp for each scenario N, a.vtp and
b-N.vtp (a body that does not move stands once), and the series scenarios.pvd. glb: N.glb.)";

inline constexpr const char* report_help =
    R"(Writes a report of a run for screen and paper, and groups.csv.
Examples:
  cdctl report out
  cdctl report out -o report/van.html --pictures report
  cdctl report j-5692 --statuses clashes.toml
  cdctl report out --3d
  cdctl report out --body robot.link_4 --body gripper

The report is one HTML file below 5 MB, without script: what was found and what was not
tested, the bodies, the worst scenarios, the parts in contact, the space of poses, and how it
ran. It prints on A4. With --3d it also has the viewer of `cdctl view`, with the worst 20
scenarios, and a script; it opens without a server or a network. Of a scene all bodies of these
steps are shown; those for which the file has no room are named, and drawn as boxes or left out.
With --body all of it is about scenarios in which one of these bodies takes part; so are
groups.csv and --fail-on.

Groups are pairs of parts in contact (levels pairs and contacts, or count with maps). In a mesh
without parts they are of its connected pieces, the largest `piece 1`; at level count such a
mesh is one part.

A file of statuses says what people decided, a table for each pair of parts:
  [[clash]]
  a = "front_bumper"       part of A, with wildcards as in ignore; or "body/part"
  b = "bollard"
  status = "approved"      or "reviewed"
  note = "crumple zone, wanted"
  pairs_max = 400          approved only as long as no scenario has more
The last table that matches a group counts. docs/report.md has all.)";

} // namespace cd
