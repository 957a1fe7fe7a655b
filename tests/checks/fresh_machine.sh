#!/usr/bin/env bash
# The two commands of the README on a machine that has nothing but its base system.
#
#   sudo tests/checks/fresh_machine.sh [SUITE]        SUITE: bookworm (default), trixie, noble
#
# Not part of test.sh: it needs root, debootstrap, git and a mirror, and takes about half an hour.
# It makes a minimal root in a temporary folder, clones the last commit into it (into a path with
# spaces), and runs ./run.sh and ./test.sh quick there. With KEEP=1 the root is left to look at.
#
# The mirror is the one this machine's apt uses, or MIRROR=URL.
#
# Everything is mounted in a mount namespace of its own, which ends with its last process: outside
# of it nothing is ever mounted in the root, so that removing the root can reach nothing else.
set -euo pipefail

readonly script="${BASH_SOURCE[0]}"
checkout="$(cd "$(dirname "$script")/../.." && pwd -P)"
readonly checkout
readonly place='/home/some one/splineloft'

say() { printf '== %s\n' "$*"; }

fail() {
    printf 'fresh_machine.sh: %s\n' "$*" >&2
    exit 1
}

# The mirror that apt here uses for a distribution's main archive (not its security updates).
mirror_of_this_machine() {
    # shellcheck disable=SC2016 # the $(...) are apt's own
    apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
        awk -v name="$1" '$3 == "main" && ($2 == name || name == "") { print $1; exit }'
}

find_mirror() {
    local own
    own="$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")"
    case "$suite" in
    noble) [[ $own == noble ]] || fail "for an Ubuntu root on another system set MIRROR=URL" ;;
    *) [[ $own != noble ]] || fail "for a Debian root on another system set MIRROR=URL" ;;
    esac
    mirror_of_this_machine "$own"
}

# How apt here reaches the network (proxy, retries, certificates), for debootstrap and the root.
settings_of_this_machine() { apt-config dump | grep -iE '^Acquire::(https?::|Retries|ForceIPv)' || true; }

make_root() {
    local proxy=''
    eval "$(apt-config shell proxy Acquire::http::Proxy)"
    if [[ -n $proxy && $proxy != DIRECT ]]; then
        export http_proxy="$proxy"
    fi
    say "a minimal $suite in $machine"
    debootstrap --variant=minbase "$suite" "$machine" "$mirror" >"$scratch/debootstrap.log" 2>&1 || {
        tail -n 20 "$scratch/debootstrap.log" >&2
        fail "debootstrap failed"
    }
    settings_of_this_machine >"$machine/etc/apt/apt.conf.d/00as-on-the-host"
    cp -L /etc/resolv.conf /etc/hosts "$machine/etc/"
    if [[ $mirror == https:* && -f /etc/ssl/certs/ca-certificates.crt ]]; then
        mkdir -p "$machine/etc/ssl/certs"
        cp -L /etc/ssl/certs/ca-certificates.crt "$machine/etc/ssl/certs/"
    fi
    if [[ $suite == noble ]]; then
        printf 'deb %s noble main universe\n' "$mirror" >"$machine/etc/apt/sources.list"
    fi
}

clone_checkout() {
    if [[ -n "$(git -C "$checkout" status --porcelain)" ]]; then
        say "note: what is not committed is not tested"
    fi
    mkdir -p "$(dirname "$machine$place")"
    git clone --quiet --no-hardlinks "file://$checkout" "$machine$place"
}

# Runs in the namespace: mounts, and then nothing but the root is to be seen.
inside() {
    mount -t proc proc "$machine/proc"
    mount -t tmpfs tmpfs "$machine/dev"
    mkdir "$machine/dev/shm" "$machine/dev/pts"
    local device
    for device in null zero full random urandom tty; do
        : >"$machine/dev/$device"
        mount --bind "/dev/$device" "$machine/dev/$device"
    done
    mount -t tmpfs -o mode=1777 tmpfs "$machine/dev/shm"
    ln -s /proc/self/fd "$machine/dev/fd"
    mount -t tmpfs -o mode=1777 tmpfs "$machine/tmp"
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
        chroot "$machine" /bin/bash -c "$1" </dev/null
}

in_the_machine() {
    unshare --mount --pid --fork --kill-child --propagation private -- \
        bash "$script" --inside "$machine" "$1"
}

# attempt NAME COMMAND: runs it in the root, shows it, and keeps the verdict.
attempt() {
    local started=$SECONDS log="$scratch/$1.log" verdict=passed
    say "$1: $2"
    in_the_machine "$2" 2>&1 | tee "$log" || verdict=FAILED
    verdicts+=("$verdict in $((SECONDS - started)) s: $1")
    [[ $verdict == passed ]] || failures=$((failures + 1))
}

# shellcheck disable=SC2317 # the trap calls it
remove_root() {
    if [[ ${KEEP:-} == 1 ]]; then
        say "kept: $scratch"
        return
    fi
    if grep -qF " $machine/" /proc/self/mountinfo; then
        fail "something is mounted in $machine; it was not removed"
    fi
    rm -rf --one-file-system "$scratch"
}

if [[ ${1:-} == --inside ]]; then
    machine="$2"
    inside "$3"
    exit
fi

readonly suite="${1:-bookworm}"
[[ $EUID -eq 0 ]] || fail "run it as root"
for tool in debootstrap git unshare; do
    command -v "$tool" >/dev/null || fail "$tool is not installed"
done
mirror="${MIRROR:-$(find_mirror)}"
[[ -n $mirror ]] || fail "apt here names no mirror (apt-get update first?); set MIRROR=URL"
scratch="$(mktemp -d)"
machine="$scratch/root"
trap remove_root EXIT
failures=0
verdicts=()

make_root
clone_checkout
attempt 'run.sh, first time' "cd / && '$place/run.sh'"
attempt 'run.sh, again' "cd '$place' && ./run.sh assets/examples/ship-lines.json"
attempt 'the preview is a PNG' "head -c 4 '$place/build/splineloft-preview.png' | grep -q PNG"
attempt 'test.sh quick' "cd '$place' && ./test.sh quick"

say "on a fresh $suite:"
printf '%s\n' "${verdicts[@]}"
exit "$((failures > 0))"
