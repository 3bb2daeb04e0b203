#!/bin/sh
# command.sh PROGRAM DATA EXAMPLES PAGE FOLDER: the program `signorini` says what it should and ends with the right
# status.  PAGE is its manual page.
set -u
program=$1 data=$2 examples=$3 page=$4 folder=$5
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1
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
lcp=$data/siconos_lcp fc=$data/siconos_fc2d qp=$data/maros_meszaros
printf 'n 1\nM\n0\nq\n-1\n' > immovable
printf 'n 2\nM\n1 2\n0 1\nq\n-1 -1\n' > asymmetric
printf 'n 1\nm 2\nr 0\nP\n2\nq\n0\nA\n1\n1\nl\n1 -1e20\nu\n1e20 0\n' > contradiction
printf 'n 1\nM\n1e300\nq\n-1\n' > huge
printf '2 1 0 2 2 2 2 1 0 0 1 -1 0 -1' > negative
printf 'n 2\nM\n2 1\n1 nan\nq\n-1 -1\n' > odd

expect 0 'solved .*' lcp "$lcp/lcp_deudeu.dat"
expect 0 '1 +1\.33333333333333' lcp "$lcp/lcp_deudeu.dat" --solver all
expect 0 'from the z of the file: 0\.0e\+00' lcp "$data/generated/fathi_spd_lemke_exponential.txt"
expect 0 'positive semidefinite' lcp "$lcp/lcp_CPS_1.dat" --solver all
expect 0 'published optimum 5\.32664756' qp "$qp/HS52.txt" --solver all
expect 0 'quasi_active_set +solved .* 6155\.2508' qp "$qp/DUALC1.txt"
expect 0 '2 +0\.0552243985742.* backward' friction "$fc/FC2D_SliderCrankLagrangian00000.dat" --solver lemke
expect 0 'open 16, stick 11, forward 0, backward 1' friction - < "$fc/FrictionContactProblem00374.dat"
expect 0 'friction_split +solved' friction "$fc/FrictionContactProblem00031.dat" --solver all
expect 0 'force of pair 2: from 0 to 0\.52356020' friction "$data/found/friction_two_identical_pairs.txt"
expect 0 '4 accepted solvers differ by 1\.0e\+00 of the largest force .*: the forces are not determined' friction "$data/found/friction_two_identical_pairs.txt" --solver all
expect 0 'friction force of pair 1: from -0\.7158836.* to 0\.4295302' friction "$data/found/friction_corner_node.txt"
expect 0 'accepted solvers differ by 0\.0e\+00 of the largest force and 0\.0e\+00 of the largest movement$' lcp "$lcp/lcp_deudeu.dat" --solver all
printf 'n 1\nm 2\nr 0\nP\n2\nq\n0\nA\n1\n1\nl\n1 1\nu\n1e20 1e20\n' > twice
expect 0 'multiplier of row 1: from -2 to 0' qp twice
expect 0 '2 forces are not determined' lcp "$lcp/lcp_CPS_1.dat"
expect 0 'there are other solutions: the determinant of pair 1' friction "$data/../hard/friction/three_answers.txt"
expect 1 'friction_split +refused .*must be symmetric' friction "$fc/FC2D_SliderCrankLagrangian00000.dat" --solver friction_split
expect 0 'may fail on problems that are:' --list
expect 0 'frontal' --list
expect 0 '--tolerance' lcp --help
expect 2 "^signorini: --threads: expected a whole number from 1 to 1024, got '0'" solve "$examples/cantilever.toml" --threads 0
expect 2 "^signorini: --threads: expected a whole number from 1 to 1024, got '1\.5'" solve "$examples/cantilever.toml" --threads 1.5
for threads in 1 3; do
    "$program" solve "$examples/hertz.toml" --threads $threads --csv threads_$threads.csv --vtu threads_$threads.vtu > /dev/null || failures=$((failures + 1))
done
for file in csv vtu; do
    cmp threads_1.$file threads_3.$file || failures=$((failures + 1))
