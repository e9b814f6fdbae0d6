# Sourced by data/streetgen and tests/run: packages, build, a private PostgreSQL cluster.
# Everything lives under build/; no other cluster of the machine is touched or sees this one.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${STREETGEN_BUILD:-$root/build}
home=${STREETGEN_HOME:-$build/cluster}
stage=$build/stage
checkout=$(printf %s "$root" | cksum | cut -d' ' -f1)
sign_in=/var/lib/streetgen

# The comment at its head is a script's help.
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }
case ${1:-} in -h | --help) usage; exit ;; esac

say() { printf '%s\n' "$*" >&2; }
fail() { say "streetgen: $*"; exit 1; }

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# postgres refuses root: a system user runs it then.
server_user() { if [ "$(id -u)" = 0 ]; then echo streetgen; else id -un; fi; }
as_server() { if [ "$(id -u)" = 0 ]; then runuser -u streetgen -- "$@"; else "$@"; fi; }

# PostgreSQL is the one that the distribution has.
install_packages() {
  install_missing g++ cmake make postgresql postgresql-server-dev-all postgresql-postgis postgresql-postgis-scripts \
    postgis libgeos-dev libboost-dev libeigen3-dev osm2pgsql osmium-tool bzip2 gdal-bin librsvg2-bin fonts-dejavu-core
}

install_qgis() { install_missing python3-qgis qgis-providers; }

# The tests of the core and of SQL need these.
install_for_tests() {
  install_packages
  local server
  server=postgresql-$(pg_config --version | sed -E 's/[^0-9]*([0-9]+).*/\1/')
  install_missing libgtest-dev "$server-plpgsql-check" "$server-pgrouting"
}

# The programs that judge what the suites write.
install_judges() { install_missing assimp-utils sumo sumo-tools libxml2-utils python3 python3-ezdxf glpk-utils; }

# What the readers of $STREETGEN_READERS need, which are built for Debian 12.
install_readers() {
  install_missing libboost-serialization1.74.0 libboost-filesystem1.74.0 libboost-program-options1.74.0 libpugixml1v5 libgeographiclib23
}

install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} = 0 ] && return
  say "installing ${missing[*]}"
  mkdir -p "$build"
  if ! [ -e /etc/postgresql-common/createcluster.conf ]; then
    as_root mkdir -p /etc/postgresql-common
    echo 'create_main_cluster = false' | as_root tee /etc/postgresql-common/createcluster.conf >/dev/null
  fi
  { as_root apt-get update -qq && as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >"$build/packages.log" 2>&1 ||
    { tail -20 "$build/packages.log" >&2; fail "the packages cannot be installed; $build/packages.log says more"; }
}

# timed NAME COMMAND…: says how long it took; also before it and of less than 20 s where $time_all is set.
timed() {
  local name=$1 began=$SECONDS
  shift
  [ -z "${time_all:-}" ] || ! [ -t 2 ] || tell "$name" …
  "$@"
  [ -z "${time_all:-}" ] && [ $((SECONDS - began)) -lt 20 ] || tell "$name" "$((SECONDS - began)) s"
}

# tell NAME HOW_FAR: a line; on a terminal the next one replaces it where it ends in "…".
tell() {
  if [ -t 2 ]; then printf '\r%-12s %-12s' "$1" "$2" >&2; else printf '%-12s %s' "$1" "$2" >&2; fi
  [[ -t 2 && $2 = *… ]] || printf '\n' >&2
}

# From what cmake prints: every tenth part of what is compiled.
tell_compiling() {
  local line told=0 share
  while IFS= read -r line; do
    [[ $line =~ ^\[\ *([0-9]+)%\]\ Building ]] || continue
    share=$((BASH_REMATCH[1] / 10 * 10))
    [ "$share" -le "$told" ] || { told=$share; tell compiling "$share % …"; }
  done
}

# The module, linked with all types in view: two definitions of one name are an error, and so is a file that leans on a precompiled header.
linked=(-DCMAKE_BUILD_TYPE=None -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON '-DCMAKE_CXX_FLAGS=-O0 -flto=auto -Werror=odr')

