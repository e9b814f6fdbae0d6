# Sourced by data/streetgen: a file of OpenStreetMap, as an extract, the API or an editor writes it, as the tables of data/osm2pgsql_flex.lua.

# osm_format FILE: how osmium calls it, by its ending; 1 for other files. XML of other things is none.
osm_format() {
  case ${1,,} in
    *.pbf) echo osm.pbf ;;
    *.osm.gz) echo osm.gz ;;
    *.osm.bz2) echo osm.bz2 ;;
    *.osm) echo osm ;;
    *.xml | *.xml.gz | *.xml.bz2)
      [ "$(root_element "$1")" = osm ] || return 1
      [[ ${1,,} =~ \.xml(\.[a-z0-9]*)?$ ]]
      echo "osm${BASH_REMATCH[1]}" ;;
    *) return 1 ;;
  esac
}

# osm_text FILE: its XML.
osm_text() {
  case ${1,,} in
    *.gz) gunzip -c "$1" ;;
    *.bz2) bunzip2 -c "$1" ;;
    *) cat "$1" ;;
  esac
}

# root_element FILE: the name of the first element of its XML, after what is said and remarked before it; nothing where it is none.
root_element() {
  { osm_text "$1" 2>/dev/null || true; } | head -c 20000 | tr -d '\0' | tr '\n\r\t' '   ' | sed -E 's/<!--([^-]|-[^-])*-->//g' | grep -oE '<[A-Za-z_][^ />]*' | head -1 | cut -c2- || true
}

# An editor keeps what was deleted in it and is not uploaded yet, marked by an attribute that osmium does not know.
deleted="action=['\"]delete['\"]"
mark_deleted() { sed -E "/<(node|way|relation) [^>]*$deleted/{s/ visible=['\"][^'\"]*['\"]//;s/$deleted/visible='false'/}"; }

# settle_osm: $read becomes a file as osm2pgsql takes it: each object once, by its id, which is above zero. $ids is the folder of the new ids where
# ids became new. What was done is told in one line.
settle_osm() {
  local said plain=pbf,pbf_compression=none did=
  said=$(osmium fileinfo -e "$read" 2>"$work/osmium.log") || fail "$file is no file of OpenStreetMap: $(tail -1 "$work/osmium.log")"
  if [[ $read != *.pbf ]] && osm_text "$read" | grep "$deleted" >/dev/null; then
    osm_text "$read" | mark_deleted >"$work/marked.osm"
    read=$work/marked.osm did=', without what its editor deleted'
  fi
  if [ -n "$did" ] || grep -qE '^ *(Objects ordered.*: no|Multiple versions.*: yes)' <<<"$said"; then
    osmium sort --no-progress -f "$plain,history=true" -o "$work/sorted.osm.pbf" "$read"
    osmium time-filter --no-progress -f "$plain" -o "$work/latest.osm.pbf" "$work/sorted.osm.pbf"
    read=$work/latest.osm.pbf did=" sorted$did"
  fi
  if grep -qE '^ *Smallest (node|way|relation) ID: -' <<<"$said"; then
    ids=$work/ids
    mkdir "$ids"
    osmium renumber --no-progress -i "$ids" -f "$plain" -o "$work/renumbered.osm.pbf" "$read"
    read=$work/renumbered.osm.pbf did+="${did:+, and} renumbered for osm2pgsql, while axes keep the ids of the file"
  fi
  [ -z "$did" ] || say "$(basename "$file") is read$did"
}

# read_osm FILE SRID TABLE_PREFIX TABLES: through the folder $work of the caller.
read_osm() {
  local file=$1 srid=$2 prefix=$3 tables=$4 read ids= type
  # osm2pgsql goes by the ending too.
  read=$work/read.$(osm_format "$file")
  ln -s "$(realpath "$file")" "$read"
  settle_osm
  STREETGEN_PREFIX=$prefix STREETGEN_SRID=$srid osm2pgsql -d "$database" -O flex -S "$root/data/osm2pgsql_flex.lua" --log-level=warn "$read" >"$work/osm2pgsql.log" 2>&1 ||
    { tail -3 "$work/osm2pgsql.log" >&2; run_sql -c "DROP TABLE IF EXISTS $tables"; fail "osm2pgsql cannot read $file in SRID $srid"; }
  [ -z "$ids" ] || for type in node way relation; do osmium renumber -i "$ids" --show-index "$type" | sed "s/^/$type /"; done |
    run_sql -1 -v tables="$tables" -f "$root/data/own_ids.sql"
}