done
expect 1 'primal_dual_active_set +not tried +needs a symmetric matrix' lcp asymmetric --solver primal_dual_active_set
printf 'n 2\nM\n0 1\n-1 0\nq\n-5 -6\n' > skew
expect 1 'quasi_active_set +infeasible' lcp immovable
expect 1 'not solved' lcp skew --solver fischer_burmeister
expect 1 'not solved' lcp skew --solver all
expect 1 'infeasible' qp contradiction --solver all
expect 1 'refused .*change the units' lcp huge
expect 1 'NOT CONFIRMED' lcp "$lcp/lcp_deudeu.dat" --tolerance 1e-300
# Forces of an equation and a bound cancel; 0.7 times one is not the other.
printf '%s\n' 'n 2' 'm 2' 'r 0' P '1 0' '0 1' q '0 -5' A '0.7 1e-7' '1 0' l '1e-7 0' u '1e-7 1e20' > cancel.txt
expect 1 'forces up to 2\.8e\+07 cancel, to 5\.0e\+00' qp cancel.txt
expect 1 'not solved; --tolerance [0-9]e-10 accepts what [a-z_]* has come to' qp cancel.txt
expect 1 '^primal_dual_active_set  breakdown' qp cancel.txt # the next member is asked
expect 1 '^not solved; --tolerance' qp cancel.txt --solver lemke
expect 0 '^quasi_active_set  solved ' qp cancel.txt --tolerance 1e-8
expect 1 '"why": "--tolerance .* forces up to ' qp cancel.txt --json
printf '%s\n' 'n 2' 'm 2' 'r 0' P '3 0' '0 0' q '-1 0' A '0.7 -1' '0 1' l '0 -10' u '0 10' > defined.txt
expect 0 '^quasi_active_set  solved .*-0\.1666666' qp defined.txt
expect 1 'enumerate has proved that the conditions contradict each other' lcp "$lcp/lcp_Pang_isolated_sol_perturbed.dat"
expect 2 "^signorini: --csv: expected the name of a file, got '-'" solve "$examples/cantilever.toml" --csv -
expect 2 "--solver: unknown solver 'magic'; there are: .*enumerate" lcp "$lcp/lcp_deudeu.dat" --solver magic
expect 2 'HS35.txt: this is a quadratic programme; run: signorini qp' lcp "$qp/HS35.txt"
expect 2 'this is a complementarity problem; run: signorini lcp' qp "$lcp/lcp_deudeu.dat"
expect 2 'this is a friction problem; run: signorini friction' lcp "$fc/FrictionContactProblem00031.dat"
expect 2 'this is a complementarity problem; run: signorini lcp' friction "$lcp/lcp_deudeu.dat"
expect 2 'this is a quadratic programme; run: signorini qp' friction "$qp/HS35.txt"
expect 2 'this looks like a friction problem; run: signorini friction' solve "$fc/FrictionContactProblem00031.dat"
expect 2 'this looks like a scene; run: signorini solve' friction "$examples/cantilever.toml"
expect 2 '--solver: quasi_active_set does not take such problems; expected one of primal_dual_active_set' friction "$fc/FrictionContactProblem00031.dat" --solver quasi_active_set
expect 2 'mu\(1\): expected a friction coefficient of 0 or more, got -1' friction negative
expect 0 '-4.125' qp "$qp/ZECEVIC2.txt"
expect 2 "odd:4: M, row 2, number 2: expected a finite number, got 'nan'" lcp odd
expect 2 'missing: there is no such file' lcp missing
expect 2 'this is a folder' qp "$qp"
expect 2 'FILE is required: signorini qp FILE\. Try signorini qp --help' qp
expect 2 'FILE is required: signorini solve FILE\. Try signorini solve --help' solve
expect 2 'expected plan FILE, solve FILE, mesh FILE, lcp FILE, friction FILE, qp FILE, --list'
expect 2 "unknown command 'foo'; there are: plan, solve, mesh, lcp, friction, qp" foo odd
expect 2 "unknown command 'plna'; did you mean 'plan'\?" plna odd
expect 2 "--solver: unknown solver 'lemk'; did you mean 'lemke'\?" lcp odd --solver lemk
expect 2 "unknown option '--vtuu'; did you mean '--vtu'\?" solve odd --vtuu x
expect 2 "expected one FILE, got also 'b'" lcp odd b
expect 2 "unknown option '--colour'.*here are: .*--vtu" solve odd --colour
expect 2 "unknown option '--colour'; there are: .*--list" --colour
expect 2 '--solver: expected a value' lcp odd --solver
for word in abc -1 0 nan inf 1e999 1e-12x; do
    expect 2 "^signorini: --tolerance: expected a number above 0, got '$word'$" lcp odd "--tolerance=$word"
done
expect 0 '^signorini [0-9]+\.[0-9]+\.[0-9]+$' --version

