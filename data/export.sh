# Sourced by data/streetgen: layers of a model as files for a GIS, by ogr2ogr, its mesh, and networks for simulators.

# Options --plain, --options and --tolerance set these.
keep_plain= export_options='{}' sumo_tolerance=1

# The layer that a file is named after: roads of roads.shp and of town_roads.shp.
layer_of() {
  local stem layer
  stem=$(basename "${1%.*}")
  for layer in "${layers[@]}"; do
    if [[ $stem = "$layer" || $stem = *[_-]"$layer" ]]; then
      printf %s "$layer"
    fi
  done
}

# A shapefile is several files, and so is a network of SUMO with the plain files that it was made of, and what a configuration names.
parts_of() {
  case $1 in
    *.shp) printf '%s\n' "${1%.shp}".{shp,shx,dbf,prj,cpg} ;;
    *.net.xml)
      printf '%s\n' "$1"
      [ -z "$keep_plain" ] || printf '%s\n' "${1%.net.xml}".{nod,edg,con,typ,tll}.xml ;;
    *.sumocfg)
      printf '%s\n' "$1" "${1%.sumocfg}.add.xml"
      parts_of "${1%.sumocfg}.net.xml" ;;
    *.obj) printf '%s\n' "$1" "${1%.obj}.mtl" ;;
    *) printf '%s\n' "$1" ;;
  esac
}

# check_files FILE…: the ending of each, its layer, its folder, that it takes options, and that nothing of that name is there.
check_files() {
  local file folder part seen=$'\n'
  mapfile -t layers < <(run_sql -At -c "SELECT layer FROM streetgen._export_layer() ORDER BY turn")
  for file in "$@"; do
    case $file in
      *.gpkg | *.obj | *.city.json | *.glb | *.tiles | *.dxf | *.net.xml | *.sumocfg | *.symuvia.xml | *.xodr | *.lanelet2.osm | *.opensidewalks.geojson) ;;
      *.shp | *.geojson) [ -n "$(layer_of "$file")" ] || fail "$file would hold one layer: name it after that, as roads.${file##*.} or town_axes.${file##*.} ($(printf '%s, ' "${layers[@]}" | sed 's:, $::'))" ;;
      *) fail "$file has an unknown ending: .gpkg holds all layers, .shp and .geojson one each, .obj, .city.json, .glb and the folder .tiles the streets in three dimensions, .dxf a drawing for CAD, .net.xml, .symuvia.xml, .xodr and .lanelet2.osm a network for simulators, .sumocfg that of SUMO with its bus stops and parking areas, .opensidewalks.geojson the network on foot" ;;
    esac
    case $file in
      *.opensidewalks.geojson) ;;
      *.gpkg | *.shp | *.geojson) [ "$export_options" = '{}' ] || fail "$file takes no options: it holds whole layers. Files of other endings take them" ;;
    esac
    folder=$(dirname "$file")
    [ -d "$folder" ] || fail "$file cannot be written: there is no folder $folder"
    [ -w "$folder" ] || fail "$file cannot be written: folder $folder is closed"
    while IFS= read -r part; do
      [ ! -e "$part" ] || fail "$part is there: remove it or choose another name"
      [[ $seen != *$'\n'$part$'\n'* ]] || fail "$file is named twice"
      seen+=$part$'\n'
    done < <(parts_of "$file")
  done
}

# write_layer FILE MODEL LAYER WGS84 OPTION…: a remark of ogr2ogr is an error, since so it says that it cut a name or a value.
# ogr2ogr does not say of GeoJSON that a disk is full, cat does.
write_layer() {
  local file=$1 model=$2 layer=$3 wgs84=$4 made=$1 shown=/dev/null type query remark
  shift 4
  [[ $file != *.geojson ]] || made=/vsistdout/ shown=$file
  IFS=$'\t' read -r type query < <(run_sql -At -F $'\t' -c "SELECT geometry_type, query FROM streetgen.export_layer($(quoted "$model"), $wgs84) WHERE layer = '$layer'") ||
    fail "model $model has no layer $layer: it does not compute that subject (SELECT * FROM streetgen.subject($(quoted "$model")))"
  remark=$({ ogr2ogr -q "$@" -nln "$layer" -nlt "$type" "$made" "PG:host=$PGHOST port=$PGPORT user=$PGUSER dbname=$database options='-c jit=off'" -sql "$query" | cat >"$shown"; } 2>&1) && [ -z "$remark" ] ||
    fail "layer $layer cannot be written to $(basename "$file"): $(head -n 1 <<<"$remark")"
}

