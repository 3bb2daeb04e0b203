#!/usr/bin/perl
# judge.pl ex6.1 FILE TESTS [HELDOUT]   runs the program TESTS and, when it passes, HELDOUT: what fails, then the verdict on FILE
# judge.pl starter PROGRAM [TESTS ...]  a starter must fail a check of its tests: one that passes, crashes or does not run is refused
# Exit status: 0 if that is so, 1 if not, 2 for other arguments.  tools/grade.pl judges whole folders with the same run_tests().
#
# A program is right if its tests say so to this judge by a secret, tests/tools/judged.cpp.  What it prints, and its exit status,
# prove nothing: an answer may print or exit as well.
use strict;
use warnings;
use Config;
use File::Temp qw(tempdir);
use POSIX ();

our $most_printed = 1 << 20;    # bytes
our $memory       = 1 << 31;    # bytes of addresses

# Runs a command in a session of its own, with what it prints in the file $into; $enter is called in the new process, $attend in
# this one meanwhile.  Returns (wait status, seconds of processor time, whether $wall seconds were over).
sub run_limited {
    my ($wall, $into, $enter, $attend, @command) = @_;
    my @before = times;
    my $pid    = fork // die "cannot start a process: $!\n";
    if (!$pid) {
        POSIX::setsid();
        if (open(STDIN, '<', '/dev/null') && open(STDOUT, '>', $into) && open(STDERR, '>&', \*STDOUT)) {
            $enter->();
            POSIX::close($_) for 5 .. 255;
            no warnings 'exec';
            exec { $command[0] } @command;
            syswrite STDOUT, "$command[0]: $!\n";
        }
        POSIX::_exit(127);
    }
    my $over = 0;
    local $SIG{ALRM} = sub { $over = 1; kill KILL => -$pid, $pid };
    alarm $wall;
    $attend->();
    1 while waitpid($pid, 0) == -1 && $!{EINTR};
    my $status = $?;
    alarm 0;
    kill KILL => -$pid;    # what a compiler may have left
    my @after = times;
    return ($status, sprintf('%.2f', abs($after[2] + $after[3] - $before[2] - $before[3])), $over);
}

sub slurp {
    my ($file) = @_;
    open my $in, '<', $file or die "cannot read $file: $!\n";
    local $/;
    return <$in> // '';
}

# Runs the tests of a program, or of [program, arguments], in $folder.  Returns a hash: status (passed, failed, crashed, timed out, out of memory, forbidden,
# fake), message (the first thing that is wrong), said (all that it printed), seconds, names of the test cases in their order,
# tests (name => [assertions passed, failed]), enclosed.  With $reads it may read files.  With $reference, the result of the reference solution, what passes must
# have ended the same test cases.
sub run_tests {
    my ($program, $folder, $seconds, $reads, $reference) = @_;
    open my $random, '<:raw', '/dev/urandom' or die "no /dev/urandom: $!\n";
    sysread($random, my $bytes, 32) == 32 or die "cannot read /dev/urandom\n";
    my $secret = unpack 'H*', $bytes;
    pipe my $from_judge, my $to_program or die "no pipe: $!\n";
    pipe my $from_program, my $to_judge or die "no pipe: $!\n";
    my $told  = '';
    my $enter = sub {
        POSIX::dup2(fileno $from_judge, 30), POSIX::dup2(fileno $to_judge, 31);
        POSIX::dup2(30, 3), POSIX::dup2(31, 4);
        %ENV = (PATH => '/usr/bin:/bin', SIGNORINI_JUDGED => "$seconds $memory $most_printed $reads");
        chdir $folder;
    };
    my $listen = sub {
        close $from_judge;
        close $to_judge;
        local $SIG{PIPE} = 'IGNORE';
        syswrite $to_program, "$secret\n";
        close $to_program;
        while (length $told < 16 * $most_printed) {
            my $n = sysread $from_program, $told, 65536, length $told;
            last if defined $n ? $n == 0 : !$!{EINTR};
        }
        close $from_program;
    };
    # The wall is for a program that waits for ever: on a busy machine a tenth of a processor is enough.
    my ($wait, $used, $over) = run_limited(10 * $seconds, "$folder/said", $enter, $listen, ref $program ? @$program : $program);

    my %is = (seconds => $used, said => slurp("$folder/said"), names => [], tests => {}, enclosed => 0);
    my $ended = 0;
    for (split /\n/, $told) {
        if (/^$secret\tend\t(\w+)$/) { $ended = 1; $is{enclosed} = $1 eq 'enclosed' }
        elsif (/^$secret\t(\d+)\t(\d+)\t(.*)$/) {
            push @{ $is{names} }, $3;
            $is{tests}{$3} = [$1, $2];
        }
    }
    my @failed = grep { $is{tests}{$_}[1] } @{ $is{names} };
    $is{passed} = @{ $is{names} } - @failed;
    my $judged = sub { @is{qw(status message)} = @_; return \%is };

    my ($signal, $code) = ($wait & 127, $wait >> 8);
    my $name = 'SIG' . (split ' ', $Config{sig_name})[$signal];
    return $judged->('timed out', 'stopped after ' . 10 * $seconds . ' seconds of waiting') if $over;
    return $judged->('timed out', "stopped after $seconds seconds")
        if $name eq 'SIGXCPU' || ($name eq 'SIGKILL' && $used >= $seconds);
    return $judged->('forbidden', 'asks the system for what no answer needs: a process, a signal, a socket or a file to write')
        if $name eq 'SIGSYS';
    return $judged->('forbidden', "prints more than $most_printed bytes") if $name eq 'SIGXFSZ';
    return $judged->('out of memory', "asks for more than $memory bytes")
        if ($signal || @failed) && $is{said} =~ /^\s*(?:what\(\):\s+)?std::bad_alloc$/m;
    return $judged->('crashed', "ended by $name" . (@failed ? " in '$failed[-1]'" : ' before the tests were through'))
        if $signal;
    if (!$ended) {
        return $judged->('fake', 'ends as if it were right before the tests are through') if !$code;
        return $judged->('crashed', "ends with status $code before the tests are through");
    }
    if (@failed || $code) {
        my $how = '';
        if ($is{said} =~ /FAILED:\n(.*?)\n(?:\n|\z)/s) {
            $how = $1 =~ s/\nwith expansion:/, that is/r =~ s/\nwith messages?:.*//sr =~ s/\{Unknown expression.*?\}//r =~ s/\s+/ /gr =~ s/\A //r;
        }
        return $judged->('failed', join ': ', @failed ? $failed[0] : "ends with status $code", $how || ());
    }
    if ($reference) {
        return $judged->('fake', 'its test cases are not those of the exercise')
            if join("\n", sort @{ $is{names} }) ne join("\n", sort @{ $reference->{names} });
        my ($idle) = grep { $reference->{tests}{$_}[0] && !$is{tests}{$_}[0] } @{ $is{names} };
        return $judged->('fake', "nothing is checked in '$idle'") if defined $idle;
    }
    return $judged->('fake', 'nothing was tested') if !@{ $is{names} };
    return $judged->('passed', '');
}

