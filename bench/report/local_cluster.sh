# A cluster of this machine, of the programs in the build $programs. Sourced, after run.sh.
scratch=$(mktemp -d) # Its files.
pids=()              # The master's is the first.
pinned=()            # A command before each program, such as taskset.
host=127.0.0.1       # The master's address.

stop() { # Ends what was started, and waits for it.
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null || true; done
    pids=()
}
trap 'stop; rm -rf "$scratch"' EXIT

start_master() { # OPTIONS...: sets $master to its address
    rm -f "$scratch/port"
    "${pinned[@]}" "$programs/bin/cdmaster" --listen "$host:0" --port-file "$scratch/port" \
        --state "$scratch/state" --log-level warning "$@" >"$scratch/master.log" 2>&1 &
    pids+=($!)
    until [[ -s $scratch/port ]]; do sleep 0.1; done
    master=$host:$(<"$scratch/port")
}

field() { # EXPRESSION over the cluster's status s
    "$programs/bin/cdctl" status --master "$master" -o json |
        python3 -c "import json,sys; s=json.load(sys.stdin); print($1)"
}

cpu() { # PID...: user and system time, seconds
    local ticks=0 pid
    for pid in "$@"; do
        read -r -a fields < <(sed 's/.*) //' "/proc/$pid/stat")
        ticks=$((ticks + fields[11] + fields[12]))
    done
    python3 -c "print($ticks / $(getconf CLK_TCK))"
}

start_workers() { # COUNT [THREADS]: of one thread each, or so many
    local i
    for ((i = 0; i < $1; ++i)); do
        "${pinned[@]}" "$programs/bin/cdworker" --master "$master" --threads "${2:-1}" --name "w$i" \
            >"$scratch/w$i.log" 2>&1 &
        pids+=($!)
    done
    until [[ $(field 'sum(w["state"] == "idle" for w in s["workers"])') == "$1" ]]; do sleep 0.1; done
}

run_job() { # OPTIONS...: submits a job and waits for its end
    local id
    id=$("$programs/bin/cdctl" submit "$@" --master "$master" -q -o name 2>/dev/null)
    "$programs/bin/cdctl" wait "$id" --master "$master" >/dev/null 2>&1 || true
}
