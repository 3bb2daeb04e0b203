#!/usr/bin/env perl
# run.pl [WORDS...]: puts the faults of list.txt into a copy of the project, one at a time, and says which test notices each.
# With WORDS only the faults whose line has one of them: a folder, a file, some of what is wrong.  The copy is build/faults; build/faults/results.txt keeps what is
# known, so a run that was stopped goes on where it was: delete a line to try its fault again, the file to begin anew.
# Ends with 1 if a fault survives, cannot be put in, or does not compile.  --check only says which faults cannot be put in.
use strict;
use warnings;
use File::Basename;
use File::Compare;
use File::Copy;
use File::Path 'make_path';
use Cwd 'abs_path';

my $root = abs_path(dirname(__FILE__) . '/../..');
my $copy = "$root/build/faults";
my $known = "$copy/results.txt";
my $seconds = 300;    # one test program may take; a fault that makes it run for ever is noticed
my @words = @ARGV;
my $check = @words == 1 && $words[0] eq '--check';
my %of_command = (command => 1, printed => 1, transcripts => 1);    # tests of ctest that run the program `signorini`; all others are programs
sub target { my ($test) = @_; return $of_command{$test} ? 'signorini_command' : "test_$test" }

sub contents { my ($path) = @_; open my $in, '<', $path or die "$path: $!\n"; local $/; return <$in> }
sub put { my ($path, $text) = @_; open my $out, '>', $path or die "$path: $!\n"; print $out $text; close $out or die "$path: $!\n" }
sub note { my ($line) = @_; print "$line\n"; open my $out, '>>', $known or die "$known: $!\n"; print $out "$line\n"; close $out }
$| = 1;

# The list.
my @faults;
open my $list, '<', dirname(__FILE__) . '/list.txt' or die "list.txt: $!\n";
while (<$list>) {
    if    (/^@ (\S+) \| (.+) \| (.+)$/) { push @faults, {file => $1, what => $2, tests => [split ' ', $3], from => '', to => ''} }
    elsif (/^-(.*)$/s)                 { $faults[-1]{from} .= $1 }
    elsif (/^\+(.*)$/s)                { $faults[-1]{to} .= $1 }
    elsif (!/^(#.*)?$/)                { die "list.txt:$.: a line begins with @, -, + or #, got: $_" }
}
for (@faults) { if ($_->{to} ne '') { chomp $_->{from}; chomp $_->{to} } }

# Why a fault cannot be put in, empty if it can.
sub stale {
    my ($fault) = @_;
    my $path = "$root/src/$fault->{file}";
    return 'there is no such file' if !-f $path;
    my $times = () = contents($path) =~ /\Q$fault->{from}\E/g;
    return "its text stands there $times times" if $times != 1;
    my $programs = contents("$root/tests/CMakeLists.txt");    # those that are no room's
    my @absent = grep { !$of_command{$_} && !-d "$root/tests/$_" && $programs !~ /\btest_$_\b/ } @{$fault->{tests}};
    return @absent ? "there is no test_$absent[0]" : '';
}
if ($check) {
    my $bad = 0;
    for (@faults) { my $why = stale($_); $bad |= $why ne '' && print "tests/faults/list.txt: $_->{file} | $_->{what}: $why\n" }
    exit($bad);
}

# The copy as the project is now, whatever the last run left; what is as it was keeps its date, and so its objects.
chdir $root or die "$root: $!\n";
if (-d $copy) { for my $file (split /\n/, `cd '$copy' && find src tests -type f`) { unlink "$copy/$file" if !-f $file } }
for my $file (split /\0/, `git ls-files -z --cached --others --exclude-standard`) {
    next unless -f $file;
    next if -f "$copy/$file" && compare($file, "$copy/$file") == 0;
    make_path(dirname("$copy/$file"));
    copy($file, "$copy/$file") or die "$file: $!\n";
    chmod 0755, "$copy/$file" if -x $file;
}
my %result;
if (-f $known) { /^(\w+) (.* \| .*?)(?:: by .*)?$/ and $result{$2} = $1 for split /\n/, contents($known) }

sub compiles { my (@tests) = @_; return system('nice', 'cmake', '--build', "$copy/build", '-j', '2', '--target', map { target($_) } @tests) == 0 }
# The first test case that fails, with its sections, empty if none does.  Catch2 breaks long names over lines.
sub failure {
    my ($test) = @_;
    my $run = $of_command{$test} ? "ctest --test-dir $copy/build -R '^$test\$' --output-on-failure" : "$copy/build/bin/test_$test --abort";
    my $said = `timeout $seconds nice $run 2>&1`;
    return '' if $? == 0;
    return "no end after $seconds s" if $? >> 8 == 124;
    return $1 if $of_command{$test} && $said =~ /\*\*\*Failed.*\n(.+)/;
    return $said =~ /^-{70,}\n(.+?)\n-{70,}\n/ms ? $1 =~ s/\s*\n\s*/ /gr : $? & 127 ? 'signal ' . ($? & 127) : 'status ' . ($? >> 8);
}
chdir $copy or die "$copy: $!\n";
open STDERR, '>', "$copy/build.log";
open my $terminal, '>&', STDOUT or die $!;
sub quietly { my ($do) = @_; open STDOUT, '>>', "$copy/build.log"; my $good = $do->(); open STDOUT, '>&', $terminal; return $good }
quietly(sub { system('cmake', '--preset', 'release', '--log-level=NOTICE') == 0 }) or die "cmake: see $copy/build.log\n";

my %sound;    # programs that pass without a fault
for my $fault (@faults) {
    my $name = "$fault->{file} | $fault->{what}";
    next if @words && !grep { index("$name | @{$fault->{tests}}", $_) >= 0 } @words;
    next if $result{$name};
    if (my $why = stale($fault)) { $result{$name} = 'stale'; note("stale $name: by nobody: $why"); next }
    my $path = "$copy/src/$fault->{file}";
    my $text = contents($path);
    for my $test (grep { !$sound{$_}++ && !$result{"whole | $_"} } @{$fault->{tests}}) {
        quietly(sub { compiles($test) }) or die target($test), " does not compile, see $copy/build.log\n";
        my $case = failure($test);
        die "$test fails without a fault: $case\n" if $case ne '';
        $result{"whole | $test"} = 'passes';
        note("passes whole | $test");
    }
    (my $wrong = $text) =~ s/\Q$fault->{from}\E/$fault->{to}/;
    put($path, $wrong);
    my $found = '';
    for my $test (@{$fault->{tests}}) {
        if (!quietly(sub { compiles($test) })) { $found = 'faulty'; note("faulty $name: by the compiler, see $copy/build.log"); last }
        my $case = failure($test);
        if ($case ne '') { $found = 'killed'; note("killed $name: by $test: $case"); last }
    }
    note("survived $name: by @{$fault->{tests}}") if $found eq '';
    $result{$name} = $found || 'survived';
    put($path, $text);
}

my %count = (killed => 0, survived => 0);
for my $fault (@faults) { $count{$result{"$fault->{file} | $fault->{what}"} || 'not tried'}++ }
print join(', ', map { "$_ $count{$_}" } sort keys %count), " of ", scalar @faults, " faults\n";
exit($count{killed} + ($count{'not tried'} || 0) == @faults ? 0 : 1);
