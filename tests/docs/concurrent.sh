#!/bin/sh
# concurrent.sh PROGRAM EXAMPLES FOLDER [ROUNDS]: of runs that write the same files at the same time some end with all of theirs,
# each after the other, and the rest end with 2 and say why.
set -u
program=$1 examples=$2 folder=$3 rounds=${4:-3}
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1
failures=0
wrong() {
    echo "$*"
    failures=$((failures + 1))
}
plot='--plot a.svg'
command -v gnuplot > /dev/null 2>&1 || plot=''

# Four scenes of either kind, solved alone: the sets of files that may be there in the end.
for one in 1 2 3 4; do
    sed "s/youngs_modulus = [0-9.e]*/youngs_modulus = $one.5e4/" "$examples/cantilever.toml" > "single$one.toml"
    sed "s/youngs_modulus = [0-9.e]*/youngs_modulus = ${one}500/" "$examples/to_and_fro.toml" > "path$one.toml"
done
run() { # kind, which, folder: all files of one run
    options="--csv a.csv --vtu a.vtu $plot"
    [ "$1" = single ] || options="$options --state a.state"
    # shellcheck disable=SC2086
    (cd "$3" && exec "$program" solve "$folder/$1$2.toml" $options > /dev/null 2> "$folder/said.$2")
}
for kind in single path; do
    for one in 1 2 3 4; do
        mkdir "alone.$kind$one"
        run "$kind" "$one" "alone.$kind$one" || wrong "$kind$one: status $? alone, said: $(cat "said.$one")"
        [ "$one" -eq 1 ] || ! cmp -s "alone.${kind}1/a.csv" "alone.$kind$one/a.csv" || wrong "$kind$one is no run of its own"
    done
done

together() { # kind: all four into one folder
    for one in 1 2 3 4; do
        (run "$1" "$one" into; echo $? > "status.$one") &
    done
    wait
    whole=''
    for one in 1 2 3 4; do
        status=$(cat "status.$one")
        if [ "$status" -eq 0 ]; then
            ! diff -r "alone.$1$one" into > /dev/null || whole=$one
        elif [ "$status" -ne 2 ] || ! grep -Eq "^signorini: cannot write 'a\.[a-z]+': another run is writing it\. Let" "said.$one"; then
            wrong "$1$one: status $status beside others, said: $(cat "said.$one")"
        fi
    done
    [ -n "$whole" ] || wrong "$1: status $(cat status.[1-4] | tr '\n' ' '), and no run left its files, all and no others: $(ls -A into)"
}
mkdir into
for round in $(seq "$rounds"); do
    together single
    [ $((round % 2)) -eq 0 ] || rm -rf into/* into/.[!.]* # there is something to replace every second time
done
rm -rf into
mkdir into
for round in $(seq "$rounds"); do
    together path
    [ $((round % 2)) -eq 0 ] || rm -rf into/* into/.[!.]*
done

# A run that is killed stops nobody, with what it leaves behind: locks, and perhaps the draft that it was writing.
rm -rf into
mkdir into
(cd into && exec "$program" solve "$folder/path1.toml" --vtu a.vtu --csv a.csv --state a.state > /dev/null) &
killed=$!
tries=0
until [ -e into/a.state ] || [ "$tries" -eq 1000 ]; do
    sleep 0.01
    tries=$((tries + 1))
done
kill -9 "$killed"
wait "$killed" 2> /dev/null
: > into/.a.csv.lock # as it is if the kill came late
run path 1 into || wrong "after a killed run: $(cat said.1)"
diff -r -x '*.draft[0-9]*' alone.path1 into > killed || wrong "after a killed run: $(cat killed)"

# What stands in the place of a lock is kept.
echo mine > into/mine
ln -s mine into/.a.csv.lock
run path 1 into
[ "$?" -eq 2 ] || wrong 'a lock that is a link was taken'
grep -q "^signorini: cannot write 'a.csv': its lock '.a.csv.lock' cannot be opened (.*); remove that if" said.1 ||
    wrong "a link in the place of a lock, said: $(cat said.1)"
grep -qx mine into/mine || wrong 'a file behind a lock was changed'
[ "$failures" -eq 0 ] || exit 1
cd / && rm -rf "$folder"
