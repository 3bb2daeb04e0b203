#!/usr/bin/perl
# grade.pl [--seconds N] FOLDER BUILD [INTO]   grades the answers in FOLDER/STUDENT/ex6.1.cpp or FOLDER/STUDENT/ex6.1/attempt.cpp
# Writes grades.csv and grades.xml (JUnit), a row for every file, into INTO, BUILD/grade if it is not said, and says them; what the
# compiler and the tests said of each is in INTO/work.  JOBS answers are judged at a time.
# Exit status: 0 if all that was found has its row, whatever it says, 2 if nothing could be graded.
#
# Each answer is compiled alone, in a folder of its own, and linked with the tests and the library as they are; its programs run
# enclosed, tests/tools/judged.cpp, and are judged by what they tell by a secret, tools/judge.pl, beside the reference solution.
# What passes has to be its author's own, tools/borrowed.pl.
# A program may take N seconds of processor time, ten if it is not said, or twenty times those of the reference solution.
use strict;
use warnings;
use Cwd qw(abs_path);
use Encode ();
use File::Basename qw(dirname);
use File::Copy qw(copy);
use File::Path qw(make_path remove_tree);
use JSON::PP ();
use POSIX ();
use Text::ParseWords qw(shellwords);

my $root = abs_path(dirname(__FILE__) . '/..');
require "$root/tools/$_.pl" for qw(judge borrowed);

my @columns = qw(student exercise file status public public_of heldout heldout_of seconds message);
my $largest = 1 << 20;      # bytes of an answer
my %compile = (seconds => 120, kilobytes => 4 << 20, blocks => 1 << 18);    # a block has 512 bytes

sub refuse { print STDERR "grade.pl: @_\n"; exit 2 }

sub entries {
    my ($folder) = @_;
    opendir my $in, $folder or refuse("cannot read $folder: $!");
    return sort grep { !/^\./ } readdir $in;
}

# Rows of all that lies in the folder: those with a status cannot be graded.
sub collect {
    my ($folder, $known) = @_;
    my @rows;
    my $row = sub {
        my ($student, $exercise, $file, $status, $message) = @_;
        push @rows, { student => $student, exercise => $exercise, file => $file, status => $status, message => $message };
    };
    for my $student (entries($folder)) {
        my $home = "$folder/$student";
        if (-l $home || !-d $home) { $row->('', '', $student, 'no such exercise', "expected a folder for each student"); next }
        my @files = entries($home);
        $row->($student, '', '', 'no such exercise', 'the folder is empty') if !@files;
        for my $entry (@files) {
            my ($chapter, $number, $ending) = $entry =~ /^ex(\d+)\.(\d+)(\.cpp)?$/;
            my $file = defined $number && !$ending ? "$entry/attempt.cpp" : $entry;
            my $path = "$home/$file";
            if (!defined $number) {
                $row->($student, '', $file, 'no such exercise', 'expected exN.K.cpp or exN.K/attempt.cpp');
            } elsif (!$known->{"ex$chapter.$number"}) {
                $row->($student, "ex$chapter.$number", $file, 'no such exercise', 'the book does not have it');
            } elsif (-l $path || -l "$home/$entry" || !-f $path) {
                $row->($student, "ex$chapter.$number", $file, 'forbidden', 'is not there, or no plain file');
            } elsif (-s $path > $largest) {
                $row->($student, "ex$chapter.$number", $file, 'forbidden', "has more than $largest bytes");
            } else {
                $row->($student, "ex$chapter.$number", $file);
            }
        }
    }
    my $place = sub { map { sprintf '%06d', $_ } $_[0]{exercise} =~ /(\d+)/g };
    return sort { $a->{student} cmp $b->{student} || join('.', $place->($a)) cmp join('.', $place->($b)) || $a->{file} cmp $b->{file} }
        @rows;
}

# What CMake wrote about an exercise, and the command that compiles attempt.cpp without its input and output.
sub parts_of {
    my ($exercise, $build, $commands) = @_;
    my %parts;
    for (split /\n/, slurp("$build/grade/parts/$exercise")) {
        my ($key, @words) = shellwords($_);
        $parts{$key} = \@words;
    }
    my $command = $commands->{"$parts{folder}[0]/attempt.cpp"} // refuse("$build does not say how to compile $exercise");
    $parts{compile} = [compile_words($command)];
    return \%parts;
}

