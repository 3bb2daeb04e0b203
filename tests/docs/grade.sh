#!/bin/sh
# grade.sh ROOT BUILD FOLDER: tools/grade.pl gives every answer its row: right ones, wrong ones, and those that hang, crash, cheat or
# are no answers, none of which harms another.  The answers are made in FOLDER from the solutions of exercises 2.2 and 3.1.
set -u
root=$1 build=$2 play=$3
rm -rf "$play"
mkdir -p "$play/answers"
play=$(cd "$play" && pwd)
cd "$play/answers" || exit 1
bad=0
second=$root/chapters/ch02_surrogate_dual/exercises/ex2_positive_part
third=$root/chapters/ch03_simplex_updates/exercises/ex1_line_search
: > ../expected

row() { # student, exercise, status, test cases passed: public and held out, a part of the message
    printf '%s,%s,%s,%s,%s\t%s\n' "$1" "$2" "$3" "$4" "$5" "${6:-}" >> ../expected
}
student() { # the arguments of row; reads the answer
    mkdir -p "$1"
    cat > "$1/$2.cpp"
    row "$@"
}
step() { # the arguments of row after the exercise, what stands before the function, its body
    {
        printf '#include "exercise.hpp"\n%s\nnamespace ex3_1 {\n' "$6"
        printf 'double best_step(const Line& line, double largest) {\n%s\n}\n}\n' "$7"
    } | student "$1" ex3.1 "$2" "$3" "$4" "$5"
}
cheat() { # the same: a right answer, and more
    { cat "$third/solution.cpp"; printf '%s\n' "$6"; } | student "$1" ex3.1 "$2" "$3" "$4" "$5"
}

# right
student right ex3.1 passed 6 3 < "$third/solution.cpp"
student right ex2.2 passed 3 2 < "$second/solution.cpp"
cheat helpers passed 6 3 '' '#include <vector>
#include <functional>
#include <stdexcept>
struct Mine : std::runtime_error { using std::runtime_error::runtime_error; virtual double f() { return 1; } };
double helper(double x) { std::vector<std::function<double()>> all{[x] { return x; }}; return all.back()(); }
double use(Mine& mine) { return helper(mine.f()); }'
mkdir -p 'Zoë, "Z" & <co>/ex3.1'
cp "$third"/* 'Zoë, "Z" & <co>/ex3.1'
cp "$third/solution.cpp" 'Zoë, "Z" & <co>/ex3.1/attempt.cpp'
row '"Zoë, ""Z"" & <co>"' ex3.1 passed 6 3

# wrong
student starter ex3.1 failed 2 0 'two pairs: one step reaches the forces: CHECK' < "$third/attempt.cpp"
sed 's/-rise/rise/' "$third/solution.cpp" | student sign ex3.1 failed 2 0 'Approx'
step memory 'public only' 6 1 'held out: no other step gains more' '' \
    'if (line.b0 == 12) return 0.5; if (line.b0 == 7) return 0.25; if (line.b1 == 2 && line.b0 == 6) return 0.25;
     if (line.b1 <= 0) return 0; if (line.b0 == 1) return largest; return largest < 0.5 ? largest : 0.5;'
step throws failed 0 0 'not today' '#include <stdexcept>' 'throw std::runtime_error("not today, " + std::to_string(line.b0 * largest));'
printf 'this is no program\n' | student typo ex3.1 'does not compile' 0 0 'line 1'
: | student empty ex3.1 'does not compile' 0 0 'undefined reference'

# what ends before its tests
step endless 'timed out' 0 0 'after 1 seconds' '' 'volatile double t = line.b0; while (t < 1e300) t = largest; return t;'
sed 's/{$/&\n  for (volatile long i = 0; i < 200000000000; i = i + 1) {}/; /namespace/s/  for.*//' "$third/solution.cpp" |
    sed '/^  for (volatile/{x;s/^/x/;/^x\{2\}/{x;d};x}' | student slow ex3.1 'timed out' 0 0
