#!/bin/sh
# evenings.sh ROOT FOLDER: the sources of the library are checked as pages to read. In a copy of the texts in FOLDER, plants a fault
# after the other and expects a complaint each time; then looks at what one page says.
set -u
root=$1 copy=$2
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && tar cf - --exclude=results --exclude='*.svg' --exclude='*.csv' --exclude='*.msh' --exclude=data chapters docs src tests tools) |
    tar xf - -C "$copy"
cd "$copy" || exit 1
perl tools/evenings.pl --check || exit 1
failures=0

fault() { # what, sed script, file, part of the complaint
    cp "$3" kept
    sed -i "$2" "$3"
    if cmp -s "$3" kept; then
        echo "evenings.sh: $1: nothing to change in $3"
        failures=1
    fi
    said=$(perl tools/evenings.pl --check 2>&1)
    case $? in
    0) echo "evenings.sh: nobody misses: $1"; failures=1 ;;
    *) printf '%s\n' "$said" | grep -qF "$4" || { echo "evenings.sh: $1: expected '$4', got: $said"; failures=1; } ;;
    esac
    cp kept "$3"
}

list=src/evenings
errors=src/signorini/core/errors.hpp
fault "a file on no evening" '/^signorini\/core\/errors$/d' $list "signorini/core/errors.hpp stands on no evening"
fault "a file on two evenings" 's/^papers\/examples$/&\nsignorini\/core\/errors/' $list "signorini/core/errors.hpp stands twice"
fault "an entry without file" 's/^papers\/examples$/&\npapers\/nothing/' $list "there is no papers/nothing.hpp and no papers/nothing.cpp"
fault "a line that is none of these" 's/^papers\/examples$/&,/' $list "expected an evening, a name or a debt, got: papers/examples,"
fault "a header that comes too late" '/^signorini\/core\/errors$/d; s/^papers\/examples$/&\nsignorini\/core\/errors/' $list \
    "core/family.hpp includes signorini/core/errors.hpp, which comes later"
fault "a debt that is paid" '$s/$/\nstill short: signorini\/core\/errors.hpp/' $list "this debt is paid, take it out: still short: signorini/core/errors.hpp"
fault "a debt that is too long ago" '$s/$/\nstill long: signorini\/core\/nothing.hpp/' $list "this debt is paid"
fault "a file of 251 lines" "\$s/\$/$(printf '\\n\/\/ line%.0s' $(seq $((251 - $(wc -l < $errors)))))/" $errors "$errors: 251 lines"
fault "a file without comments" 's/^ *\/\/.*//' $errors "$errors: fewer comments than one line of 4"
fault "a link that leads nowhere" '1s/^/\/\/ See [this](nowhere.hpp).\n/' $errors "$errors: there is no nowhere.hpp"
fault "an equation that does not exist" '1s/^/\/\/ \\PaperEq{XuanLi2002, 40}\n/' $errors "$errors: no chapter explains equation (40) of XuanLi2002"

# A function leads to its contract, its test, the chapters that use it and its equation; an overlong file is shown all the same.
perl tools/evenings.pl . pages || exit 1
[ "$(find pages -name '*pp.md' | wc -l)" -eq "$(find src/signorini src/papers -name '*.[ch]pp' | wc -l)" ] || { echo "evenings.sh: not a page for every file"; failures=1; }
page=pages/src+papers+surrogate_dual.cpp.md
for part in '[`surrogate_dual_value()`](../../src/papers/surrogate_dual.hpp) · [test_surrogate_dual.cpp](../../tests/papers/test_surrogate_dual.cpp)' \
    ' · chapters [2](../../chapters/ch02_surrogate_dual/README.md), [3](../../chapters/ch03_simplex_updates/README.md)' '\PaperEq{XuanLi2002, 24}<br>'; do
    grep surrogate_dual_value $page | grep -qF -- "$part" || { echo "evenings.sh: surrogate_dual_value() does not lead to: $part"; failures=1; }
done

grep -qF '[`Ledger::Phase`](../../../src/signorini/core/ledger.hpp)' pages/src+signorini+core+ledger.cpp.md || { echo "evenings.sh: a constructor does not lead to its class"; failures=1; }
grep -qF '[`Ledger::count()`]' pages/src+signorini+core+ledger.cpp.md || { echo "evenings.sh: a member that follows a class within the class leads nowhere"; failures=1; }
grep -qF 'part of [`Ledger`]' pages/src+signorini+core+ledger.cpp.md || { echo "evenings.sh: a private function does not lead to its class"; failures=1; }

# Paragraphs and indented lines stay what they are.
printf '// one\n//\n//     two\n' >> $errors
perl tools/evenings.pl . pages || exit 1
perl -0ne 'exit !/^one\n\n    two\n/m' pages/src+signorini+core+errors.hpp.md || { echo "evenings.sh: paragraphs are lost"; failures=1; }

# Numbers of lines are those of the file, and nothing of it is lost.
perl -e '
    my ($page, $file) = map { local $/; open my $in, "<", $_ or die "$_: $!"; <$in> } @ARGV;
    my @line = split /\n/, $file;
    my %shown;
    while ($page =~ /counter-reset: line (\d+)">\\endhtmlonly\n```cpp\n(.*?)^```$/msg) {
        my ($n, $code) = ($1, $2);
        for (split /\n/, $code) { $line[$n] eq $_ or die "line " . ($n + 1) . " is not: $_\n"; $shown{$n++} = 1 }
    }
    my @lost = grep { $line[$_] =~ /\S/ && $line[$_] !~ m{^//} && !$shown{$_} } 0 .. $#line;
    die "lines that are lost: @lost\n" if @lost;
' $page src/papers/surrogate_dual.cpp || { echo "evenings.sh: $page is not its file"; failures=1; }
[ "$failures" -eq 0 ] || exit 1
cd / && rm -rf "$copy"
