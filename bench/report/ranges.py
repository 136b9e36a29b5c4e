"""Jobs in ranges on thousands of simulated hosts, as a page."""
from tables import fixed, number, show, table

TITLE = "Jobs in ranges on 1,000 and 10,000 hosts"
FILES = ("ranges",)
PAGE = "RESULTS.md"


def jobs_section(rows):
    lines = []
    for row in rows:
        lines.append([show(number(row, "hosts")), row["scenario_ms"], row["result_us"], show(number(row, "scenarios")),
                      *(fixed(number(row, f"{what}_seconds"), 2) for what in ("compute", "geometry", "master")),
                      fixed(number(row, "seconds"), 2), f"{100 * number(row, 'share'):.1f} %",
                      row["uploads_max"], f"{number(row, 'start_share') * 100:.0f} / "
                      f"{number(row, 'between_share') * 100:.0f} / {number(row, 'tail_share') * 100:.0f} %",
                      fixed(number(row, "coordinator_us"), 2), f"{100 * number(row, 'master_share'):.0f} %"])
    first = rows[0]
    note = (f"The real coordinator in simulated time: hosts of {first['threads']} cores and 1 Gb/s, empty caches, "
            f"{fixed(number(first, 'geometry_mb'))} MB of geometry, level count, no analysis. *Compute*, *geometry* "
            "(to one host), *master*: the least seconds each alone allows; *s* came out. *Share*: of the weighted "
            "bound. *Uploads*: most times that the master sent one block. *Idle*: before, between, after work. "
            "*Coordinator*: its processor time, which the simulated master's one thread spends as well as that of "
            "the results; *busy*: that thread's share of the time.")
    return "## Jobs\n" + note + "\n\n" + table(
        ["hosts", "ms a scenario", "master, us a result", "scenarios", "compute, s", "geometry, s", "master, s", "s",
         "share", "uploads", "idle", "coordinator, us a scenario", "busy"], lines)


def faults(data):
    """What of ours is wrong, in words."""
    short = [row for row in data["ranges"] if row["answered"] != row["scenarios"]]
    often = [row for row in data["ranges"] if number(row, "uploads_max") > 2]
    return ([f"{len(short)} jobs were not answered"] if short else []) + (
        [f"the master sent a block more than twice in {len(often)} jobs"] if often else [])


def summary(data):
    return [jobs_section(data["ranges"])]
