#!/usr/bin/perl
# mistakes.pl [--check]   writes the table of common mistakes in docs/instructor.md from tests/exercises/wrong, where they are planted
# Exit status: 1 if --check finds another table. A hand-out has neither file.
use strict;
use warnings;

my ($sheet, $planted) = ('docs/instructor.md', 'tests/exercises/wrong');
exit 0 if !-f $sheet;
sub slurp { local (@ARGV, $/) = $_[0]; return <> }

my ($table, $row) = "| exercise | mistake | the tests say |\n|:--|:--|:--|\n";
for (split /\n/, slurp($planted)) {
    if (/^ex([\d.]+) (.*)/) { $row = "| $1 | $2 |" }
    elsif (/^> (.*)/)       { $table .= "$row `" . $1 =~ s/\|/\\|/gr . "` |\n" }
}
my $old = slurp($sheet);
(my $new = $old) =~ s/(<!-- mistakes -->\n).*?(<!-- \/mistakes -->)/$1\n$table\n$2/s or die "mistakes.pl: $sheet has no table of mistakes\n";
exit 0 if $new eq $old;
if (@ARGV) { print "$sheet: its mistakes are not those of $planted: make text\n"; exit 1 }
open my $out, '>', $sheet or die "mistakes.pl: cannot write $sheet: $!\n";
print $out $new;
