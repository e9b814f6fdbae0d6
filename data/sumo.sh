# Sourced by data/streetgen: a network of SUMO, which netconvert makes of plain files, held against these.

install_sumo() { command -v netconvert >/dev/null || install_missing sumo python3; }

# write_sumo FILE MODEL: FILE.net.xml, and the plain files beside it where they shall be kept.
write_sumo() {
  local name=${1%.net.xml} model=$2 part ending side=() log=$build/netconvert.log list compared told=warning
  install_sumo
  # Each network has a list of its own, beside the log.
  list=$build/$(basename "$name").differences
  while read -r part ending; do
    told=$told write_lines "$name.$ending.xml" "streetgen.export_sumo($(quoted "$model"), '$part', $(quoted "$export_options"))"
    told=error
  done <<<$'nodes nod\nedges edg\nconnections con\ntypes typ\ntlLogics tll'
  [ "$(run_sql -At -c "SELECT value FROM streetgen.setting($(quoted "$model")) WHERE name = 'driving_side'")" != left ] || side=(--lefthand)
  # Nothing is to be made up: no turning back, no other origin, no bends made rounder.
  SUMO_HOME=${SUMO_HOME:-/usr/share/sumo} netconvert --node-files "$name.nod.xml" --edge-files "$name.edg.xml" --connection-files "$name.con.xml" \
    --type-files "$name.typ.xml" --tllogic-files "$name.tll.xml" --output-file "$name.made.xml" --no-turnarounds --walkingareas --offset.disable-normalization --geometry.min-radius 0 --tls.ignore-internal-junction-jam \
    ${side[@]+"${side[@]}"} >"$log" 2>&1 ||
    fail "netconvert made no network of $(basename "$1"): $(grep -m 1 '^Error' "$log" || tail -n 1 "$log"); $log says more"
  python3 -B "$root/data/sumo/finish.py" "$name" "$name.made.xml" >"$1" 2>"$log" ||
    fail "the right of way in $(basename "$1") cannot be told: $(tail -n 1 "$log"); $log says more"
  rm "$name.made.xml"
  compared=$(python3 -B "$root/data/sumo/hold.py" "$name" "$sumo_tolerance" 2>&1 >"$list") || {
    head -n 20 "$list" >&2
    say "$compared"
    fail "$(basename "$1") is not the model, but for --tolerance $sumo_tolerance: $(wc -l <"$list") differences, listed in $list"
  }
  say "$(basename "$1"): $compared$([ ! -s "$list" ] || echo ", listed in $list")"
  ! grep -q '^crossing lost' "$list" || say "where a crossing is lost netconvert finds no sidewalk to come from"
  [ -n "$keep_plain" ] || rm "$name".{nod,edg,con,typ,tll}.xml
}

# write_sumo_configuration FILE MODEL: FILE.sumocfg, and beside it the network and the additional file that it names.
write_sumo_configuration() {
  local name=${1%.sumocfg} stem
  stem=$(basename "$name")
  write_sumo "$name.net.xml" "$2"
  told=error write_lines "$name.add.xml" "streetgen.export_sumo($(quoted "$2"), 'additional', $(quoted "$export_options"))"
  cat >"$1" <<EOF
<?xml version="1.0" encoding="UTF-8"?>
<configuration xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="http://sumo.dlr.de/xsd/sumoConfiguration.xsd">
    <input>
        <net-file value="$stem.net.xml"/>
        <additional-files value="$stem.add.xml"/>
    </input>
</configuration>
EOF
}