# Scenes.  All files that are asked for are written, or none.
cantilever=$examples/cantilever.toml
holds() { # what, command: it must succeed
    what=$1
    shift
    "$@" || { echo "$what: $*"; failures=$((failures + 1)); }
}
written() { # names, of all files in outputs; then they are removed
    holds 'files in outputs' test "$(ls -A outputs)" = "$1"
    rm -f outputs/*
}
mkdir outputs
{
    printf '[[body]]\nname = "stone"\nmesh = { kind = "block", size = [1, 1], cells = [4, 4] }\nsymmetric = "left"\n'
    printf 'material = { youngs_modulus = 1, poisson_ratio = 0.3 }\npressure = { bottom = 1e-3 }\n'
    printf '[[contact]]\nsource = "bottom"\ntarget = { kind = "half_plane", point = [0, 0], normal = [0, 1] }\n'
} > lifted.toml
expect 0 'unknowns 2200, pairs 100, rows 100' plan "$cantilever"
expect 0 "body 'beam': 1 piece, loads add up to \(0, -180\), moment about the origin -4500" plan "$cantilever"
expect 0 'solver lemke, as' plan "$cantilever" --solver lemke
expect 0 '^certificate: penetration' solve "$cantilever"
expect 0 'assembly +unknowns +2200 +2200 +exact' solve "$cantilever"
expect 0 'peak pressure 11\.52' solve "$cantilever"
expect 0 'left out, the first is node' plan "$examples/footing.toml"
expect 0 'left out, the first is node' solve "$examples/footing.toml"
expect 0 'asked for: normal_force within 0\.5 %' solve "$cantilever" --accuracy 0.5%
expect 0 'accuracy: met' solve "$cantilever" --accuracy 0.005
expect 0 'displacement:footing\.top\.y within 1 %; equilibrium alone' solve "$examples/footing.toml" --accuracy 1%
expect 0 'element: .* %; stresses' solve "$examples/hertz.toml" --accuracy 1% --goal width
expect 0 '"met": true' solve "$cantilever" --accuracy 1% --json
expect 1 'accuracy NOT met: budget of unknowns: .* 3000 are allowed' solve "$cantilever" --accuracy 0.001% --unknowns 3000
expect 0 'accuracy: met' solve "$examples/punch.toml" --accuracy 1%
sed '/^target = "footing/a operator = "gauss_points"' "$examples/footing.toml" > gauss.toml
expect 2 'gauss.toml:18: estimate: the pairs of soil.surface on footing.bottom are Gauss points' solve gauss.toml --accuracy 1%
sed '/^symmetric = "axis"/i layer = { box = [0, -15, 15, -2.7], youngs_modulus = 4e4 }' "$examples/footing.toml" > layered.toml
for wish in plan solve 'solve --accuracy 5%' 'solve --json'; do
    # shellcheck disable=SC2086
    expect 0 'layered.toml:15: the edges of the box .*, -2\.7\] of a layer of .soil. cut [0-9]+ cells' ${wish%% *} layered.toml $(expr "$wish" : '[a-z]* *\(.*\)')
done
expect 2 '--accuracy: .*to_and_fro.toml has load steps' solve "$examples/to_and_fro.toml" --accuracy 1%
expect 2 "--accuracy: expected a part above 0, such as 0\.5% or 0\.005, got '-1%'" solve "$cantilever" --accuracy=-1%
expect 2 "--accuracy: expected a part above 0, .* got '0\.x%'" solve "$cantilever" --accuracy 0.x%
expect 2 "--accuracy: expected less than 100%, got '50'; did you mean '50%'" solve "$cantilever" --accuracy 50
expect 0 'force within 0\.5 %' solve "$cantilever" --accuracy '0.5 %'
expect 2 "--unknowns: expected a number above 0, got 'few'" solve "$cantilever" --accuracy 1% --unknowns few
expect 2 '--unknowns: the mesh of .* has 2200 already' solve "$cantilever" --accuracy 1% --unknowns 10
expect 2 '--unknowns: says how far --accuracy may refine' solve "$cantilever" --unknowns 1000
expect 2 "unknown goal 'peek'; did you mean 'peak'" solve "$cantilever" --accuracy 1% --goal peek
expect 2 '--goal: say how accurate it is to be' solve "$cantilever" --goal force
expect 1 "not solved: .*'stone'.*Turn the load round" solve lifted.toml --vtu outputs/a.vtu --csv outputs/a.csv --plot outputs/a.svg
written ''
expect 2 "--solver: unknown solver 'magic'" solve "$cantilever" --solver magic
expect 2 "cantilever.toml:[0-9]+: solver 'enumerate' takes at most 12 pairs, here are 100: take the default, 'primal_dual_active_set'" solve "$cantilever" --solver enumerate
expect 2 "--solver: unknown solver 'all'" solve "$cantilever" --solver all
expect 0 '^certificate: penetration' solve "$cantilever" --backend frontal
expect 2 "^signorini: --backend: unknown back end 'frontl'; did you mean 'frontal'\?" solve "$cantilever" --backend frontl
expect 2 "unknown option '--backend'" plan "$cantilever" --backend frontal
cp "$program" alone # without the program beside it that has the others
whole=$program program=./alone
expect 2 "unknown back end 'mumps'.* needs libmumps-dev and libopenmpi-dev: install them with tools/setup.sh parallel" solve "$cantilever" --backend mumps
expect 2 "unknown back end 'cholmod'.* needs libsuitesparse-dev" solve "$cantilever" --backend cholmod
expect 2 "unknown back end 'munps'; did you mean 'mumps'\?" solve "$cantilever" --backend munps
expect 0 '^    not built; it needs libmumps-dev and libopenmpi-dev: install them with tools/setup.sh parallel, then type make$' --list
export OMPI_COMM_WORLD_SIZE=2
expect 2 '^signorini: --backend frontal: it works on one process, here are 2, ' solve "$cantilever"
unset OMPI_COMM_WORLD_SIZE
program=$whole
expect 2 'missing: there is no such file' solve missing
expect 2 'this looks like a complementarity problem; run: signorini lcp immovable' solve immovable
expect 2 'this looks like a complementarity problem; run: signorini lcp ' plan "$lcp/lcp_deudeu.dat"
expect 2 'this looks like a quadratic programme; run: signorini qp ' solve "$qp/HS35.txt"
expect 2 'cantilever.toml: this looks like a scene; run: signorini solve ' lcp "$cantilever"
expect 2 'cantilever.toml: this looks like a scene; run: signorini solve ' qp "$cantilever"
expect 0 'standard input: A cantilever' solve - < "$cantilever"
expect 0 'standard input: complementarity problem' lcp - < "$lcp/lcp_deudeu.dat"
expect 2 'standard input: this looks like a scene; run: signorini solve -' lcp - < "$cantilever"
expect 2 'standard input:[0-9]+: ' solve - < "$data/scenes/wrong/negative_modulus.toml"
expect 0 solved solve "$cantilever" --vtu outputs/a.vtu --csv outputs/a.csv
written 'a.csv
a.vtu'
expect 2 "cannot write 'nowhere/a.vtu'" solve "$cantilever" --csv outputs/a.csv --vtu nowhere/a.vtu
expect 2 "cannot write 'outputs': this is no plain file" solve "$cantilever" --csv outputs --vtu outputs/a.vtu
expect 2 "cannot write '/dev/null': this is no plain file" solve "$cantilever" --csv /dev/null
expect 2 "cannot write './outputs/a' twice: give every result a file of its own" solve "$cantilever" --vtu outputs/a --csv ./outputs/a
expect 2 "--plot: expected a file .svg, .png or .pdf, got 'outputs/a.jpg'" solve "$cantilever" --plot outputs/a.jpg --csv outputs/a.csv
written ''
holds 'a device stays one' test -c /dev/null
if command -v gnuplot > /dev/null 2>&1; then
    expect 0 solved solve "$cantilever" --plot "outputs/it's.svg"
    expect 0 'contact relation 2' solve "$examples/preloaded_bolt.toml" --plot outputs/a.png
    holds 'a picture' grep -q '</svg>' "outputs/it's.svg"
    expect 0 solved solve "$examples/punch.toml" --plot outputs/a.png
    expect 0 solved solve "$examples/punch.toml" --plot outputs/a.pdf
    expect 0 '1 body' mesh "$cantilever" --plot outputs/b.pdf
    for drawn in a.pdf b.pdf; do
        holds "$drawn is a PDF" test "$(head -c 5 outputs/$drawn)" = '%PDF-'
    done
    expect 0 '2 bodies' mesh "$examples/wheel_on_rail.msh" --plot outputs/b.svg
    for way in wheel.hub wheel.tread rail.base rail.top; do
        holds "$way in a picture" grep -Fq "$way" outputs/b.svg
    done
    written "a.pdf
a.png
b.pdf
b.svg
it's.svg"
fi
# Meshes.
printf 'CDF\001' > exodus
expect 0 "^  rest +12 +12  \(6, 0\), \(-6, 0\)$" mesh "$examples/stamp.inp"
expect 0 "^  tread +32 +125\.62  \(-40, 40\), \(40, 40\)$" mesh "$examples/wheel_on_rail.msh"
expect 0 "^body 'disc': 685 nodes, 640 quadrilaterals of 4 nodes$" mesh "$examples/hertz.toml"
expect 0 "^  region 'Upper': 4 cells$" mesh "$data/inp/layers.toml"
expect 0 '^further element sets, for set = "NAME": both \(6 cells\)$' mesh - < "$data/inp/two_blocks.inp"
expect 1 "^  cannot be taken: mesh 'body': cell 0 is degenerate" mesh "$data/inp/inverted.inp"
expect 2 'missing.msh: there is no such file' mesh missing.msh
expect 2 'this is a netCDF file, as Exodus is; meshio convert FILE' mesh exodus
expect 2 "cannot write 'a.inp': results do not replace scenes and meshes" solve "$cantilever" --csv a.inp
expect 2 '--plot: expected a file .svg' mesh "$examples/stamp.inp" --plot a.eps
echo mine > outputs/a.csv.draft1
echo mine > outputs/a.csv
expect 0 solved solve "$cantilever" --vtu outputs/a.csv.draft2 --csv outputs/a.csv
holds 'a draft takes the name of no file' grep -q mine outputs/a.csv.draft1
holds 'a file is replaced' grep -q pressure outputs/a.csv
written 'a.csv
a.csv.draft1
a.csv.draft2'
# What cannot be published is taken back: this gnuplot puts a folder in the place of its picture.
mkdir programs
printf '#!/bin/sh\ndraft=$(sed -n "s/^out = .\\(.*\\).$/\\1/p" "$1")\necho drawn > "$draft"\nmkdir outputs/a.svg\n' > programs/gnuplot
chmod +x programs/gnuplot
echo mine > outputs/a.csv
said=$(PATH=$PWD/programs:$PATH "$program" solve "$cantilever" --vtu outputs/a.vtu --csv outputs/a.csv --plot outputs/a.svg 2>&1 > /dev/null)
holds 'a folder in the way' test "$? ${said%% (*}" = "2 signorini: cannot write 'outputs/a.svg'"
holds 'a file is put back' grep -qx mine outputs/a.csv
rmdir outputs/a.svg
written a.csv
said=$(PATH=/nowhere "$program" solve "$cantilever" --plot outputs/a.svg --csv outputs/a.csv 2>&1 > /dev/null)
holds 'without gnuplot' test "$? ${said%%;*}" = '2 signorini: --plot: there is no gnuplot'
written ''
if [ "$(id -u)" -ne 0 ]; then
    chmod a-w outputs
    expect 2 'cannot write' solve "$cantilever" --csv outputs/a.csv
    chmod u+w outputs
    echo mine > outputs/a.csv
    chmod a-w outputs/a.csv
    expect 2 "cannot write 'outputs/a.csv': this file may not be written to" solve "$cantilever" --csv outputs/a.csv
    rm -f outputs/a.csv
fi

# What a scene is made from is not written, by whatever name; a link is followed, and a file keeps its mode.
cp "$examples/bumps.toml" "$examples/bumps.csv" .
cp bumps.csv kept
ln -s ../bumps.csv outputs/floor
for name in bumps.csv ./outputs/../bumps.csv outputs/floor; do
    expect 2 "cannot write '$name': results do not replace what they are made from, and 'bumps.csv' is read" solve bumps.toml --csv "$name"
done
cp "$examples/stamp.toml" .
sed 's/stamp\.inp/stamp.mesh/' stamp.toml > stamp2.toml
cp "$examples/stamp.inp" stamp.mesh
expect 2 "cannot write 'stamp.mesh': .* is read" solve stamp2.toml --vtu stamp.mesh
expect 2 "cannot write 'A.INP': results do not replace scenes and meshes" solve "$cantilever" --csv A.INP
cp "$cantilever" scene
expect 2 "cannot write 'scene': .*, and the standard input is read" solve - --csv scene < scene
holds 'the profile of a scene' cmp kept bumps.csv
holds 'the mesh of a scene' cmp "$examples/stamp.inp" stamp.mesh
written floor
mkdir real
ln -s ../real/new.csv outputs/new.csv
ln -s ../real/old.csv outputs/old.csv
ln -s circle outputs/circle
echo mine > real/old.csv
chmod 604 real/old.csv
for one in new old; do
    expect 0 solved solve "$cantilever" --csv "outputs/$one.csv"
    holds 'a link stays one' test -L "outputs/$one.csv"
    holds 'the file of a link' grep -q pressure "real/$one.csv"
done
holds 'the mode of a file' test "$(stat -c %a real/old.csv)" = 604
expect 0 solved solve "$examples/to_and_fro.toml" --csv outputs/old.csv
holds 'the file of a link with all steps' test "$(grep -c '^4,' real/old.csv)" = 41
expect 2 "cannot write 'outputs/old.csv' twice|cannot write 'real/old.csv' twice" solve "$cantilever" --csv outputs/old.csv --vtu real/old.csv
expect 2 "cannot write 'outputs/circle': this link leads in a circle" solve "$cantilever" --csv outputs/circle
holds 'nothing but the files of links' test "$(ls -A real)" = 'new.csv
old.csv'
if [ -e /proc/self/fd/1 ]; then
    ln -s /proc/self/fd/1 outputs/printed
    "$program" solve "$cantilever" --csv outputs/printed > real/printed 2> errors
    holds 'results where a run prints' test "$? $(cat errors)" = "2 signorini: cannot write 'outputs/printed': what is printed goes to this file; give results a file of their own"
    holds 'a link to where a run prints stays one' test -L outputs/printed
    expect 2 "cannot write 'outputs/printed': this is no plain file" solve "$cantilever" --csv outputs/printed
fi
rm -r real outputs/*
# Names end no line of a script, and are not empty.
newline='a
!touch pwned
#.svg'
expect 2 "cannot write 'a\?!touch pwned\?#.svg': this name has control characters" solve "$cantilever" --plot "$newline"
expect 2 "cannot write 'a\?!touch pwned\?#.svg': this name has control characters" mesh "$examples/stamp.inp" --plot "$newline"
holds 'no command was run' test ! -e pwned
for option in --vtu --csv --plot --probes --state --from; do
    expect 2 "$option: expected the name of a file, got ''" solve "$cantilever" "$option" ''
done
expect 2 "--plot: expected the name of a file, got ''" mesh "$examples/stamp.inp" --plot ''
# A file that may not become so long is like a full disk.
(ulimit -f 1 && exec "$program" solve "$cantilever" --vtu outputs/a.vtu > /dev/null 2> errors)
holds 'a limit of the length of files' test "$?" -eq 2
holds 'what is said of that limit' grep -q "^signorini: cannot write 'outputs/a.vtu'" errors
written ''
for command in lcp friction qp solve plan; do
    expect 2 "stamp.inp: this looks like a mesh; run: signorini mesh $examples/stamp.inp$" $command "$examples/stamp.inp"
    expect 2 "wheel_on_rail.msh: this looks like a mesh; run: signorini mesh $examples/wheel_on_rail.msh$" $command "$examples/wheel_on_rail.msh"
done
cp immovable 'two words'
expect 2 "this is a complementarity problem; run: signorini lcp 'two words'$" qp 'two words'
sed 's/bumps\.csv/holed.csv/' bumps.toml > holed.toml
for row in '0,,-1' ',0,-1' '0,-1,'; do
    { cat bumps.csv; echo "$row"; } > holed.csv
    expect 2 "holed.csv:[0-9]+: expected x and y, got a comma without a number (before|behind) it" solve holed.toml
done
# Loads whose squares are no doubles.
for load in 3.6e-170 3.6e160; do
    sed "s/top = 3.6 /top = $load /; /^\[\[contact/,\$d" "$cantilever" > load.toml
    expect 0 "moves by up to [1-9][0-9.]*e[-+]1[567][0-9], .*von Mises' stress up to [1-9][0-9.]*e[-+]1[567][0-9] in the mean" solve load.toml
done
# Programmes that are convex on their equations alone.
printf 'n 2\nm 1\nr 0\nP\n1 -2\n-2 1\nq\n0 -1\nA\n1 1\nl\n1\nu\n1\n' > across
expect 0 '0\.33333333333333[0-9]*' qp across
expect 0 'objective.* -0\.83333333333333|-0\.83333333333333' qp across --solver all
sed 's/^1 -2$/1 3/; s/^-2 1$/3 1/' across > concave
expect 2 'not convex: P has a negative eigenvalue where the equations hold' qp concave
sed '$s/.*/inf/' across > unbounded
expect 2 "u, number 1: expected a finite number, got 'inf'; for no bound write 1e20$" qp unbounded

# Load steps: a line, a file and a state for each.  A path goes on from its state to the same bits.
path=$examples/to_and_fro.toml
expect 0 'load steps: 51 up to time 4, one factor for all' plan "$path"
expect 0 "history 'drag': 0 at time 0, 0 at time 1, 1 at time 2, -1 at time 3, 1 at time 4; 1 load follows it" plan "$path"
expect 0 'later step +seconds at least' plan "$path"
expect 0 'later step +seconds +[0-9.e-]+ s +[0-9.e-]+ s +at least' solve "$path"
expect 0 '^friction_split$' --list
expect 0 '^ +11 +2 +[0-9]+ +4 +40 +0 +40 +-60 +200 +3\.3251 ' solve "$path" --vtu outputs/a.vtu --csv outputs/a.csv --state outputs/a
expect 0 'solved: 51 steps up to time 4' solve "$path"
holds 'rows of all steps' test "$(cut -d, -f1 outputs/a.csv | grep -vc '[a-z]') $(grep -c '^time,.*,pressure,' outputs/a.csv)" = '2091 1'
holds 'a collection of all steps' test "$(grep -c '<DataSet timestep="[0-9.]*" part="0" file="a_00[0-5][0-9].vtu"/>' outputs/a.pvd)" -eq 51
sed '/^count = 20/,$d' "$path" | sed '$d' > part.toml
expect 0 'solved: 11 steps up to time 2' solve part.toml --vtu outputs/b.vtu --csv outputs/b.csv --state outputs/b
holds 'a step is not changed by what follows' cmp outputs/a_0011.vtu outputs/b_0011.vtu
head -c -3 outputs/b > outputs/cut
expect 2 "outputs/cut:[0-9]+: expected a line 'end', without which a part of the file is missing" solve "$path" --from outputs/cut
rm outputs/cut
expect 0 'goes on from time 2, after 11 steps' solve "$path" --from outputs/b --vtu outputs/b.vtu --csv outputs/b.csv --state outputs/b
holds 'the same state' cmp outputs/a outputs/b
holds 'the same table' cmp outputs/a.csv outputs/b.csv
sed 's/"b_/"a_/' outputs/b.pvd > collection
holds 'the same collection' cmp outputs/a.pvd collection
for file in outputs/a_*.vtu; do
    holds 'the same step' cmp "$file" "outputs/b_${file#outputs/a_}"
done
# A run that is killed leaves the rows of its state; of what is behind them, also half a line, nothing is kept.
head -n "$(grep -n '^2,' outputs/a.csv | tail -n 1 | cut -d: -f1)" outputs/a.csv > outputs/b.csv
cp outputs/a.pvd outputs/c.pvd
expect 0 'solved: 11 steps up to time 2' solve part.toml --state outputs/c
expect 0 'outputs/d.csv is new: it begins with step 12' solve "$path" --from outputs/c --csv outputs/d.csv
cp outputs/b.csv kept
for more in 2 '2.05,0,0
2.1' '# time 2'; do
    { cat kept; printf '%s' "$more"; } > outputs/b.csv
    expect 0 'goes on from time 2, after 11 steps' solve "$path" --from outputs/c --csv outputs/b.csv
    holds "the same table after '$more'" cmp outputs/a.csv outputs/b.csv
done
# Killed: the file of the first step is there while the second is solved.
sed 's/cells = .40, 10./cells = [200, 50]/; s/count = .*/count = 1000/' "$path" > long.toml
"$program" solve long.toml --csv outputs/k.csv --state outputs/k > /dev/null &
killed=$!
until [ -e outputs/k ] || ! kill -0 "$killed"; do sleep 0.1; done
kill -9 "$killed" && wait "$killed" 2> /dev/null
holds 'rows of a run that was killed' test "$(grep -c "^$(sed -n 's/^time //p' outputs/k)," outputs/k.csv)" = 201
expect 0 'solved: 11 steps up to time 2' solve part.toml --csv outputs/k.csv --state outputs/k # takes the locks that were left
for begun in 'tail -n +2000 outputs/a.csv' 'sed /^1.5,/d outputs/a.csv' 'sed s/^2,/2.05,/ outputs/a.csv' 'echo x,y'; do
    $begun > outputs/d.csv
    cp outputs/d.csv kept
    expect 2 'outputs/d.csv: this file has not the 11 steps until time 2 after which --from goes on' solve "$path" --from outputs/c --csv outputs/d.csv
    holds 'a file of other steps stays' cmp kept outputs/d.csv
done
# What probes read goes on like the table of pairs.
probes=$examples/probes.toml
expect 0 "probe 'tip' in 'beam'" solve "$probes" --probes outputs/p.csv
expect 0 '^ +0.75 +100 +5 +-0.00564' solve "$probes" # one row: printed for each step
holds 'rows of all probes and steps' test "$(grep -c '^time,probe,x,' outputs/p.csv) $(grep -c ',floor,' outputs/p.csv) $(grep -c ',wall,' outputs/p.csv)" = '1 324 4'
sed 's/^count = 4/count = 2\nuntil = 0.5/; s/press = 1/press = 0.5/' "$probes" > half.toml
expect 0 'solved: 2 steps up to time 0.5' solve half.toml --probes outputs/q.csv --state outputs/q
expect 0 'goes on from time 0.5, after 2 steps' solve "$probes" --from outputs/q --probes outputs/q.csv
holds 'the same table of probes' cmp outputs/p.csv outputs/q.csv
sed -i '/^0.25,/d' outputs/q.csv
expect 2 'outputs/q.csv: this file has not the 2 steps' solve "$probes" --from outputs/q --probes outputs/q.csv
expect 2 '^signorini: --probes: .*punch.toml has no probe: leave it out, or give the scene a \[\[probe\]\]' solve "$examples/punch.toml" --probes outputs/q.csv
sed 's/pressure,force/force,pressure/' outputs/a.csv > outputs/d.csv
expect 2 'outputs/d.csv: this file has not the 11 steps' solve "$path" --from outputs/c --csv outputs/d.csv
expect 2 'outputs/c.pvd: this file has not the 11 steps' solve "$path" --from outputs/c --vtu outputs/c.vtu
expect 2 'outputs/b: this state is that of time 4, .*end at 4: nothing is left' solve "$path" --from outputs/b
expect 2 'a.csv:[0-9]+: expected .*signorini-state' solve "$path" --from outputs/a.csv
expect 2 "cannot write 'outputs/b' twice" solve "$path" --csv outputs/b --state outputs/b
expect 2 '^signorini: --state: .*punch.toml has no load steps' solve "$examples/punch.toml" --state outputs/c
expect 2 '^signorini: --from: .*punch.toml has no load steps' solve "$examples/punch.toml" --from outputs/b
rm outputs/*
expect 0 'solved: 11 steps' solve part.toml --state outputs/a
sed 's/^friction = .*/friction = 0.2/' "$path" > other.toml
expect 2 '--from: the state at time 2 is of another scene, or what comes before time 2 was changed, .* its displacements' solve other.toml --from outputs/a
sed 's/cells = .40, 10./cells = [20, 10]/' "$path" > other.toml
expect 2 '--from: the state at time 2 is of another scene: its motion does not fit. It has 861 unknowns' solve other.toml --from outputs/a
rm outputs/*
# Pressed until time 1, then pulled off the ground: what was good stays.
{
    sed 's/^pressure.*/pressure = { top = { value = 1, history = "press" } }/' lifted.toml
    printf '[[steps]]\nvalues = { press = 1 }\n[[steps]]\ncount = 2\nvalues = { press = -1 }\n'
} > pulled.toml
expect 1 'not solved: the step from time 1\.5 to .*last good state is that of time 1\.5\. To go on from there: change what comes after time 1\.5, where press = 0; then: signorini solve pulled.toml --from outputs/a --state outputs/a --vtu outputs/a.vtu --csv outputs/a.csv$' solve pulled.toml --vtu outputs/a.vtu --csv outputs/a.csv --state outputs/a
holds 'steps of a path that failed' grep -q '^1\.5,' outputs/a.csv
holds 'a state of a path that failed' grep -qx 'time 1.5' outputs/a
written 'a
a.csv
a.pvd
a_0001.vtu
a_0002.vtu'
sed 's/youngs_modulus = 1,/youngs_modulus = 20,/; s/value = 1,/value = 0.5,/; s/^count.*/until = 1.5/; s/press = -1/press = 6/' pulled.toml > soft.toml
expect 0 'note  at time 1\.5: linear elasticity takes deformations for small' solve soft.toml
# A note has its times, and those of two bodies are two.
cat > noted.toml << 'END'
material = { youngs_modulus = 10, poisson_ratio = 0.3 }
[[body]]
name = "part1"
mesh = { kind = "block", size = [1, 1], cells = [2, 2] }
prescribed = { top = { x = 0, y = -0.001, history = "press" } }
[[body]]
name = "part2"
mesh = { kind = "block", size = [1, 1], cells = [2, 2], corner = [2, 0] }
fixed = "bottom"
pressure = { top = { value = 1, history = "load" } }
[[contact]]
source = "part1.bottom"
target = { kind = "half_plane", point = [0, 0], normal = [0, 1] }
[[steps]]
values = { press = 1 }
[[steps]]
values = { press = -1 }
[[steps]]
values = { press = 1 }
[[steps]]
values = { press = -1 }
[[steps]]
values = { press = -2 }
[[steps]]
values = { press = 300 }
[[steps]]
values = { press = 1, load = 20 }
END
expect 0 'note  at time 2 and in 2 of the steps until 5: no pair carries' solve noted.toml
expect 0 "note  at time 6: linear .* of 'part1'" solve noted.toml
expect 0 "note  at time 7: linear .* of 'part2'" solve noted.toml
sed '19s/1/-2/' noted.toml > lifted_longer.toml
expect 0 'note  from time 2 to 5: no pair carries' solve lifted_longer.toml
expect 1 'time 1\.5\. With --state FILE the next run can go on' solve pulled.toml
mkdir 'my outputs'
expect 1 "then: signorini solve pulled.toml --from 'my outputs/a' --state 'my outputs/a'\$" solve pulled.toml --state 'my outputs/a'
rm -r 'my outputs'
sed 's/press = 1 /press = -1 /' pulled.toml > never.toml
expect 1 'not solved: the step from time 0 to ' solve never.toml --vtu outputs/a.vtu --csv outputs/a.csv --state outputs/a
written ''
rm -f outputs/*

# Contacts are told apart and friction is seen; a scene without either has the columns it had.
cat > two_contacts.toml << 'END'
[[body]]
name = "block"
mesh = { kind = "block", size = [4, 2], cells = [8, 4] }
material = { youngs_modulus = 1000, poisson_ratio = 0.3 }
pressure = { top = 5, right = 1 }
[[contact]]
source = "bottom"
target = { kind = "half_plane", point = [0, 0], normal = [0, 1] }
friction = 0.1
[[contact]]
source = "left"
target = { kind = "half_plane", point = [0, 0], normal = [1, 0] }
END
expect 0 'punch.bottom on block.top: force on the source \(-150, 1000\), .* normal force 1000, shear force -150, dissipated work 0\.038' solve "$examples/punch.toml"
expect 0 '21 of 21 pairs are closed: 19 stick, 2 slide' solve "$examples/punch.toml"
expect 0 ' 5 +0 +372\.811 +93\.2026 +-149\.124 +-37\.2811 +0\.000908812 +forward +0\.0338815' solve "$examples/punch.toml"
expect 0 'contact beam.bottom on half plane: force on the source' solve "$cantilever"
expect 0 'all contacts: force on the sources \(2, 20\)' solve two_contacts.toml --csv outputs/two.csv --vtu outputs/two.vtu --ascii
header() { # file: the names of its columns
    grep -v '^#' "$1" | head -n 1
}
old=x,y,gap,pressure,force,status new=shear_traction,shear_force,slip,motion,dissipated
holds 'columns of two contacts' test "$(header outputs/two.csv)" = "$old,$new,contact"
holds 'rows of a contact with friction' test "$(grep -Ec ',(stick|forward|backward),[-+0-9.e]+,block.bottom on half plane$' outputs/two.csv)" = 9
holds 'rows of one without' test "$(grep -Ec ',0,0,[-+0-9.e]+,,0,block.left on half plane$' outputs/two.csv)" = 5
for name in $(printf '%s' "$old,$new,time,slip_total,dissipated_total,contact" | tr , ' ') $(grep -o 'contact_[a-z_]*' outputs/two.vtu | sort -u); do
    holds "no $name in the README of the examples" grep -Fq "\`$name\`" "$examples/README.md"
done
expect 0 solved solve "$cantilever" --csv outputs/one.csv --vtu outputs/one.vtu --ascii
holds 'columns without friction' test "$(header outputs/one.csv)" = "$old,slip"
holds 'fields without friction' test "$(grep -Ec 'contact_(shear|motion|number)' outputs/one.vtu)" = 0
holds 'slip without friction' test "$(grep -c 'contact_slip' outputs/one.vtu)" = 1
written 'one.csv
one.vtu
two.csv
two.vtu'
if command -v gnuplot > /dev/null 2>&1; then
    expect 0 solved solve two_contacts.toml --plot outputs/two.svg
    expect 0 solved solve "$path" --plot outputs/path.svg
    holds 'the time of a picture' grep -Eq 'displacements times [0-9.]+; time 4<' outputs/path.svg
    rm outputs/path.svg
    for word in 'block.bottom on half plane' 'block.left on half plane' 'bound of the shear'; do
        holds "no $word in the picture" grep -Fq "$word" outputs/two.svg
    done
    written two.svg
fi

# Wrong scenes: one line that names file and line, as the comment at their top says, and nothing else.
count=0
for file in "$data"/scenes/wrong/*.toml; do
    count=$((count + 1))
    said=$("$program" solve "$file" --csv outputs/a.csv 2>&1)
    status=$?
    line=$(sed -n '1s/^# \(:[0-9]*:\).*/\1/p' "$file")
    [ "$status" -eq 2 ] && [ "$(printf '%s\n' "$said" | wc -l)" -eq 1 ] &&
        printf '%s' "$said" | grep -Fq "signorini: $file${line:-:}" || {
        echo "signorini solve $file: status $status, expected 2 and one line with $file${line:-:}, said: $said"
        failures=$((failures + 1))
    }