# write_lines FILE CALL: what a writer gives, which is in the order of the file. psql does not say that a disk is full, cat does.
write_lines() {
  PGOPTIONS="-c client_min_messages=${told:-warning}" psql -qXAt -v ON_ERROR_STOP=1 -v SHOW_CONTEXT=never -v FETCH_COUNT=5000 -d "$database" \
    -c "SELECT line FROM $2" | cat >"$1" || fail "$(basename "$1") cannot be written"
}

# write_parts FILE CALL: the same of a file of bytes.
write_parts() {
  PGOPTIONS="-c client_min_messages=${told:-warning}" psql -qXAt -v ON_ERROR_STOP=1 -v SHOW_CONTEXT=never -v FETCH_COUNT=4 -d "$database" \
    -c "SELECT upper(encode(part, 'hex')) FROM $2" | basenc --base16 -d >"$1" || fail "$(basename "$1") cannot be written"
}

# write_wavefront FILE MODEL: the objects, which name the file of their materials.
write_wavefront() {
  write_lines "$1" "(SELECT $(quoted "mtllib $(basename "${1%.obj}").mtl") AS line UNION ALL (SELECT line FROM streetgen.export_wavefront($(quoted "$2"), 'objects', $(quoted "$export_options")))) f"
  told=error write_lines "${1%.obj}.mtl" "streetgen.export_wavefront($(quoted "$2"), 'materials', $(quoted "$export_options"))"
}

# write_tiles FOLDER MODEL: the files of the folder, each in parts that follow each other.
write_tiles() {
  mkdir "$1"
  PGOPTIONS="-c client_min_messages=${told:-warning}" psql -qXAt -F ' ' -v ON_ERROR_STOP=1 -v SHOW_CONTEXT=never -v FETCH_COUNT=4 -d "$database" \
    -c "SELECT path, upper(encode(part, 'hex')) FROM streetgen.export_tiles($(quoted "$2"), $(quoted "$export_options"))" |
    TILES=$1 awk '$1 != path { if (path) close(command); path = $1; command = "basenc --base16 -d >\"$TILES/" path "\"" } { print $2 | command } END { if (path && close(command)) exit 1 }' ||
    fail "$(basename "$1") cannot be written"
}

# write_file FILE MODEL LAYER SRID
write_file() {
  local file=$1 model=$2 layer=$3 srid=$4 of_model update=()
  case $file in
    *.gpkg)
      mapfile -t of_model < <(run_sql -At -c "SELECT layer FROM streetgen.export_layer($(quoted "$model"))")
      for layer in "${of_model[@]}"; do
        write_layer "$file" "$model" "$layer" false -f GPKG -a_srs "EPSG:$srid" -lco GEOMETRY_NAME=geom ${update[@]+"${update[@]}"}
        update=(-update)
      done ;;
    *.shp) write_layer "$file" "$model" "$layer" false -f 'ESRI Shapefile' -a_srs "EPSG:$srid" -lco ENCODING=UTF-8 -lco RESIZE=YES ;;
    *.obj) write_wavefront "$file" "$model" ;;
    *.net.xml) write_sumo "$file" "$model" ;;
    *.sumocfg) write_sumo_configuration "$file" "$model" ;;
    *.city.json) write_lines "$file" "streetgen.export_cityjson($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.dxf) write_lines "$file" "streetgen.export_dxf($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.tiles) write_tiles "$file" "$model" ;;
    *.glb) write_parts "$file" "streetgen.export_gltf($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.symuvia.xml) write_lines "$file" "streetgen.export_symuvia($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.lanelet2.osm) write_lines "$file" "streetgen.export_lanelet2($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.xodr) write_lines "$file" "streetgen.export_opendrive($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.opensidewalks.geojson) write_lines "$file" "streetgen.export_opensidewalks($(quoted "$model"), $(quoted "$export_options"))" ;;
    *.geojson) write_layer "$file" "$model" "$layer" true -f GeoJSON -a_srs EPSG:4326 -lco RFC7946=YES -lco COORDINATE_PRECISION=11 ;;
  esac
}

# write_files MODEL FILE…: files that check_files let pass, all of them or none.
write_files() {
  local model=$1 srid file folder
  shift
  srid=$(run_sql -At -c "SELECT srid FROM streetgen.model WHERE name = $(quoted "$model")")
  export_folders=()
  trap 'rm -rf "${export_folders[@]}"' EXIT
  for file in "$@"; do
    # Beside its place, so that it gets there at once.
    folder=$(mktemp -d "$(dirname "$file")/.streetgen.XXXXXX")
    export_folders+=("$folder")
    write_file "$folder/$(basename "$file")" "$model" "$(layer_of "$file")" "$srid"
  done
  for folder in "${export_folders[@]}"; do
    mv -n "$folder"/* "$(dirname "$folder")"
  done
}
