#!/usr/bin/env perl
# course.pl [--check] [ROOT]: fills two columns of the course in chapters/README.md, in minutes rounded to ten:
#   reading  words of the chapters that the row links to, 60 a minute; of those behind "one of" the mean
#   minutes  what the pages of its exercises say, "30 minutes; needs ..."; 40 where a page says nothing
# --check writes nothing: it fails if the table is not what would be written.
use strict;
use warnings;

my $check = @ARGV && $ARGV[0] eq '--check' ? shift @ARGV : '';
chdir($ARGV[0] // '.') or die "course.pl: no folder $ARGV[0]\n";
my $file = 'chapters/README.md';
my ($words_a_minute, $usual) = (60, 40);

sub slurp {
    my ($name) = @_;
    open my $in, '<', $name or die "course.pl: $name: $!\n";
    local $/;
    return <$in>;
}

sub reading { my @word = split ' ', slurp("chapters/$_[0]"); return @word / $words_a_minute }

sub minutes { return slurp("chapters/$_[0]") =~ /(\d+) minutes\b/ ? $1 : $usual }

sub total { my $sum = 0; $sum += $_ for @_; return $sum }

sub links { return $_[0] =~ /\]\(([^)]+)\)/g }

my ($rows, $old) = (0, slurp($file));
my $new = $old =~ s{^\| (\d+) \| ([^|]*) \| ([^|]*) \| [^|]* \| ([^|]*/exercises/[^|]*) \| [^|]* \|$}{
    my ($week, $question, $chapters, $exercises) = ($1, $2, $3, $4);
    $rows++;
    my ($all, $choice) = split /one of/, $chapters;
    my @choice = map { reading($_) } links($choice // '');
    my $read = total(map { reading($_) } links($all)) + (@choice ? total(@choice) / @choice : 0);
    sprintf '| %d | %s | %s | %d | %s | %d |', $week, $question, $chapters, 10 * int($read / 10 + 0.5), $exercises,
        10 * int(total(map { minutes($_) } links($exercises)) / 10 + 0.5)
}gmer;
die "course.pl: no rows of a course in $file\n" if !$rows;
if ($check && $new ne $old) {
    print "$file: the minutes of the course are not those of chapters and exercises: type make text\n";
    exit 1;
}
if ($new ne $old) {
    open my $out, '>', $file or die "course.pl: $file: $!\n";
    print $out $new;
    close $out or die "course.pl: $file: $!\n";
    print "wrote $file\n";
}