# What Catch2 says of the test case that fails first, without its rulers: at most three checks.  Then the names of the others.
sub first_failure {
    my ($is) = @_;
    my ($before, @parts) = split /^-{79}\n/m, $is->{said};
    while (my ($name, $body) = splice @parts, 0, 2) {
        my @checks = ($body // '') =~ /^(\S+:\d+: FAILED:\n.*?)\n(?:\n|\z)/gms or next;
        my $more = @checks - 3;
        my @others = grep { $is->{tests}{$_}[1] && "$_\n" ne $name } @{ $is->{names} };
        for (@checks) {
            my %said;
            $_ = join "\n", grep { !/ := / || !$said{$_}++ } split /\n/, s{^\S*/}{}r;
        }
        return join '', $before, $name, map({ "$_\n" } @checks[0 .. ($more > 0 ? 2 : $#checks)]), $more > 0 ? "and $more more of this test\n" : (),
            map { "fails too: $_\n" } @others;
    }
    return;
}

sub show {    # what a program printed, without the greeting of Catch2, and what it did not say itself
    my ($is) = @_;
    $is->{said} =~ s/^~~~~.*?^Run with -\?[^\n]*\n//ms;
    $is->{said} =~ s/\A\n*(?:Filters: .*\n)?\n*//;
    my $said = first_failure($is) // $is->{said};
    print $said;
    print "\n" if length $said && $said !~ /\n\z/;
    print "$is->{status}: $is->{message}\n" if $is->{status} !~ /^(?:passed|failed)$/;
}

sub judge {
    my ($exercise, $file, @programs) = @_;
    my @when_wrong = ('not yet', 'right on the tests that you see, not yet on the held-out ones');
    my $folder     = tempdir(CLEANUP => 1);
    for my $k (0 .. $#programs) {
        my $is = run_tests($programs[$k], $folder, 120, 1);
        next if $is->{status} eq 'passed';
        show($is);
        print "$exercise: $when_wrong[$k]; edit $file, then make $exercise again\n";
        return 1;
    }
    print "$exercise: right", @programs > 1 ? ', also on the held-out tests' : '', "\n";
    return 0;
}

sub starter {
    my ($program) = @_;
    my $is = run_tests($program, tempdir(CLEANUP => 1), 120, 1);
    show($is);
    if ($is->{status} eq 'passed') {
        print "The tests pass: attempt.cpp is no starter.  If it is your own answer, well done; 'git stash' brings\n",
            "the starter back, and 'make exN.K' is the command that checks answers.\n";
    } elsif ($is->{status} ne 'failed') {
        print "The starter should fail a check.\n";
    } else {
        print "The starter fails as it should.\n";
    }
    return $is->{status} eq 'failed' ? 0 : 1;
}

if (!caller) {
    require File::Spec;
    $| = 1;
    if (@ARGV > 1 && $ARGV[0] eq 'starter') { exit starter([File::Spec->rel2abs($ARGV[1]), @ARGV[2 .. $#ARGV]]) }
    if (@ARGV == 3 || @ARGV == 4) { exit judge(@ARGV[0, 1], map { File::Spec->rel2abs($_) } @ARGV[2 .. $#ARGV]) }
    print STDERR "judge.pl ex6.1 FILE TESTS [HELDOUT], or judge.pl starter PROGRAM [TESTS ...]\n";
    exit 2;
}
1;
