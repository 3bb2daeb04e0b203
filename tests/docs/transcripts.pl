#!/usr/bin/env perl
# transcripts.pl PROGRAM TRANSCRIPTS FOLDER ROOT [--update]: what the program `signorini` prints and writes, word for word and number for number.
# A transcript in TRANSCRIPTS has commands, each behind "$ ", and below each what it prints: `signorini ...`, whose files
# are copied from beside the transcripts, and `cat FILE` for what it wrote into FOLDER.  Numbers may differ by 1e-6 of themselves, or by rounding of those of their line.
# Seconds, bytes, certificates and forecasts, which differ from machine to machine, are left out: printed.pl looks at them.
# README.md in ROOT quotes some lines of an answer, below its command: each is printed, in this order.
# A picture is the script that gnuplot gets.  With --update transcripts get what is printed now: read the difference before you commit it.
use strict;
use warnings;
use File::Copy 'copy';
use File::Path qw(make_path remove_tree);
use Cwd 'abs_path';

my ($program, $transcripts, $folder, $root, $update) = @ARGV;
$root = abs_path($root);
remove_tree($folder);
make_path("$folder/programs");
$transcripts = abs_path($transcripts);
chdir $folder or die "transcripts.pl: $folder: $!\n";
copy($_, '.') or die "transcripts.pl: $_: $!\n" for grep { !/\.txt$/ } glob("$transcripts/*");    # notes name files as they are given
sub content { my ($file) = @_; open my $in, '<', $file or return "there is no $file\n"; local $/; return scalar <$in> }
sub put { my ($file, $text) = @_; open my $out, '>', $file or die "$file: $!\n"; print $out $text; close $out or die "$file: $!\n" }

# A gnuplot that keeps its script as the picture.
put('programs/gnuplot', "#!/bin/sh\ndraft=\$(sed -n \"s/^out = .\\(.*\\).\\\$/\\1/p\" \"\$1\")\nsed '/^out = /d' \"\$1\" > \"\$draft\"\n");
chmod 0755, 'programs/gnuplot';
$ENV{PATH} = abs_path('programs') . ":$ENV{PATH}";

# What differs from machine to machine: members of JSON, tables, and single columns.
sub comparable {
    my ($said) = @_;
    $said =~ s/^( *)"(?:ledger|predicted|processes|certificate)": [\[{]\n(?:\1 .*\n)*\1[\]}],?\n//mg;
    $said =~ s/^ *"(?:seconds|estimating|method|program)": .*\n//mg;
    $said =~ s/^phase +(?:seconds|figure) .*\n(?:\S.*\n|  .*\n)*//mg;
    $said =~ s/^  once\n(?:.*\n)*//m;
    $said =~ s/^certificate: .*/certificate: .../mg;
    $said =~ s/[0-9.e-]+ s in all/... s in all/g;
    $said =~ s/^(  algebraic: ).*?;/$1...;/mg;
    $said =~ s/^( +\d+ +\d+ .* %| +\d+ +\d+ +too coarse for an estimate) +\S+ +\S+$/$1/mg;    # rounds of refinement
    $said =~ s/ +\S+e[-+]\d\d$//mg if $said =~ / certificate\n/;                               # load steps
    $said =~ s/^(\w+ +(?:\w+ )*\w+ +\d+) +\S+ +\S+e[-+]\d\d/$1/mg;                             # solvers
    $said =~ s/ +\n/\n/g;
    return $said;
}
sub answer {
    my ($command) = @_;
    my ($what, @words) = split ' ', $command;
    return content($words[0]) if $what eq 'cat';
    my $said = do { open my $in, '-|', "\"$program\" " . join(' ', map { "'$_'" } @words) . ' 2>&1' or die "$program: $!\n"; local $/; <$in> // '' };
    my $status = $? >> 8;
    return comparable($said) . ($status ? "status $status\n" : '');
}

# Two lines say the same if their words are equal and their numbers nearly: a number that is only rounding is so beside the others of its line.
my $number = qr/(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w])/;
sub alike {
    my ($got, $wanted) = @_;
    my @a = $got =~ /$number/g;
    my @b = $wanted =~ /$number/g;
    (my $words = $got) =~ s/$number/#/g;
    (my $other = $wanted) =~ s/$number/#/g;
    s/\s+/ /g for $words, $other;
    return 0 if $words ne $other || @a != @b;
    my $largest = 1;    # alone in its line
    for (@b) { $largest = abs($_) if abs($_) > $largest }
    for my $k (0 .. $#a) { return 0 if abs($a[$k] - $b[$k]) > 1e-6 * abs($b[$k]) + 1e-10 * $largest }
    return 1;
}

my $failures = 0;
for my $file (glob("$transcripts/*.txt")) {
    my @parts = split /^\$ /m, content($file);
    my $new = shift @parts;
    for my $part (@parts) {
        my ($command, $wanted) = split /\n/, $part, 2;
        my $got = answer($command);
        $new .= "\$ $command\n$got";
        next if $update;
        my @got = split /\n/, $got;
        my @wanted = split /\n/, $wanted // '';
        push @got, '' while @got < @wanted;
        for my $k (0 .. $#got) {
            next if defined $wanted[$k] && alike($got[$k], $wanted[$k]);
            print "$file: $command: expected '", $wanted[$k] // '', "', got '$got[$k]'\n";
            last if ++$failures > 20;
        }
    }
    put($file, $new) if $update;
}

# The answers of README.md: its files are given as from ROOT.
my @quoted = content("$root/README.md") =~ /^```sh\nbuild\/bin\/signorini ([^\n]*)\n```\n\n```text\n(.*?)^```/msg;
print "README.md quotes no answer\n" and ++$failures if !@quoted;
chdir $root or die "transcripts.pl: $root: $!\n";
while (my ($command, $lines) = splice @quoted, 0, 2) {
    my @got = split /\n/, answer("signorini $command");
    for my $wanted (grep { /\S/ } split /\n/, $lines) {
        shift @got while @got && !alike($got[0], $wanted);
        next if @got;
        print "README.md: signorini $command does not print '$wanted'\n";
        ++$failures;
        last;
    }
}
exit($failures == 0 ? 0 : 1);
