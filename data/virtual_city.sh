# Invented networks: the commands virtual-city and two-towns of data/streetgen.

# take_invented ARGUMENT…: sets $seed, $srid, $corner, $options, $model, $replace, $files and, of two-towns, $driving_side and $seconds; $others is what else is given.
take_invented() {
  while [ $# -gt 0 ]; do
    case $1 in
      --replace) replace=yes ;;
      --*)
        [ $# -ge 2 ] || fail "option $1 needs a value"
        case $command$1 in
          *--seed) seed=$2 ;;
          *--srid) srid=$2 ;;
          *--corner) corner=$2 ;;
          *--options) options=$2 ;;
          *--model) model=$2 ;;
          *--export) files+=("$2") ;;
          two-towns--driving-side) driving_side=$2 ;;
          two-towns--seconds) seconds=$2 ;;
          *) fail "unknown option $1" ;;
        esac
        shift ;;
      *) others+=("$1") ;;
    esac
    shift
  done
  [[ $corner == *,* ]] || fail "corner \"$corner\": X,Y, such as 6560000,5570000"
  check_number 'X of the corner' "${corner%,*}"
  check_number 'Y of the corner' "${corner#*,}"
  [[ $seed =~ ^-?[0-9]+$ ]] || fail "seed \"$seed\" is no whole number"
  check_names "$model" "$srid"
}

# make_invented CALL: the model that a call of SQL makes, of psql's variables srid, x, y, seed and options.
make_invented() {
  set_up
  ready_database
  check_room "$model" "$replace"
  check_files ${files[@]+"${files[@]}"}
  run_sql -v srid="$srid" -v x="${corner%,*}" -v y="${corner#*,}" -v seed="$seed" -v options="$options" <<EOF
BEGIN;
SELECT FROM streetgen.model, streetgen.drop_model(name) WHERE name = '$model' \\g /dev/null
SELECT $1 \\g /dev/null
COMMIT;
EOF
}

# write_invented: the files that were asked for.
write_invented() {
  if [ ${#files[@]} != 0 ]; then
    write_files "$model" "${files[@]}"
    printf 'file       %s\n' "${files[@]}"
  fi
}

virtual_city() {
  local others=() seed=1 srid=2177 corner=6560000,5570000 options='{}' model=virtual_city replace= files=()
  take_invented "$@"
  case ${#others[@]} in
    0) others=(20 10) ;;
    2) ;;
    *) fail "a city of ${others[*]}: width and height in kilometres, such as 20 10" ;;
  esac
  check_number width "${others[0]}"
  check_number height "${others[1]}"
  make_invented "streetgen.create_virtual_city('$model', :'srid', :'x', :'y', 1000 * '${others[0]}'::float8, 1000 * '${others[1]}'::float8, :'seed', :'options')"
  finish "$model"
  write_invented
}

# drive MODEL SECONDS: cars stand on its lanes and drive, and a flow goes through them; kept as the runs cars and flow.
drive() {
  local model
  model=$(quoted "$1")
  run_sql -At -F ' rows of run ' -c "SET client_min_messages = error" -c "SELECT streetgen.create_traffic($model) WHERE to_regclass($model || '.car') IS NULL" -c "SELECT FROM streetgen.place_cars($model, 6)" \
    -c "SELECT streetgen.keep_simulation($model, 'cars', 'idm', $2, 0.1, '{\"flow\": 200}', options => '{\"output\": 0.5}'), 'cars'" \
    -c "SELECT streetgen.keep_simulation($model, 'flow', 'arz', $2, 0.1, '{\"flow\": 200}', options => '{\"output\": 5}'), 'flow'" | grep rows
}

# draw_traffic MODEL SECONDS EXTENT: frames of an extent, a picture of it that moves, and the densities of all at the end.
draw_traffic() {
  local frames=$build/$1_frames at
  rm -rf "$frames"
  mkdir -p "$frames"
  for ((at = 0; at <= $2; at += 10)); do
    take_picture "$frames/$(printf %04d "$at")" "$1" "$3" NULL false "'street'" NULL "'cars'" "$at"
  done
  run_sql -At -c "SELECT streetgen.animated_svg($(quoted "$1"), 'cars', $3)" >"$build/$1_moving.svg"
  take_picture "$build/$1_flow" "$1" NULL NULL true "'street'" NULL "'flow'" "$2"
  printf 'traffic    %s\n' "$frames" "$build/$1_moving.svg (a browser plays it)" "$build/$1_flow.png"
}

two_towns() {
  local others=() seed=1 srid=2154 corner=650000,6860000 options='{}' model=two_towns replace= files=() driving_side=right seconds=60 interchange
  take_invented "$@"
  want '' ${others[@]+"${others[@]}"}
  [[ $seconds =~ ^(0|[1-9][0-9]{0,3})$ ]] || fail "--seconds \"$seconds\" is no number of seconds up to 9999"
  make_invented "streetgen.create_two_towns('$model', :'srid', :'x', :'y', :'seed', jsonb_build_object('driving_side', $(quoted "$driving_side")) || :'options')"
  interchange="(SELECT ST_Expand(ST_Extent(geom)::geometry, 40) FROM $model.axis WHERE kind = 'motorway_link' AND starts_with(name, 'Weston '))"
  finish "$model" streets NULL interchange street "$interchange"
  if [ "$seconds" != 0 ]; then
    timed driving drive "$model" "$seconds"
    timed 'traffic drawn' draw_traffic "$model" "$seconds" "$interchange"
  fi
  write_invented
}
