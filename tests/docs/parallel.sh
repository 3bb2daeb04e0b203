#!/bin/sh
# parallel.sh MPIRUN PROGRAM EXAMPLES DATA FOLDER: `signorini solve --backend mumps` on several processes finds what it finds alone,
# says it once, and ends with the right status, whichever process meets an error.
set -u
mpirun=$1 program=$2 examples=$3 data=$4 folder=$5
rm -rf "$folder"
mkdir -p "$folder/elsewhere"
cd "$folder" || exit 1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMP_NUM_THREADS=1 ASAN_OPTIONS=detect_leaks=0
failures=0
fail() { echo "$*"; failures=$((failures + 1)); }
on() { # processes, arguments: what solve says is in `said`, what it ends with in `status`
    processes=$1
    shift
    "$mpirun" -np "$processes" "$program" solve "$@" --backend mumps > said 2> errors
    status=$?
}

# The forces of the pairs, and the certificate.
for scene in "$examples"/*.toml; do
    name=$(basename "$scene" .toml)
    "$program" solve "$scene" --csv "$name.csv" --json > alone.json || { fail "$name: not solved"; continue; }
    for processes in $([ "$name" = cantilever ] && echo 2 3 || echo 2); do
        on $processes "$scene" --csv "$name.$processes.csv" --json
        [ $status -eq 0 ] || { fail "$name on $processes: status $status: $(cat errors)"; continue; }
        perl -e '
            use strict; use warnings;
            my ($alone, $several, $json) = @ARGV;
            my (@head, @rows);
            for my $file ($alone, $several) {
                open my $in, "<", $file or die "$file: $!";
                my @lines = grep { !/^#/ } <$in>;
                chomp @lines;
                push @head, shift @lines;
                push @rows, [map { [split /,/] } @lines];
            }
            die "columns differ" unless $head[0] eq $head[1] && @{$rows[0]} == @{$rows[1]};
            my @names = split /,/, $head[0];
            for my $column (grep { $names[$_] =~ /^(force|pressure|shear)/ } 0 .. $#names) {
                my ($most, $difference) = (0, 0);
                for my $row (0 .. $#{$rows[0]}) {
                    my ($a, $b) = map { $rows[$_][$row][$column] } 0, 1;
                    $most = abs $a if abs $a > $most;
                    $difference = abs($a - $b) if abs($a - $b) > $difference;
                }
                die "$names[$column] differs by $difference of $most" if $difference > 1e-10 * $most;
            }
            open my $in, "<", $json or die "$json: $!";
            my $text = join "", <$in>;
            while ($text =~ /"certificate":\s*\{([^}]*)\}/g) {
                my $figures = $1;
                while ($figures =~ /:\s*([-+0-9.e]+|null)/g) { die "certificate $figures" if $1 eq "null" || abs $1 > 1e-12 }
            }
        ' "$name.csv" "$name.$processes.csv" said || fail "$name on $processes processes"
    done
done

# Every process assembles a part of K, but the first, which keeps all of it for the certificate; one alone says what it found.
cantilever=$examples/cantilever.toml
on 3 "$cantilever"
[ "$(grep -c '^certificate: penetration' said)" -eq 1 ] || fail "said more than once, or not at all"
[ "$(grep -Ec '^process [0-2] .*peak bytes [1-9]' said)" -eq 3 ] || fail "no memory of three processes: $(grep '^process' said)"
[ "$(grep -Ec '^process [12] .*stiffness entries [1-9]' said)" -eq 2 ] || fail "a process did not assemble: $(grep '^process' said)"
on 2 "$examples/to_and_fro.toml"
[ "$(grep -Ec '^process [01] .*peak bytes [1-9]' said)" -eq 2 ] || fail "load steps without the memory of two processes: $(grep '^process' said)"
on 1 "$cantilever" --accuracy 1%
[ $status -eq 0 ] && grep -q '^accuracy: met' said && grep -q '^process 0 .*peak bytes [1-9]' said ||
    fail "--accuracy on one process: status $status: $(cat errors)"
on 2 - < "$cantilever"
[ $status -eq 0 ] && grep -q '^certificate: penetration' said || fail "from standard input: status $status"

# Errors.
wrong() { # status, words, what goes before --backend
    wanted=$1 words=$2
    shift 2
    on 2 "$@"
    [ $status -eq "$wanted" ] && [ "$(cat said errors | grep -Ec -- "$words")" -eq 1 ] ||
        fail "$*: status $status, expected $wanted and once '$words', said: $(cat said errors)"
}
{
    printf '[[body]]\nname = "stone"\nmesh = { kind = "block", size = [1, 1], cells = [4, 4] }\nsymmetric = "left"\n'
    printf 'material = { youngs_modulus = 1, poisson_ratio = 0.3 }\npressure = { bottom = 1e-3 }\n'
    printf '[[contact]]\nsource = "bottom"\ntarget = { kind = "half_plane", point = [0, 0], normal = [0, 1] }\n'
} > lifted.toml
wrong 1 "not solved: .*'stone'.*Turn the load round" lifted.toml
wrong 2 'missing: there is no such file' missing
wrong 2 'negative_modulus.toml:[0-9]+: ' "$data/scenes/wrong/negative_modulus.toml"
wrong 2 '--accuracy: the 2 processes that --backend mumps .* without mpirun' "$cantilever" --accuracy 1%
wrong 2 "unknown option '--colour'" "$cantilever" --colour
wrong 2 "cannot write|no such folder|there is no folder" "$cantilever" --csv nowhere/a.csv
# The text of the scene goes to all, the files that it names do not.
cat > "$folder/meshed.toml" << 'END'
[[body]]
name = "beam"
mesh = { kind = "gmsh", file = "beam.msh" }
material = { youngs_modulus = 1, poisson_ratio = 0.3, state = "plane stress" }
fixed = "left"
END
cat > beam.msh << 'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "left"
2 2 "beam"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
2
1 1 2 1 1 4 1
2 3 2 2 1 1 2 3 4
$EndElements
END
on 2 meshed.toml
[ $status -eq 0 ] || fail "meshed.toml: status $status: $(cat errors)"
cp meshed.toml elsewhere
"$mpirun" -np 1 "$program" solve meshed.toml --backend mumps : -np 1 -wdir "$folder/elsewhere" "$program" solve meshed.toml --backend mumps > said 2> errors
status=$?
[ $status -eq 2 ] && [ "$(grep -c 'process 1 of 2: .*beam.msh' errors)" -eq 1 ] ||
    fail "a mesh that only process 0 has: status $status, said: $(cat said errors)"
[ "$failures" -eq 0 ]
