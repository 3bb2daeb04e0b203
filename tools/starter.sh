#!/bin/sh
# starter.sh PROGRAM: succeeds if the tests of an exercise fail on its starter in the wanted way, by a
# failed check that Catch2 reports.  A starter that passes, crashes or does not run is refused.
set -u
said=$("$1" 2>&1)
status=$?
printf '%s\n' "$said"
if [ "$status" -eq 0 ]; then
    echo "The tests pass: attempt.cpp is no starter.  If it is your own answer, well done; 'git stash' brings"
    echo "the starter back, and 'make exN.K' is the command that checks answers."
    exit 1
fi
case $said in *"fatal error condition"*) echo "The starter crashes, it should fail a check." ; exit 1 ;; esac
if printf '%s\n' "$said" | grep -q '^assertions:.*[1-9][0-9]* failed'; then
    echo "The starter fails as it should."
    exit 0
fi
echo "The starter ends with status $status without a failed check."
exit 1
