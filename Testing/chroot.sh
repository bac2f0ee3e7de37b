#!/bin/sh
# chroot.sh RELEASE DIR [release] [paraview] [asan] [packages]: makes DIR a clean chroot of a release
# of Debian (bookworm, trixie, sid) or Ubuntu (noble) and works in it; default all four.
#   release, paraview, asan   the builds and tests of Testing/run.sh
#   packages                  builds the packages, installs them in DIR.installed, a clean chroot
#                             of their own, uses and purges them; deletes that again
# MIRROR in the environment: where packages come from, else debootstrap's own choice.
# Needs root, the package debootstrap and the network; about 5 GB in DIR. A DIR that holds a chroot
# of an earlier run is used again, with its packages and build folders: delete it to start afresh.
# The sources are copied, not mounted: what is built there stays there.
# After builds, a line as that of run.sh: N passed, N failed, N skipped. The last tells the time.
set -e
usage() { sed -n "2,12s/^# //p" "$0" >&2; exit 2; }
[ $# -ge 2 ] || usage
release=$1 root=$2
shift 2
[ $# -gt 0 ] || set -- release paraview asan packages
builds=
packages=
for word; do
  case $word in
    release | paraview | asan) builds="$builds $word" ;;
    packages) packages=yes ;;
    *) usage ;;
  esac
done
case $release in
  bookworm | trixie | sid) components=main ;;
  noble) components=main,universe ;;
  *) usage ;;
esac
[ "$(id -u)" -eq 0 ] || { echo "chroot.sh: only root can make a chroot" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "chroot.sh: debootstrap is missing" >&2; exit 1; }
sources=$(cd "$(dirname "$0")/.." && pwd)
start=$(date +%s)

# make DIR: a chroot of the release, unless DIR is one, with the sources of today.
make()
{
  if [ ! -e "$1/made" ]; then
    debootstrap --variant=minbase --components="$components" "$release" "$1" ${MIRROR:+"$MIRROR"}
    # No services are started in there, and nothing waits for the disk.
    printf '#!/bin/sh\nexit 101\n' > "$1/usr/sbin/policy-rc.d"
    chmod +x "$1/usr/sbin/policy-rc.d"
    echo force-unsafe-io > "$1/etc/dpkg/dpkg.cfg.d/unsafe"
    # A mirror's index of sid may be older than it says it may be.
    echo 'Acquire::Check-Valid-Until "false";' > "$1/etc/apt/apt.conf.d/valid"
    touch "$1/made"
  fi
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  mkdir -p "$1/src"
  # Files that are gone since an earlier run are to go there, too.
  find "$1/src" -mindepth 1 -maxdepth 1 ! -name 'build*' -exec rm -rf {} +
  # As if written now: objects of an earlier run must not seem newer than what they are made of.
  (cd "$sources" && tar -c --exclude='./build*' --exclude=./.git .) | tar -x -m -C "$1/src"
}

# enter DIR COMMAND...: runs it in there, with what programs want mounted for this run alone: in a
# namespace of its own, that ends with it.
enter()
{
  # shellcheck disable=SC2016 # expanded in there
  unshare --mount sh -ec '
    root=$1; shift
    mount -t proc proc "$root/proc"
    mount -t sysfs sysfs "$root/sys"
    mount --rbind /dev "$root/dev"
    exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
      "$@"' sh "$@"
}

status=0
make "$root"
if [ -n "$builds" ]; then
  # shellcheck disable=SC2086 # a list of words
  enter "$root" /src/Testing/run.sh $builds || status=1
fi
if [ -n "$packages" ]; then
  rm -rf "$root/src/build-packages" "$root.installed"
  enter "$root" /src/CMake/make-packages.sh
  make "$root.installed"
  cp -r "$root/src/build-packages" "$root.installed/packages"
  enter "$root.installed" /src/Testing/Packages/installed.sh /packages || status=1
  rm -rf "$root.installed"
fi
echo "chroot.sh: $release took $((($(date +%s) - start) / 60)) minutes"
exit $status