# build_targets TARGET…: one at a time, as several tests may want it.
build_targets() {
  mkdir -p "$build"
  (
    flock 9
    cmake -S "$root" -B "$build/release" ${STREETGEN_LINKED:+"${linked[@]}"} >"$build/cmake.log" 2>&1 || { cat "$build/cmake.log" >&2; fail "cmake failed"; }
    cmake --build "$build/release" -j"$(nproc)" --target "$@" 2>&1 | tee "$build/build.log" | tell_compiling || { tail -40 "$build/build.log" >&2; fail "the build failed"; }
  ) 9>"$build/release.lock"
}

# Asks cmake only where a source is later than the last build that ended, or the build is of another kind: a command would wait a second for its answer.
build_extension() {
  local stamp=$stage/.built kind last=
  kind="$(pg_config --version)${STREETGEN_LINKED:+, linked}"
  [ ! -e "$stamp" ] || last=$(cat "$stamp")
  [ "$last" != "$kind" ] || [ -n "$(cd "$root" && find CMakeLists.txt data/renew.sql include sql src -newer "$stamp" -print -quit)" ] || return 0
  # What cmake found for another server, or another kind, holds no longer.
  [ "$last" = "$kind" ] || [ -z "$last" ] || rm -rf "$build/release"
  mkdir -p "$stage"
  echo "$kind" >"$stamp.$BASHPID"
  # Where the caller asks for its status, bash goes on after a command that fails.
  build_targets streetgen install_script && DESTDIR=$stage flock "$build/release.lock" cmake --install "$build/release" >/dev/null ||
    { rm -f "$stamp.$BASHPID"; return 1; }
  mv "$stamp.$BASHPID" "$stamp"
}

build_tests() { build_targets streetgen_core_test; }

# build_beside FOLDER TARGET OPTION…: a build of its own, with options of cmake.
build_beside() {
  mkdir -p "$build"
  (
    flock 9
    cmake -S "$root" -B "$build/$1" "${@:3}" >"$build/$1.log" 2>&1 && cmake --build "$build/$1" -j"$(nproc)" --target "$2" >"$build/$1.log" 2>&1 ||
      { tail -20 "$build/$1.log" >&2; fail "the build in $build/$1 failed"; }
  ) 9>"$build/$1.lock"
}

# The core, its tests and the fuzz program under ASan and UBSan, with every assertion.
build_sanitized() { build_beside sanitized all -DCMAKE_BUILD_TYPE=Debug -DSTREETGEN_SANITIZE=ON; }

build_linked() { build_beside linked streetgen "${linked[@]}"; }

pg_bin() { pg_config --bindir; }

# A free port of the loopback interface.
free_port() {
  local port
  for port in $(shuf -i 54000-58000 -n 50); do
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
  done
}

# The cluster's own folder, in a place that its user may read.
settle_home() {
  if [ "$(id -u)" = 0 ]; then
    id streetgen >/dev/null 2>&1 || useradd --system --home-dir /nonexistent --shell /usr/sbin/nologin streetgen
    # Each checkout signs in, so that the last one to be removed takes the user with it.
    mkdir -p "$sign_in"
    ln -sfn "$build" "$sign_in/$checkout"
    # A checkout under a closed folder cannot be read by that user: then the files go to /var/lib.
    mkdir -p "$build"
    if ! runuser -u streetgen -- test -x "$build"; then
      home=${STREETGEN_HOME:-/var/lib/streetgen-$checkout}
      stage=$home/stage
    fi
  fi
}

running() { [ -s "$home/data/postmaster.pid" ] && as_server "$(pg_bin)/pg_ctl" -D "$home/data" status >/dev/null 2>&1; }

start_cluster() {
  mkdir -p "$home/run"
  [ "$(id -u)" = 0 ] && chown streetgen "$home" "$home/run"
  chmod -R a+rX "$stage"
  if ! [ -s "$home/data/PG_VERSION" ]; then
    # The socket is closed to other users of the machine; TCP, for QGIS, asks for the password.
    as_server sh -c "umask 077; od -An -N9 -tx1 /dev/urandom | tr -d ' \n' >'$home/password'"
    as_server "$(pg_bin)/initdb" -D "$home/data" -U gis --auth-local=trust --auth-host=scram-sha-256 --pwfile="$home/password" \
      -E UTF8 --locale=C.UTF-8 >"$build/initdb.log" 2>&1 ||
      { cat "$build/initdb.log" >&2; fail "initdb failed"; }
    as_server tee -a "$home/data/postgresql.conf" >/dev/null <<EOF
listen_addresses = '127.0.0.1'
port = $(free_port)
unix_socket_directories = '$home/run'
unix_socket_permissions = 0700
extension_destdir = '$stage'
dynamic_library_path = '$stage$(pg_config --pkglibdir):\$libdir'
shared_buffers = 256MB
work_mem = 64MB
maintenance_work_mem = 256MB
max_locks_per_transaction = 1024
max_wal_size = 2GB
jit = off
session_preload_libraries = 'postgis-3'
wal_level = minimal
max_wal_senders = 0
logging_collector = off
EOF
  fi
  running || as_server "$(pg_bin)/pg_ctl" -D "$home/data" -l "$home/log" -w start >/dev/null ||
    { tail -20 "$home/log" >&2; fail "the server did not start"; }
  PGHOST=$home/run
  PGPORT=$(sed -n 4p "$home/data/postmaster.pid")
  PGUSER=gis
  [ "${STREETGEN_SETUP:-default}" = default ] || PGUSER=streetgen_owner
  export PGHOST PGPORT PGUSER
}

