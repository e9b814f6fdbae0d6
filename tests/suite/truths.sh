# Sourced by the suites: a folder to work in, and a row "t, f or s, name" for each truth that holds, fails or is skipped.
source "$(dirname "${BASH_SOURCE[0]}")/../../data/cluster.sh"
# Not the database that holds the models of whoever runs this.
export STREETGEN_DATABASE=streetgen_load
trap 'rm -rf "$work"' EXIT
work=$(mktemp -d)
chmod 755 "$work"

count() { printf '%s\t%s\n' "$1" "$2"; }