# Symbols of object files and libraries of the types in the pattern: name => type, as nm has them.
sub symbols {
    my ($wanted, @files) = @_;
    my %type;
    open my $nm, '-|', 'nm', '-P', @files or refuse("no nm: $!");
    while (<$nm>) { $type{$1} = $2 if /^(\S+) ($wanted) / }
    close $nm;
    return \%type;
}

# What an answer has that no answer needs: what it includes, defines or uses that belongs to the tests, the library or the language.
sub suspicion {
    my ($folder, $taken) = @_;
    my ($included) = grep { /\.cpp$/ && $_ ne 'attempt.cpp' } split /[\s\\]+/, slurp("$folder/answer.d");
    return "includes $included" if defined $included;
    my $types = symbols('\w', "$folder/answer.o");
    for my $name (sort keys %$types) {
        my $type = $types->{$name};
        my $what = sub { open my $in, '-|', 'c++filt', $name or refuse("no c++filt: $!"); return "$_[0] " . <$in> =~ s/\n//r };
        next if $name =~ /^DW\.ref\./;
        return $what->('uses, as only tests do,') if $name =~ /^_Z.*5Catch/;
        next if $type =~ /[Ua-z]/ && $type !~ /[ui]/;    # defined elsewhere, or seen nowhere else
        return $what->('defines') if $name !~ /^_Z/ || $type eq 'i' || $taken->{$name};
        return $what->('defines') if $type =~ /[TDBR]/ && $name =~ /^_Z(?:N?K?S|n[wa]|d[la]|N9__gnu_cxx|N10__cxxabiv1)/;
    }
    return;
}

# What an answer that passes tests has from the book, tools/borrowed.pl.
sub own_work {
    my ($row, $folder, $parts) = @_;
    my $compiled = tool($folder, 'plain', @{ $parts->{compile} }, qw(-O0 -w -MD -MF plain.d -o plain.o -c attempt.cpp));
    return $compiled ? borrowed($row->{exercise}, $parts->{folder}[0], map { "$folder/$_" } qw(attempt.cpp plain.o plain.d))
        : 'does not compile without optimisation';
}

# Runs a tool on an answer, limited; says whether it succeeded.
sub tool {
    my ($folder, $into, @command) = @_;
    my $limited = "ulimit -t $compile{seconds}; ulimit -v $compile{kilobytes}; ulimit -f $compile{blocks}; exec \"\$@\"";
    my ($status) = run_limited(10 * $compile{seconds}, "$folder/$into", sub { chdir $folder; $ENV{LC_ALL} = 'C' }, sub { },
        '/bin/sh', '-c', $limited, 'sh', @command);
    return $status == 0;
}

# Compiles, links and runs one answer, and fills its row.
sub grade {
    my ($row, $source, $folder, $parts, $taken, $reference) = @_;
    my $is = sub { @$row{qw(status message)} = @_ };
    @$row{qw(public public_of heldout heldout_of seconds)} =
        (0, scalar @{ $reference->{tests}{names} }, 0, scalar @{ $reference->{heldout}{names} }, 0);
    make_path($folder);
    copy($source, "$folder/attempt.cpp") && copy("$parts->{folder}[0]/exercise.hpp", "$folder/exercise.hpp")
        or die "cannot copy $source: $!\n";
    if (!tool($folder, 'compiler', @{ $parts->{compile} }, qw(-MD -MF answer.d -o answer.o -c attempt.cpp))) {
        my $said = slurp("$folder/compiler");
        return $is->('does not compile', $said =~ /attempt\.cpp:(\d+)(?::\d+)?: (?:fatal )?error: (.*)/ ? "line $1: $2"
            : $said =~ /error: (.*)/i ? $1 : "the compiler stopped; it may take $compile{seconds} seconds and $compile{kilobytes} kB");
    }
    if (my $reason = suspicion($folder, $taken)) { return $is->('fake', $reason) }
    for my $which (qw(tests heldout)) {
        # The answer comes after what it could replace.
        my @all = (@{ $parts->{judge} }, @{ $parts->{$which} }, @{ $parts->{libraries} }, 'answer.o', @{ $parts->{libraries} });
        if (!tool($folder, 'linker', @{ $parts->{link} }, @all, '-o', $which)) {
            return $is->('does not compile', slurp("$folder/linker") =~ /((?:undefined reference|multiple definition).*)/ ? $1
                : 'cannot be linked');
        }
        my $result = run_tests("$folder/$which", $folder, @$reference{qw(seconds reads)}, $reference->{$which});
        rename "$folder/said", "$folder/$which.txt";
        unlink "$folder/$which";
        $row->{seconds} += $result->{seconds};
        $row->{ $which eq 'tests' ? 'public' : 'heldout' } = $result->{passed};
        next if $result->{status} eq 'passed';
        return $is->(@$result{qw(status message)}) if $which eq 'tests' || $result->{status} =~ /^(?:fake|forbidden)$/;
        $is->('public only', join ': ', grep { $_ ne 'failed' } @$result{qw(status message)});
        last;
    }
    if (my $reason = own_work($row, $folder, $parts)) { return $is->('borrowed', $reason) }
    return if $row->{status};
    return $is->('passed', '');
}

sub text {    # on one line, without what XML cannot hold
    my $plain = Encode::decode('UTF-8', $_[0] // '');
    $plain =~ s/[\x00-\x1f\x7f]+|[^\x20-\x{d7ff}\x{e000}-\x{fffd}\x{10000}-\x{10ffff}]/ /g;
    return $plain;
}

sub csv {
    my @lines;
    for my $row ({ map { $_ => $_ } @columns }, @_) {
        push @lines, join ',', map { /[",]/ ? '"' . s/"/""/gr . '"' : $_ } map { text($row->{$_}) } @columns;
    }
    return join '', map { "$_\n" } @lines;
}

sub junit {
    my %escaped = ('&' => '&amp;', '<' => '&lt;', '>' => '&gt;', '"' => '&quot;');
    my $quoted  = sub { '"' . text($_[0]) =~ s/([&<>"])/$escaped{$1}/gr . '"' };
    my (@students, %cases);
    for my $row (@_) {
        push @students, $row->{student} if !$cases{ $row->{student} };
        push @{ $cases{ $row->{student} } }, $row;
    }
    my $out = qq(<?xml version="1.0" encoding="UTF-8"?>\n<testsuites>\n);
    for my $student (@students) {
        my @cases = @{ $cases{$student} };
        $out .= sprintf qq(  <testsuite name=%s tests="%d" failures="%d">\n), $quoted->($student), scalar @cases,
            scalar grep { $_->{status} ne 'passed' } @cases;
        for my $row (@cases) {
            $out .= sprintf '    <testcase classname=%s name=%s time="%.2f"', $quoted->($student),
                $quoted->($row->{exercise} || $row->{file}), $row->{seconds} || 0;
            $out .= $row->{status} eq 'passed' ? "/>\n"
                : '><failure type=' . $quoted->($row->{status}) . ' message=' . $quoted->($row->{message}) . "/></testcase>\n";
        }
        $out .= "  </testsuite>\n";
    }
    return "$out</testsuites>\n";
}

sub write_whole {
    my ($file, $content) = @_;
    open my $out, '>:encoding(UTF-8)', "$file.part" or refuse("cannot write $file: $!");
    print $out $content;
    close $out or refuse("cannot write $file: $!");
    rename "$file.part", $file or refuse("cannot write $file: $!");
}

my $seconds = 10;
if (@ARGV && $ARGV[0] eq '--seconds') {
    shift @ARGV;
    $seconds = shift @ARGV;
    refuse('--seconds takes a whole number of seconds') if !defined $seconds || $seconds !~ /^[1-9]\d{0,5}$/;
}
refuse('expected a folder with a folder for each student, in it ex6.1.cpp or ex6.1/attempt.cpp: make grade DIR=folder')
    if @ARGV < 2 || @ARGV > 3 || !-d $ARGV[0];
my ($folder, $build) = map { abs_path($_) // refuse("no folder $_") } @ARGV[0, 1];
my $into = $ARGV[2] // "$build/grade";
my $jobs = ($ENV{JOBS} // 1) =~ /^([1-9]\d*)$/ ? $1 : 1;
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL)};
umask 022;
$| = 1;

my %known = map { $_ => 1 } -d "$build/grade/parts" ? entries("$build/grade/parts") : ();
refuse("$build has no reference solutions to grade by; a hand-out has none") if !%known;
my @rows = collect($folder, \%known);
refuse("nothing lies in $ARGV[0]") if !@rows;

make_path($into);
$into = abs_path($into) // refuse("cannot make $into");

# The reference solutions, compiled with the tests, and run as answers are.
my @wanted = sort keys %{ { map { $_->{exercise} => 1 } grep { !$_->{status} } @rows } };
if (@wanted) {
    print "compiling the tests and reference solutions of @wanted\n";
    my @targets = map { ("$_.solution", "$_.solution-heldout") } @wanted;
    my ($status) = run_limited(0, "$into/reference.log", sub { }, sub { }, 'cmake', '--build', $build, '-j', $jobs, '--target', @targets);
    refuse("they do not compile, see $into/reference.log") if $status;
}
# That of the exercise alone: its starter is compiled a second time, beside the tests of all.
my $commands = { map { $_->{file} => $_->{command} } grep { $_->{command} =~ m{_attempt\.dir/} } @{ JSON::PP::decode_json(slurp("$build/compile_commands.json")) } };
my $work = "$into/work";
remove_tree($work);
make_path($work);
my (%parts, %taken, %reference, %library);
for my $exercise (@wanted) {
    my $parts = $parts{$exercise} = parts_of($exercise, $build, $commands);
    my $longest = 0;
    for my $which (qw(tests heldout)) {
        my $program = "$build/bin/$exercise.solution" . ($which eq 'tests' ? '' : '-heldout');
        my $result;
        for my $reads (0, 1) {    # answers may read files only if the reference solution has to
            $result = $reference{$exercise}{$which} = run_tests($program, $work, 300, $reads);
            $reference{$exercise}{reads} |= $reads;
            last if $result->{status} eq 'passed';
        }
        refuse("the reference solution of $exercise: $result->{status}, $result->{message}") if $result->{status} ne 'passed';
        refuse('answers cannot be enclosed here: this needs Linux on x86-64 or AArch64') if !$result->{enclosed};
        $longest = $result->{seconds} if $result->{seconds} > $longest;
    }
    $reference{$exercise}{seconds} = POSIX::ceil(20 * $longest > $seconds ? 20 * $longest : $seconds);
    my $library = $library{"@{ $parts->{libraries} }"} //= symbols('[TDBRi]', grep { !/^-/ } @{ $parts->{libraries} });
    $taken{$exercise} = { %$library, %{ symbols('[TDBRi]', map { @{ $parts->{$_} } } qw(judge tests heldout)) } };
}

my %running;
my $collected = sub {
    my $i = delete $running{ wait() };
    my $file = "$work/$i.json";
    $rows[$i] = -s $file ? JSON::PP::decode_json(slurp($file)) : { %{ $rows[$i] }, status => 'not judged', message => 'see above' };
    unlink $file;
};
for my $i (0 .. $#rows) {
    next if $rows[$i]{status};
    $collected->() if keys %running >= $jobs;
    my $pid = fork // refuse("cannot start a process: $!");
    if ($pid) { $running{$pid} = $i; next }
    my $row = $rows[$i];
    my $place = sprintf '%s/%04d-%s-%s', $work, $i, $row->{student} =~ s/[^\w.-]/_/gr, $row->{exercise};
    eval {
        grade($row, "$folder/$row->{student}/$row->{file}", $place, map { $_->{ $row->{exercise} } } \(%parts, %taken, %reference));
        write_whole("$work/$i.json", JSON::PP->new->ascii->encode($row));
        1;
    } or print STDERR "grade.pl: $row->{student} $row->{exercise}: $@";
    POSIX::_exit(0);
}
$collected->() while %running;

write_whole("$into/grades.csv", csv(@rows));
write_whole("$into/grades.xml", junit(@rows));
my %count;
binmode STDOUT, ':encoding(UTF-8)';
for my $row (@rows) {
    ++$count{ $row->{status} };
    printf "%-20s %-8s %-17s %s\n", map { text($_) } $row->{student}, $row->{exercise} || $row->{file}, @$row{qw(status message)};
}
print join(', ', map { "$count{$_} $_" } sort keys %count), "\n$into/grades.csv\n$into/grades.xml\n";
exit($count{'not judged'} ? 2 : 0);