# Whatever role the tests have: the superuser of the cluster.
as_administrator() { PGUSER=gis "$@"; }

# The cluster and the build; the system user goes with the last checkout that uses it.
remove_all() {
  local folder
  for folder in "$home" "$build"; do
    [ -d "$folder" ] || continue
    # STREETGEN_HOME and STREETGEN_BUILD may name any folder.
    [ -e "$folder/data/PG_VERSION" ] || [ -e "$folder/release/CMakeCache.txt" ] || [ -z "$(ls -A "$folder")" ] ||
      fail "$folder holds neither a cluster nor a build of ours: remove it by hand"
  done
  stop_cluster
  rm -rf "$home" "$build"
  [ "$(id -u)" = 0 ] || return 0
  rm -f "$sign_in/$checkout"
  if [ -n "$(find -L "$sign_in" -mindepth 1 -maxdepth 1 -type d -print -quit 2>/dev/null)" ] || pgrep -u streetgen >/dev/null 2>&1; then
    say "the system user streetgen stays: another checkout uses it"
    return 0
  fi
  rm -rf "$sign_in"
  if id streetgen >/dev/null 2>&1; then userdel streetgen; fi
}

stop_cluster() { if running; then as_server "$(pg_bin)/pg_ctl" -D "$home/data" -m fast -w stop >/dev/null; fi; }

# The mark of the SQL as built now: a database made by other SQL does not fit the module.
built_sql() { grep -oPh "(?<=SELECT ')[0-9a-f]{16}(?=')" "$stage$(pg_config --sharedir)"/extension/streetgen--*.sql; }

# empty_database NAME [TEMPLATE]
empty_database() {
  PGOPTIONS='-c client_min_messages=warning' as_administrator psql -qX -v ON_ERROR_STOP=1 -d postgres -c "DROP DATABASE IF EXISTS $1" -c "CREATE DATABASE $1 TEMPLATE ${2:-template1}"
}

# give_to_owner DATABASE: in the set-up owner a plain role owns the models there, and they compute all subjects.
give_to_owner() {
  case ${STREETGEN_SETUP:-default} in
    default) ;;
    owner) PGOPTIONS='-c client_min_messages=warning' as_administrator psql -qX -v ON_ERROR_STOP=1 -d "$1" -f "$root/tests/suite/owner.sql" ;;
    *) fail "STREETGEN_SETUP is $STREETGEN_SETUP, expected default or owner" ;;
  esac
}

# A database with the extension as built now: a copy of streetgen_template where the cluster has that. STREETGEN_SETUP says whose models it holds.
fresh_database() {
  local mark
  mark="streetgen $(built_sql)"
  if [ "$1" != streetgen_template ] &&
    [ "$(as_administrator psql -qXAt -d postgres -c "SELECT count(*) FROM pg_database WHERE datname = 'streetgen_template' AND shobj_description(oid, 'pg_database') = '$mark'")" = 1 ]; then
    empty_database "$1" streetgen_template
  else
    empty_database "$1"
  fi
  PGOPTIONS='-c client_min_messages=warning' as_administrator psql -qX -v ON_ERROR_STOP=1 -d "$1" -c 'CREATE EXTENSION IF NOT EXISTS streetgen CASCADE' \
    -c "COMMENT ON DATABASE $1 IS '$mark'"
  give_to_owner "$1"
}

set_up() {
  timed packages install_packages
  settle_home
  timed compiling build_extension
  timed cluster start_cluster
}
