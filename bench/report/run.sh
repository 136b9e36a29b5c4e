# Shared by bench/*/run and bench/figures: builds programs, writes down where figures come from, makes a
# page and pictures. Sourced.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${CD_BENCH_BUILD:-$root/build/bench}
commit=unknown
load=unknown

# Prints the commit of the working tree, with -dirty where other files than pages of figures differ.
commit_of_tree() {
    local hash
    hash=$(git -C "$root" rev-parse --short=12 HEAD 2>/dev/null) || { echo unknown; return; }
    if [[ -n $(git -C "$root" status --porcelain -- ':!bench/*/RESULTS.md') ]]; then
        hash+=-dirty
    fi
    echo "$hash"
}

# Builds the targets with the preset `bench`, or takes those of the folder $CD_BENCH_BUILD, which must be
# of this commit and built for release. Sets `commit` and `load`: both are those before anything is measured.
build_programs() { # TARGETS...
    source "$root/deploy/packages"
    install_missing "${packages_build[@]}" "${packages_test[@]}" "${packages_peers[@]}"
    commit=$(commit_of_tree)
    load=$(cut -d ' ' -f 1 /proc/loadavg)
    if [[ -n ${CD_BENCH_BUILD:-} ]]; then
        return
    fi
    (cd "$root" && cmake --preset bench) >/dev/null
    cmake --build "$build" --target "$@" >&2
}

# Prints the folder of the models: CD_MESHES, or the one that the programs were built with.
meshes_of() { # FOLDER OF THE BUILD
    echo "${CD_MESHES:-$(sed -n 's/^CD_MESHES:PATH=//p' "$1/CMakeCache.txt")}"
}

# Writes the page and the pictures of a folder whose machine.csv its programs have begun, and names the
# folder. Fails when an answer of ours is wrong.
write_page() { # KIND FOLDER COMMAND
    local python
    {
        echo "command,\"$3\""
        echo "commit,$commit"
        echo "date,$(date -u +%F)"
        echo "load before,$load"
    } >>"$2/machine.csv"
    # The first Python that has Matplotlib: Debian's is not always the one that PATH names.
    for python in python3 /usr/bin/python3 ''; do
        if [[ -n $python ]] && "$python" -c 'import matplotlib' 2>/dev/null; then
            break
        fi
    done
    if [[ $1 =~ ^(answers|distances|gains|ranges|shots|motions|scenes)$ ]]; then
        : # Pages without pictures.
    elif [[ -n $python ]]; then
        "$python" -B "$root/bench/report/plot.py" "$1" "$2"
    else
        echo "MISSING: python3-matplotlib; the pictures are left out" >&2
    fi
    python3 -B "$root/bench/report/page.py" "$1" "$2"
    echo "the page is in $2"
}