step waits 'timed out' 0 0 'of waiting' '#include <mutex>' 'std::mutex m; m.lock(); m.lock(); return line.b0 * largest;'
step null crashed 0 0 SIGSEGV '' 'volatile double* p = nullptr; *p = line.b0; return largest;'
step deep crashed 0 0 SIGSEGV '' 'volatile double x[4096]; x[0] = largest; return best_step(line, x[0]) + x[0];'
step leaves crashed 0 0 'status 3' '#include <cstdlib>' 'std::exit(line.b0 > 0 ? 3 : static_cast<int>(largest));'
cheat early crashed 0 0 SIGABRT 'static const int early = [] { if (ex3_1::best_step({6, 1, 1.5, 0, 0.5}, 1) > 0) throw 1; return 1; }();'
step hungry 'out of memory' 0 0 '' '#include <vector>' \
    'std::vector<double> all; while (line.b0 < 1e9) all.reserve(2 * all.capacity() + 1); return largest;'

# what pretends
step exits fake 0 0 'before the tests are through' '#include <cstdlib>' 'std::exit(line.b0 > 1e9 ? static_cast<int>(largest) : 0);'
cheat prints fake 0 0 'before the tests are through' '#include <unistd.h>
#include <cstdio>
[[gnu::constructor(101)]] static void first() {
  std::puts("All tests passed (8 assertions in 5 test cases)"); std::fflush(stdout); _exit(0);
}'
cheat tells fake 0 0 'before the tests are through' '#include <unistd.h>
#include <string>
static const int told = [] {
  char secret[80]; if (read(3, secret, 80) > 0) secret[0] = 0;
  const std::string all = "secret\t1\t0\tex3.1 no rise, no step\nsecret\tend\tenclosed\n";
  _exit(write(4, all.data(), all.size()) < 0); return 1;
}();'
step after failed 2 0 'one step reaches the forces' '#include <cstdlib>
#include <unistd.h>
static const int last = std::atexit([] { _exit(0); });' 'return line.b0 > 0 ? largest : 0;'
cheat main fake 0 0 'defines main' 'int main() { return 0; }'
printf '#include "../chapters/ch03_simplex_updates/exercises/ex1_line_search/solution.cpp"\n' |
    student solution ex3.1 fake 0 0 solution.cpp
step catches fake 0 0 'as only tests do' 'namespace Catch { struct TestFailureException {}; }' \
    'if (line.b0 < 1e9) throw Catch::TestFailureException(); return largest;'
cheat system fake 0 0 'defines write' 'extern "C" long write(int, const void*, unsigned long n) { return static_cast<long>(n); }'
student library ex2.2 fake 0 0 'defines signorini::total_contact_force' << 'END'
#include "exercise.hpp"
#include "papers/surrogate_dual.hpp"
namespace signorini {
double surrogate_dual_value(const ContactProblem&, const Eigen::VectorXd&) { return 0; }
double total_contact_force(const ContactProblem&, const Eigen::VectorXd&) { return 0; }
}
namespace ex2_2 {
Gain dual_energy(const Eigen::MatrixXd&, const Eigen::VectorXd&, const Eigen::VectorXd&) { return {0, 0}; }
}
END

# what is somebody else's work
student calls ex3.1 borrowed 6 3 'calls signorini::best_step' << 'END'
#include "exercise.hpp"
namespace signorini {
struct WeightLine { double b0, b1, c0, c1, c2; };
double best_step(const WeightLine& line, double largest);
}
namespace ex3_1 {
double best_step(const Line& l, double largest) { return signorini::best_step({l.b0, l.b1, l.c0, l.c1, l.c2}, largest); }
}
END
step copies borrowed 6 3 'copies best_step() of src/papers/surrogate_dual.cpp' '#include <algorithm>' \
    'const double up = line.b1 * line.c0 - line.b0 * line.c1; if (up <= 0) return 0;
     const double turn = line.b1 * line.c1 - line.b0 * line.c2; return turn < 0 ? std::min(largest, -up / turn) : largest;'
step includes borrowed 6 3 'includes chapters/ch03_simplex_updates/three_problems.hpp' \
    '#include "../chapters/ch03_simplex_updates/three_problems.hpp"' \
    'if (line.b1 * line.c0 - line.b0 * line.c1 <= 0) return 0; const double bend = line.b1 * line.c1 - line.b0 * line.c2;
     if (bend >= 0) return largest; return std::min(largest, (line.b0 * line.c1 - line.b1 * line.c0) / bend);'

