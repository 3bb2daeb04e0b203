#!/bin/sh
# command.sh PROGRAM DATA FOLDER: the program `signorini` says what it should and ends with the right status.
set -u
program=$1 data=$2
rm -rf "$3"
mkdir -p "$3"
cd "$3" || exit 1
failures=0
expect() { # status, words that are said (an extended regular expression), arguments
    wanted=$1 words=$2
    shift 2
    said=$("$program" "$@" 2>&1)
    status=$?
    if [ "$status" -ne "$wanted" ] || ! printf '%s' "$said" | grep -Eq -- "$words"; then
        echo "signorini $*: status $status, expected $wanted and '$words', said: $said"
        failures=$((failures + 1))
    fi
}
lcp=$data/siconos_lcp qp=$data/maros_meszaros
printf 'n 1\nM\n0\nq\n-1\n' > immovable
printf 'n 2\nM\n1 2\n0 1\nq\n-1 -1\n' > asymmetric
printf 'n 1\nm 2\nr 0\nP\n2\nq\n0\nA\n1\n1\nl\n1 -1e20\nu\n1e20 0\n' > contradiction
printf 'n 1\nM\n1e300\nq\n-1\n' > huge
printf 'n 2\nM\n2 1\n1 nan\nq\n-1 -1\n' > odd

expect 0 'solved .*' lcp "$lcp/lcp_deudeu.dat"
expect 0 '1 +1\.33333333333333' lcp "$lcp/lcp_deudeu.dat" --solver all
expect 0 'from the z of the file: 0\.0e\+00' lcp "$data/generated/fathi_spd_lemke_exponential.txt"
expect 0 'positive semidefinite' lcp "$lcp/lcp_CPS_1.dat" --solver all
expect 0 'published optimum 5\.32664756' qp "$qp/HS52.txt" --solver all
expect 0 'quasi_active_set +solved .* 6155\.2508' qp "$qp/DUALC1.txt"
expect 0 'may fail on problems that are:' --list
expect 0 '--tolerance' lcp --help
expect 1 'primal_dual_active_set +not tried +needs a symmetric matrix' lcp asymmetric --solver primal_dual_active_set
printf 'n 2\nM\n0 1\n-1 0\nq\n-5 -6\n' > skew
expect 1 'quasi_active_set +infeasible' lcp immovable
expect 1 'not solved' lcp skew --solver fischer_burmeister
expect 1 'not solved' lcp skew --solver all
expect 1 'infeasible' qp contradiction --solver all
expect 1 'refused .*change the units' lcp huge
expect 1 'NOT CONFIRMED' lcp "$lcp/lcp_deudeu.dat" --tolerance 1e-300
expect 2 "unknown solver 'magic'; known solvers: .*enumerate" lcp "$lcp/lcp_deudeu.dat" --solver magic
expect 2 'HS35.txt: this is a quadratic programme; run: signorini qp' lcp "$qp/HS35.txt"
expect 2 'this is a complementarity problem; run: signorini lcp' qp "$lcp/lcp_deudeu.dat"
expect 2 'ZECEVIC2.txt: not strictly convex' qp "$qp/ZECEVIC2.txt"
expect 2 "odd:4: M, row 2, number 2: expected a finite number, got 'nan'" lcp odd
expect 2 'missing: there is no such file' lcp missing
expect 2 'this is a folder' qp "$qp"
expect 2 'FILE is required' qp
expect 2 'expected lcp FILE, qp FILE or --list'
expect 2 "unknown command 'foo'; expected lcp FILE, qp FILE or --list" foo odd
expect 2 'Try signorini --help' solve
expect 2 '--tolerance' lcp odd --tolerance word
expect 2 '--tolerance: expected a number above 0' lcp odd --tolerance -1
expect 2 '--tolerance: expected a number above 0' lcp odd --tolerance nan

# What is printed to a full disk is lost, and that is no success.  The second writes more than one buffer.
if [ -c /dev/full ]; then
    lost() { # arguments
        said=$("$program" "$@" 2>&1 > /dev/full)
        status=$?
        if [ "$status" -ne 2 ] || ! printf '%s' "$said" | grep -Eq '^signorini: cannot write .*printed'; then
            echo "signorini $* > /dev/full: status $status, expected 2, said: $said"
            failures=$((failures + 1))
        fi
    }
    lost lcp "$lcp/lcp_deudeu.dat"
    lost qp "$qp/DUALC1.txt" --solver all --json
    lost lcp immovable
    lost --list
    lost --help
    lost qp --help
fi

json() { # status, arguments: valid, and on standard output alone
    wanted=$1
    shift
    "$program" "$@" --json > out.json 2> errors
    status=$?
    [ "$status" -eq "$wanted" ] && [ ! -s errors ] || { echo "signorini $* --json: status $status, expected $wanted"; failures=$((failures + 1)); }
    if command -v python3 > /dev/null 2>&1; then
        python3 -m json.tool out.json > /dev/null || { echo "signorini $* --json: no valid JSON"; failures=$((failures + 1)); }
    fi
    if grep -Eiq '(nan|inf)\b' out.json; then echo "signorini $* --json: has a number that JSON has not"; failures=$((failures + 1)); fi
}
cp immovable 'a "name" \ with	marks'
json 0 qp "$qp/HS35.txt" --solver all
json 0 lcp "$data/generated/fathi_spd_lemke_exponential.txt" --solver all
json 1 lcp asymmetric --solver primal_dual_active_set
json 1 lcp 'a "name" \ with	marks' --solver all
json 1 qp contradiction --solver all
[ "$failures" -eq 0 ]