done
holds 'at least 40 wrong scenes' test "$count" -ge 40
written ''

# The manual page is what the program says, and has every option of every command.
"$program" --man > man.1 || failures=$((failures + 1))
holds 'the manual page of the build is another' cmp -s man.1 "$page"
for command in '' plan solve lcp friction qp; do
    for option in $("$program" $command --help | grep -Eo '^ +(-h,)?--[a-z]+' | sed 's/.*--/--/'); do
        holds "no $option on the manual page" grep -Fq -- "$(printf '%s' "$option" | sed 's/-/\\-/g')" man.1
    done
done

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
    lost --man
    lost solve "$cantilever" --json
    lost solve "$path"
    lost qp --help
fi

json() { # status, arguments: valid, and on standard output alone
    wanted=$1
    shift
    "$program" "$@" --json > out.json 2> errors
    status=$?
    sed -i '/has taken .* more than 10 times /d' errors  # a busy machine
    [ "$status" -eq "$wanted" ] && [ ! -s errors ] || { echo "signorini $* --json: status $status, expected $wanted"; failures=$((failures + 1)); }
    if command -v python3 > /dev/null 2>&1; then
        python3 -m json.tool out.json > /dev/null || { echo "signorini $* --json: no valid JSON"; failures=$((failures + 1)); }
    fi
    if grep -Eiq '(nan|inf)\b' out.json; then echo "signorini $* --json: has a number that JSON has not"; failures=$((failures + 1)); fi
}
cp immovable 'a "name" \ with	marks'
json 0 qp "$qp/HS35.txt" --solver all
json 0 lcp "$data/generated/fathi_spd_lemke_exponential.txt" --solver all
json 0 friction "$fc/FrictionContactProblem00394.dat" --solver all
holds 'no differences in JSON' grep -Fq '"differences"' out.json
json 0 friction "$data/found/friction_corner_node.txt"
holds 'no undetermined forces in JSON' test "$(grep -c '"least"' out.json)" -eq 4
json 0 qp twice
holds 'no undetermined multipliers in JSON' test "$(grep -c '"least": -2' out.json)" -eq 2
json 1 lcp asymmetric --solver primal_dual_active_set
json 1 lcp 'a "name" \ with	marks' --solver all
json 1 qp contradiction --solver all
json 0 plan "$examples/punch.toml"
json 0 solve "$examples/punch.toml"
for word in '"on"' '"predicted"' '"trust": "exact"' '"certificate"' '"ledger"' '"pairs"' '"shear_traction"' '"motion"' '"units"' '"punch.bottom on block.top"' '"notes"'; do
    holds "no $word in JSON" grep -Fq "$word" out.json
done
json 1 solve lifted.toml
json 1 solve pulled.toml
holds 'good steps in JSON' test "$(grep -c '"step": [0-9]' out.json)" -eq 2
json 0 solve "$path"
holds 'all steps in JSON' test "$(grep -c '"step": [0-9]' out.json)" -eq 51
[ "$failures" -eq 0 ]
