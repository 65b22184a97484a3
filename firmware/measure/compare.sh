# The tables of today and those that are committed: part of measure.sh.

# What every compiler makes the same.
declare -A same=(
    [rp2040.csv]=scene,method,opt_level,strip_rows,triangles,pixels,crc
    [cortex-m4.csv]=scene,method,opt_level,strip_rows,triangles,pixels,crc
    [riscv.csv]=scene,method,opt_level,strip_rows,triangles,pixels,crc
    [flash.csv]=core,opt_level,draws
    [panel.csv]=panel,image,scene,left_out,crc
    [turn.csv]=panel,image,scene,frames
    [ram.csv]=panel,image,strip_rows,strips,depths,list,tables
)

# Some columns of a table, by their names.
columns() {
    grep -v '^#' "$2" | awk -F, -v OFS=, -v wanted="$1" '
        NR == 1 { count = split(wanted, names); for (i = 1; i <= NF; i++) place[$i] = i }
        { line = $place[names[1]]; for (i = 2; i <= count; i++) line = line OFS $place[names[i]]; print line }'
}

compare_tables() {
    local failed=0 name committed here
    for name in "${!same[@]}"; do
        [ -f "$work/tables/$name" ] || continue
        [ -f "$tables/$name" ] || { echo "docs/measured/$name is missing: run firmware/measure.sh" >&2 && exit 1; }
        committed=$(head -n 1 "$tables/$name")
        here=$(head -n 1 "$work/tables/$name")
        if [ "$committed" = "$here" ]; then
            diff "$tables/$name" "$work/tables/$name" || failed=1
        else
            echo "docs/measured/$name was made with ${committed#\# }, and this is ${here#\# }: comparing what does not depend on it"
            diff <(columns "${same[$name]}" "$tables/$name") <(columns "${same[$name]}" "$work/tables/$name") || failed=1
        fi
    done
    if [ $failed = 1 ]; then
        echo "docs/measured differs from what is measured here: run firmware/measure.sh" >&2
        exit 1
    fi
    echo "$(ls "$work/tables" | wc -l) tables, as committed" >&2
}
