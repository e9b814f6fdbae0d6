# Sourced by the suites: a folder to work in, and a row "t, f or s, name" for each truth that holds, fails or is skipped.
source "$(dirname "${BASH_SOURCE[0]}")/../../data/cluster.sh"
# Not the database that holds the models of whoever runs this.
export STREETGEN_DATABASE=streetgen_load
trap 'rm -rf "$work"' EXIT
work=$(mktemp -d)
chmod 755 "$work"

# count STATUS NAME: what answers neither t, f nor s has failed.
count() {
  case $1 in
    t | f | s) printf '%s\t%s\n' "$1" "$2" ;;
    *) printf 'f\t%s: no answer\n' "$2" ;;
  esac
}