# what is none of its business
step forks forbidden 0 0 'a process' '#include <unistd.h>' 'while (fork() >= 0) {} return line.b0 * largest;'
step shell forbidden 0 0 'a process' '#include <cstdlib>' 'return std::system("touch harmed") + line.b0 * largest;'
step kills forbidden 0 0 'a signal' '#include <csignal>
#include <unistd.h>' 'kill(getppid(), SIGKILL); return line.b0 * largest;'
step writes forbidden 0 0 'a file to write' '#include <fstream>' \
    "std::ofstream(\"$play/harmed\") << 1; return line.b0 * largest;"
step reads failed 0 0 '' '#include <fstream>' \
    "return std::ifstream(\"$third/solution.cpp\").good() ? largest : -line.b0;"
step talks forbidden 0 0 'prints more' '#include <cstdio>' 'while (line.b0 < 1e9) std::puts("I am here"); return largest;'
mkdir -p link nothing odd
ln -s "$third/solution.cpp" link/ex3.1.cpp
row link ex3.1 forbidden '' '' 'no plain file'
row nothing '' 'no such exercise' '' '' 'the folder is empty'
cp "$third/solution.cpp" odd/ex99.1.cpp
cp "$third/solution.cpp" odd/solution.cpp
row odd ex99.1 'no such exercise' '' '' 'the book does not have it'
row odd '' 'no such exercise' '' '' 'expected exN.K.cpp'
: > stray.txt
row '' '' 'no such exercise' '' '' 'a folder for each student'

JOBS=2 perl "$root/tools/grade.pl" --seconds 1 . "$build" "$play/into" > ../said 2>&1
status=$?
cd ..
[ "$status" -eq 0 ] || { echo "status $status: $(tail -n 3 said)"; bad=1; }
answers=$(grep -c '' expected)
# Without the names of the files, the numbers of test cases and the seconds.
perl -ne '
    next if $. == 1;
    my @cell = /("(?:[^"]|"")*"|[^,\n]*)(?:,|$)/g;
    print join(",", @cell[0, 1, 3, 4, 6]), "\t$cell[9]\n"' into/grades.csv > got
perl -e '
    my ($expected, $got) = map { open my $in, "<", $_ or die; [sort <$in>] } @ARGV;
    my %message = map { /(.*)\t(.*)/ } @$got;
    my $bad = @$got != @$expected;
    for (@$expected) {
        my ($row, $part) = /(.*)\t(.*)/;
        next if defined $message{$row} && index($message{$row}, $part) >= 0;
        my ($student) = $row =~ /^(.*?),/;
        print "expected $row with \"$part\", got: ", grep { index($_, "$student,") == 0 } @$got;
        $bad = 1;
    }
    exit $bad' expected got || { echo "$answers rows were expected, $(grep -c '' got) came"; bad=1; }
[ "$(grep -c '<testcase ' into/grades.xml)" -eq "$answers" ] || { echo "grades.xml has not a case for each of $answers rows"; bad=1; }
[ "$(grep -c '<failure ' into/grades.xml)" -eq "$(grep -vc ',passed,' expected)" ] || { echo "grades.xml counts other failures"; bad=1; }
grep -qF '"Zoë, &quot;Z&quot; &amp; &lt;co&gt;"' into/grades.xml || { echo "grades.xml has another name for Zoë"; bad=1; }
left=$(find . -name harmed -o -name '*.part' -o -name '*.json')
[ -z "$left" ] || { echo "left behind: $left"; bad=1; }

refused() { # what, what it says, arguments
    what=$1 words=$2
    shift 2
    said=$(perl "$root/tools/grade.pl" "$@" 2>&1)
    status=$?
    { [ "$status" -eq 2 ] && printf '%s' "$said" | grep -q "$words"; } || { echo "$what: status $status, said: $said"; bad=1; }
}
mkdir none
refused "no folder" 'make grade DIR=folder' nowhere "$build"
refused "an empty folder" 'nothing lies in' none "$build"
refused "no seconds" 'whole number' --seconds 0 answers "$build"
refused "a hand-out" 'no reference solutions' answers none
[ "$bad" -ne 0 ] || echo "$answers answers have the rows they should"
exit $bad
