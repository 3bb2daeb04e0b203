#!/bin/sh
# chapter_errors.sh PROGRAM FOLDER: a chapter's program answers bad input with status 2 and one message that
# names the program; asked for help it succeeds.  FOLDER is a place to play in.
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
expect 2 'no-such-option' --no-such-option
expect 2 'file/below' --out "$folder/file/below"  # no permission helps here, not even root's
expect 2 'out' --out
expect 0 '' --help
grep -q -e '--out' "$folder/out" || { echo "--help does not tell of --out"; bad=1; }
exit $bad
