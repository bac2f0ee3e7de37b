#!/bin/sh
# chroot.sh RELEASE DIR [release] [paraview] [asan]: makes DIR a clean chroot of a release of Debian
# (bookworm, trixie, sid) or Ubuntu (noble) and runs Testing/run.sh in it; default all three.
# MIRROR in the environment: where packages come from, else debootstrap's own choice.
# Needs root, the package debootstrap and the network; about 5 GB in DIR. A DIR that holds a chroot
# of an earlier run is used again, with its packages and build folders: delete it to start afresh.
# The sources are copied, not mounted: what is built there stays there.
# The last line is that of run.sh: N passed, N failed, N skipped.
set -e
usage() { sed -n "2,8s/^# //p" "$0" >&2; exit 2; }
[ $# -ge 2 ] || usage
release=$1 root=$2
shift 2
[ "$(id -u)" -eq 0 ] || { echo "chroot.sh: only root can make a chroot" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "chroot.sh: debootstrap is missing" >&2; exit 1; }
sources=$(cd "$(dirname "$0")/.." && pwd)

case $release in
  bookworm | trixie | sid) components=main ;;
  noble) components=main,universe ;;
  *) usage ;;
esac

if [ ! -e "$root/made" ]; then
  debootstrap --variant=minbase --components="$components" "$release" "$root" ${MIRROR:+"$MIRROR"}
  # No services are started in there, and nothing waits for the disk.
  printf '#!/bin/sh\nexit 101\n' > "$root/usr/sbin/policy-rc.d"
  chmod +x "$root/usr/sbin/policy-rc.d"
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe"
  # A mirror's index of sid may be older than it says it may be.
  echo 'Acquire::Check-Valid-Until "false";' > "$root/etc/apt/apt.conf.d/valid"
  touch "$root/made"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"

mkdir -p "$root/src"
(cd "$sources" && tar -c --exclude='./build*' --exclude=./.git .) | tar -x -C "$root/src"

# Mounted for this run alone: in a namespace of its own, that ends with it.
# shellcheck disable=SC2016 # expanded in there
unshare --mount sh -ec '
  root=$1; shift
  mount -t proc proc "$root/proc"
  mount -t sysfs sysfs "$root/sys"
  mount --rbind /dev "$root/dev"
  exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    /src/Testing/run.sh "$@"' sh "$root" "$@"
