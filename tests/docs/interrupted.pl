#!/usr/bin/env perl
# interrupted.pl PROGRAM FOLDER: interrupts PROGRAM as Ctrl-C does. A run of load steps says what it keeps and how to go on, and what
# goes on ends in the same bits; a run without steps leaves nothing. Writes to FOLDER.
use strict;
use warnings;
use File::Path qw(make_path remove_tree);

my ($program, $folder) = @ARGV;
remove_tree($folder);
make_path($folder);
chdir $folder or die "interrupted.pl: no folder $folder\n";

sub slurp { my ($file) = @_; open my $in, '<', $file or die "interrupted.pl: cannot read $file\n"; local $/; return scalar <$in> }
sub spew { my ($file, $text) = @_; open my $out, '>', $file or die "interrupted.pl: cannot write $file\n"; print $out $text; close $out }

# Starts the program, interrupts it as soon as `ready` is true, and returns its status and what it said.
sub interrupted {
    my ($ready, @words) = @_;
    my $child = fork // die "interrupted.pl: no process\n";
    if ($child == 0) {
        $SIG{INT} = 'DEFAULT';    # a shell without job control has it ignored
        open STDOUT, '>', 'out';
        open STDERR, '>', 'err';
        exec $program, @words or exit 99;
    }
    for (1 .. 6000) {
        last if $ready->();
        select undef, undef, undef, 0.01;
    }
    kill INT => $child;
    waitpid $child, 0;
    die "interrupted.pl: @words was ended by signal ", $? & 127, ", expected exit code 130\n" if $? & 127;
    return ($? >> 8, slurp('err'));
}

spew('steps.toml', <<'TOML');
[[body]]
name = "block"
mesh = { kind = "block", size = [4, 1], cells = [80, 20] }
material = { youngs_modulus = 1000, poisson_ratio = 0.3 }
prescribed = { top = { x = 0.02, y = -0.01, history = "press" } }

[[contact]]
source = "block.bottom"
target = { kind = "half_plane", point = [0, 0], normal = [0, 1] }
friction = 0.3

[[history]]
name = "press"
times = [0, 1]
values = [0, 1]

[[steps]]
until = 1
count = 300
TOML

my ($status, $said) = interrupted(sub { -s 'a.state' }, qw(solve steps.toml --state a.state --csv a.csv));
die "interrupted.pl: steps end with $status: $said\n" if $status != 130;
my ($step, $command) = $said =~ /^signorini: interrupted: a\.state, a\.csv kept after step (\d+), time \S+\. To go on: signorini (.*)$/m
    or die "interrupted.pl: steps say: $said\n";
die "interrupted.pl: all $step steps were done before the signal came\n" if $step >= 300;
system("$program $command > out") == 0 or die "interrupted.pl: cannot go on by: $command\n";
system("$program solve steps.toml --state b.state --csv b.csv > out") == 0 or die "interrupted.pl: the whole run fails\n";
for my $kind (qw(state csv)) {
    die "interrupted.pl: a run that was interrupted ends in other bits: a.$kind, b.$kind\n" if slurp("a.$kind") ne slurp("b.$kind");
}

spew('large.toml', slurp('steps.toml') =~ s/cells = \[80, 20\]/cells = [800, 400]/r =~ s/\[\[history.*//sr =~ s/, history = "press"//r);
my $began = time;
($status, $said) = interrupted(sub { time > $began + 0.2 }, qw(solve large.toml --vtu c.vtu --csv c.csv));
die "interrupted.pl: one solution ends with $status: $said\n" if $status != 130;
die "interrupted.pl: one solution says: $said\n" if $said !~ /^signorini: interrupted: nothing was written$/m;
my @left = glob 'c.*';
die "interrupted.pl: one solution leaves @left\n" if @left;
print "interrupted after step $step, and gone on with to the same bits\n";
