#!/bin/sh
# chapter_errors.sh PROGRAM FOLDER [whole]: a chapter's program answers bad input, and a disk that is full, with
# status 2 and one message that names the program; asked for help it succeeds.  FOLDER is a place to play in.
# `whole` lets it also compute all and then find the disk full: for a quick one, since all have the same frame.
set -u
rm -rf "$2"
mkdir -p "$2"
bad=0

expect() { # status, words that the message must contain, arguments of the program
    wanted=$1 words=$2
    shift 2
    said=$("$program" "$@" 2>&1 > "$folder/out")
    status=$?
    if [ "$status" -ne "$wanted" ] || ! printf '%s\n' "$said" | grep -q -e "$words"; then
        echo "$(basename "$program") $*: status $status instead of $wanted, or no '$words' in: $said"
        bad=1
    fi
}

program=$1 folder=$2
: > "$folder/file"
expect 0 '' --quick --help
cp "$folder/out" "$folder/list"
for word in --out --full --quick PROGRAM; do
    grep -q -e "$word" "$folder/list" || { echo "--help does not tell of $word"; bad=1; }
done
expect 2 'no-such-option' --no-such-option
expect 2 'file/below' --out "$folder/file/below"  # no permission helps here, not even root's
expect 2 'out needs a folder' --out
expect 2 'out needs a folder' --out --help
first=$(sed -n 's/.*these options: runs \([a-z0-9_]*\).*/\1/p' "$folder/list")
for misspelt in "${first}x" "--quick ${first}x" "--help ${first}x"; do
    expect 2 "no program '${first}x'; did you mean '$first'" $misspelt
done

complains() { # status, what it said, what was done
    if [ "$1" -ne 2 ] || [ "$(printf '%s\n' "$2" | grep -c '')" -ne 1 ] || ! printf '%s\n' "$2" | grep -q 'cannot write'; then
        echo "$(basename "$program") $3: status $1 instead of 2, or not one line with 'cannot write': $2"
        bad=1
    fi
    [ -z "$(ls -A "$folder/lost" 2> /dev/null)" ] || { echo "$(basename "$program") $3: leaves files behind"; bad=1; }
}
if [ -c /dev/full ]; then
    said=$("$program" --help 2>&1 > /dev/full)
    complains $? "$said" "--help > /dev/full"
fi
[ "${3:-}" = whole ] || exit $bad
if [ -c /dev/full ]; then
    said=$("$program" --out "$folder/lost" 2>&1 > /dev/full)
    complains $? "$said" "> /dev/full"
fi
# A limit of 0 bytes for files is a full disk: a file can be made, nothing fits into it.
said=$(trap '' XFSZ; ulimit -f 0; "$program" --out "$folder/lost" 2>&1 > /dev/null)
complains $? "$said" "with a full disk"
exit $bad
