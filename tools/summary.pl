#!/usr/bin/env perl
# summary.pl OUT [chNN ...]: the last lines of a run, one per chapter: its headline number beside the reference value, the processor
# seconds of the program, or "committed" if it was left out and the number is the committed one, and the figure that shows it,
# which chapters/chNN_topic/findings names, or else the first.  Reads OUT/chNN/chNN.results,
# /seconds and /left_out, see tools/chapter.sh; the headline is the line  # headline KEY REFERENCE SOURCE WORDS ...
# A chapter without results or seconds has failed, or has not run: its line says so, and the exit status is 1.
use strict;
use warnings;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns

my ($out, @only) = @ARGV;
binmode STDOUT, ':utf8';
defined $out or die "usage: summary.pl OUT [chNN ...]\n";
my @row = (['chapter', 'headline number', 'reference', 'deviation', 'processor seconds', 'figure']);
my $failed = 0;

sub all_of { my ($file) = @_; open my $in, '<', $file // '' or return ''; local $/; return scalar <$in> }
sub first_line { my ($file) = @_; open my $in, '<', $file or return undef; return scalar <$in> }

my @chapters = @only ? @only : map { /(ch\d\d)$/ } grep { -d } glob "$out/ch[0-9][0-9]";
for my $id (@chapters) {
    my $folder  = "$out/$id";
    my $seconds = first_line("$folder/seconds");
    my $in;
    if (!defined $seconds || !open $in, '<:utf8', "$folder/$id.results") {
        push @row, [$id, 'failed', '-', '-', '-', '-'];
        $failed = 1;
        next;
    }
    $seconds = sprintf '%.2f', $seconds;
    if (open my $left, '<', "$folder/left_out") { $seconds = 'committed' if grep { / \Q$id\E\.results\b/ } <$left> }
    my (%value, @headline);
    while (<$in>) {
        if    (/^# headline (\S+) (\S+) ?(.*)/) { push @headline, [$1, $2, $3] }
        elsif (/^([^#\s]\S*) (\S+) (.+?)( varies)?$/) { $value{$1} = [$2, $3 eq '-' ? '' : " $3"] }
    }
    close $in;
    my ($named) = (all_of(glob "chapters/${id}_*/findings") =~ /^figure (\S+)$/m, '');
    my ($figure) = grep { -f } "$folder/$named.svg", sort { length $a <=> length $b || $a cmp $b } glob "$folder/fig_*.svg";
    my @line = ($id, $seconds, $figure // '');
    for my $h (@headline) {
        my ($key, $reference, $source) = @$h;
        my $v = $value{$key} or die "$folder/$id.results: the headline '$key' is not among the values\n";
        push @row, [$line[0], sprintf('%s = %.5g%s', $key, @$v), sprintf('%.5g', $reference) . ($source eq '' ? '' : " ($source)"),
            $reference == 0 ? '-' : sprintf('%+.2g %%', 100 * ($v->[0] / $reference - 1)), $line[1], $line[2]];
        @line = ('', '', '');
    }
    push @row, [$line[0], '-', '-', '-', $line[1], $line[2]] if !@headline;
}
@row > 1 or die "$out: no chapter has run yet\n";

my @width;
for my $r (@row) {
    for my $k (0 .. $#$r) { $width[$k] = length $r->[$k] if length $r->[$k] > ($width[$k] // 0) }
}
for my $r (@row) {
    my $line = join ' | ', map { sprintf($_ =~ /^[34]$/ ? '%*s' : '%-*s', $width[$_], $r->[$_]) } 0 .. $#$r;
    print $line =~ s/\s+$//r, "\n";
    print '-' x length $line, "\n" if $r == $row[0];
}
exit $failed;
