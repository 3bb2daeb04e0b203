#!/bin/sh
# words.sh ROOT FOLDER: glossary, index and the minutes of the course are checked.  In a copy of the texts in FOLDER, plants a fault after the other and
# expects a complaint each time.
set -u
root=$1 copy=$2
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && tar cf - --exclude=results --exclude='*.cpp' chapters tools) | tar xf - -C "$copy"
cd "$copy" || exit 1
checks='perl tools/words.pl --check && perl tools/course.pl --check'
eval "$checks" || exit 1
failures=0

fault() { # what, sed script, file, part of the complaint
    cp "$3" kept
    sed -i "$2" "$3"
    said=$(eval "$checks" 2>&1)
    case $? in
    0) echo "words.sh: nobody misses: $1"; failures=1 ;;
    *) printf '%s\n' "$said" | grep -qF "$4" || { echo "words.sh: $1: expected '$4', got: $said"; failures=1; } ;;
    esac
    cp kept "$3"
}

glossary=chapters/glossary.md
fault "a word without meaning" 's/^| cantilever | \(.*\) | .*|$/| cantilever | \1 | |/' $glossary "cantilever: no meaning"
fault "a word out of order" 's/^| gap |/| zap |/' $glossary "comes before zap"
fault "a word that stands twice" 's/^| gap |.*/&\n&/' $glossary "gap: stands twice"
fault "a Chinese word without source" '/^| cantilever /s/ (1)//' $glossary "cantilever: give (1)"
fault "a section that is called otherwise" 's/^## The saddle point$/## The saddle/' "$(echo chapters/ch02_*/README.md)" "type make text"
fault "an exercise that takes longer" 's/\([0-9]*\) minutes/1\1 minutes/' "$(echo chapters/ch15_*/exercises/ex1_*/README.md)" "minutes of the course"
printf 'words of neither\n' > paper.txt
perl tools/words.pl --check . paper.txt paper.txt 2>&1 | grep -q "cantilever: '.*' is not in paper 1" || { echo "words.sh: a word that is not in the paper is accepted"; failures=1; }
[ "$failures" -eq 0 ] || exit 1
cd / && rm -rf "$copy"
