#!/usr/bin/perl
# submissions.pl ROOT BUILD FOLDER [--update] [EXERCISE...]: judges the answers in tests/exercises as tools/grade.pl would: those of `right`
# pass and are their authors' own, those of `wrong` fail a test, and those of `dishonest` fail or are found out.
# The solutions pass as well.
#
# An answer is the solution with some lines replaced, or a source of its own:
#   ex6.1 what is different     a new answer
#   - old                       lines that the solution has just once; blanks do not matter
#   + new                       what stands there instead; without old lines the whole answer
#   > said                      how a test fails, or what is found, as the sheet of instructors says it; --update writes these lines,
#                               else the check that fails has to be the same
# Each is compiled once, without optimisation, and linked in front of the solutions, so that the linker takes it and not what it replaces.
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename qw(dirname);
use File::Path qw(make_path remove_tree);
use JSON::PP ();
use POSIX ();
use Text::ParseWords qw(shellwords);

our ($memory, $most_printed);
my $update = grep { $_ eq '--update' } @ARGV;
my ($root, $build, $play, @only) = grep { $_ ne '--update' } @ARGV;
($root, $build) = map { abs_path($_) } $root, $build;
require "$root/tools/$_.pl" for qw(judge borrowed);

sub answers_of {    # kind
    my ($kind) = @_;
    my (@found, $hunk);
    for (split /\n/, slurp("$root/tests/exercises/$kind")) {
        if (/^(ex[\d.]+) (.*)/)   { push @found, { kind => $kind, exercise => $1, what => $2, hunks => [], said => '' }; $hunk = undef }
        elsif (/^- (.*)/)         { push @{ $found[-1]{hunks} }, $hunk = { old => '', new => '' } if !$hunk || $hunk->{new} ne ''; $hunk->{old} .= "$1\n" }
        elsif (/^\+ ?(.*)/)       { push @{ $found[-1]{hunks} }, $hunk = { old => '', new => '' } if !$hunk; $hunk->{new} .= "$1\n" }
        elsif (/^> (.*)/)         { $found[-1]{said} = $1 }
        elsif (/\S/ && !/^#/)     { die "tests/exercises/$kind: cannot read '$_'\n" }
    }
    return @found;
}

sub source_of {
    my ($answer, $folder) = @_;
    my $source = slurp("$folder/solution.cpp");
    for my $hunk (@{ $answer->{hunks} }) {
        my ($old, $new) = map { s/\s+\z//r } @$hunk{qw(old new)};
        return "#include \"exercise.hpp\"\n$new\n" if $old eq '';
        my $pattern = join '\s+', map { quotemeta } split ' ', $old;
        my $times = () = $source =~ /$pattern/g;
        die "$answer->{exercise} $answer->{what}: the solution has '$old' $times times\n" if $times != 1;
        $source =~ s/$pattern/$new/;
    }
    return $source;
}

sub filters { return $_[1] ? ("$_[0] held out*") : ("$_[0] *", "~$_[0] held out*") }

# How a test ended, in the words of the sheet.
sub verdict_of {
    my ($answer, $folder, $place, $command, $reference) = @_;
    open my $out, '>', "$place/attempt.cpp" or die "$place: $!\n";
    print $out source_of($answer, $folder);
    close $out;
    my $run = sub { return system("cd $place && " . join(' ', map { quotemeta } @_) . ' > said 2>&1') == 0 };
    $run->(@$command, "-I$folder", qw(-O0 -w -MD -MF answer.d -o answer.o -c attempt.cpp)) or return 'does not compile: ' . slurp("$place/said");
    my ($compiler, @linked) = shellwords(slurp("$build/submissions"));
    $run->($compiler, 'answer.o', '-Wl,-z,muldefs', @linked, '-o', 'tests') or return 'cannot be linked: ' . slurp("$place/said");
    for my $heldout (0, 1) {
        my $theirs = $reference->($answer->{exercise}, $heldout);
        my $is = run_tests(["$place/tests", filters($answer->{exercise}, $heldout)], $place, 60, $theirs->{reads}, $theirs);
        next if $is->{status} eq 'passed';
        return ($heldout ? 'held out: ' : '') . ($is->{status} eq 'failed' ? '' : "$is->{status}: ") . $is->{message} =~ s/^ex[\d.]+ (?:held out: )?//r;
    }
    my $reason = borrowed($answer->{exercise}, $folder, map { "$place/$_" } qw(attempt.cpp answer.o answer.d));
    return defined $reason ? $reason =~ s/\. An answer to .*//sr : 'right';
}

sub shortened { return length $_[0] > 160 ? substr($_[0], 0, 157) =~ s/\s+\S*$//r . ' ...' : $_[0] }

my %command;
for (@{ JSON::PP::decode_json(slurp("$build/compile_commands.json")) }) {
    $command{$1} = $_ if $_->{command} =~ m{/(ex[\d.]+)_attempt\.dir/};
}
my %known;
my $reference = sub {
    my ($exercise, $heldout) = @_;
    return $known{$exercise}[$heldout] //= do {
        my $is;
        for my $reads (0, 1) {
            $is = { reads => $reads, %{ run_tests(["$build/bin/exercise_solutions", filters($exercise, $heldout)], $play, 300, $reads) } };
            last if $is->{status} eq 'passed';
        }
        die "the solution of $exercise: $is->{status}, $is->{message}\n" if $is->{status} ne 'passed';
        $is;
    };
};
remove_tree($play);
make_path($play);
$play = abs_path($play);
my @answers = map { answers_of($_) } qw(right wrong dishonest);
push @answers, map { { kind => 'solution', exercise => $_, what => 'itself', hunks => [], said => '' } } sort keys %command;
if (@only) { my %only = map { $_ => 1 } @only; @answers = grep { $only{ $_->{exercise} } } @answers }
my $jobs = ($ENV{JOBS} // 2) =~ /^([1-9]\d*)$/ ? $1 : 1;
my @children;
for my $job (0 .. $jobs - 1) {
    my $pid = fork // die "cannot start a process: $!\n";
    if ($pid) { push @children, $pid; next }
    open my $out, '>', "$play/verdicts.$job" or die "$play: $!\n";
    for (my $i = $job; $i < @answers; $i += $jobs) {
        my $place = "$play/$i";
        make_path($place);
        my $entry = $command{ $answers[$i]{exercise} } // die "no exercise $answers[$i]{exercise}\n";
        my $said = eval { verdict_of($answers[$i], dirname($entry->{file}), $place, [compile_words($entry->{command})], $reference) } // "stopped: $@";
        print $out "$i\t", $said =~ s/\s+/ /gr, "\n";
        remove_tree($place);
    }
    close $out;
    POSIX::_exit(0);
}
waitpid $_, 0 for @children;
my (%count, $bad);
for my $job (0 .. $jobs - 1) {
    for (split /\n/, slurp("$play/verdicts.$job")) {
        my ($i, $said) = /^(\d+)\t(.*)/;
        my $answer = $answers[$i];
        my $right  = $said eq 'right';
        my $fits   = $said !~ /^(?:does not compile|cannot be linked|stopped):/ && $right == ($answer->{kind} =~ /^(?:right|solution)$/);
        $said = shortened($said);
        ++$count{ $answer->{kind} } if $fits;
        $answer->{now} = $said;
        my ($check, $before) = map { (split /, that is /)[0] } $said, $answer->{said};    # numbers may round in another way
        next if $fits && ($right || $update || $check eq ($before // ''));
        print "$answer->{kind}: $answer->{exercise} $answer->{what}: $said", $fits ? ", expected $answer->{said}" : '', "\n";
        $bad = 1;
    }
}
if ($update) {
    for my $kind (qw(wrong dishonest)) {
        my %now = map { ("$_->{exercise} $_->{what}" => $_->{now}) } grep { $_->{kind} eq $kind } @answers;
        my @lines;
        my $name;
        for (split /\n/, slurp("$root/tests/exercises/$kind"), -1) {
            next if /^> / && defined $name && defined $now{$name};
            if (!/^[-+>]/) { push @lines, "> $now{$name}" if defined $name && defined $now{$name}; $name = undef }
            $name = $_ if /^ex[\d.]+ /;
            push @lines, $_;
        }
        open my $out, '>', "$root/tests/exercises/$kind" or die "$kind: $!\n";
        print $out join "\n", @lines;
        close $out;
    }
}
print join(', ', map { my $kind = $_; ($count{$kind} // 0) . ' of ' . (grep { $_->{kind} eq $kind } @answers) . " $kind" } qw(right wrong dishonest solution)), "\n";
exit($bad ? 1 : 0);
