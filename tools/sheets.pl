#!/usr/bin/env perl
# sheets.pl [--check] [ROOT]: writes chapters/sheets.md, a sheet to print for each week of the course and each session of the seminar in
# chapters/README.md: its question, what to read and to learn, the questions to answer before a figure is opened, and the tasks.
# All of it is taken from the chapters and the pages of the exercises.
# --check writes nothing: it fails if the file is not what would be written.
use strict;
use warnings;
use File::Basename;

my $check = @ARGV && $ARGV[0] eq '--check' ? shift @ARGV : '';
chdir($ARGV[0] // '.') or die "sheets.pl: no folder $ARGV[0]\n";
my $file = 'chapters/sheets.md';

sub slurp {
    my ($name) = @_;
    open my $in, '<', $name or die "sheets.pl: $name: $!\n";
    local $/;
    return scalar <$in>;
}

sub rebased {    # the links of a text of a folder, as from chapters/; quoted values become plain
    my ($folder, $text) = @_;
    $text =~ s/<!--=.*?-->(.*?)<!--\/-->/$1/g;
    $text =~ s/<!-- set .*?-->(.*?)<!-- \/set -->/$1/g;
    $text =~ s{\]\((?!\w+:)([^)\s]+)\)}{
        my ($to, @part) = $1;
        my $path = $to =~ /^#/ ? "$folder/README.md$to" : "$folder/$to";
        for (split m{/}, $path) {
            if    ($_ eq '..' && @part && $part[-1] ne '..') { pop @part }
            elsif ($_ ne '.')                                { push @part, $_ }
        }
        '](' . join('/', @part) . ')';
    }ge;
    return $text;
}

sub paragraphs { return split /\n\s*\n/, $_[0] }

sub chapter {    # what one chapter gives to a sheet
    my ($path) = @_;
    my $folder = dirname $path;
    my $text   = slurp("chapters/$path");
    my ($title) = $text =~ /^# (.*)/m;
    my @learn = map { rebased($folder, $_) } grep { /^\* / } split /\n/, ($text =~ /^## Key ideas\n(.*?)^## /ms)[0] // '';
    my @predict = map { rebased($folder, s/^\*\*Predict, then check\.\*\*\s*//r) } grep { /^\*\*Predict, then check\./ } paragraphs($text);
    return ("[$title]($path)", \@learn, \@predict);
}

sub task {
    my ($path) = @_;
    my $folder = dirname $path;
    my ($title, $kind, @what) = paragraphs(slurp("chapters/$path"));
    my $what = '';
    for (@what) { last if /^ {4}make /; $what .= ($what eq '' ? '' : "\n\n") . $_ }
    $title =~ s/^# Exercise //;
    $kind  =~ s/ · \*\*Needs\.\*\*.*//s;
    my ($number) = $title =~ /^([\d.]+)/;
    return "**[$title]($path).** $kind\n\n" . rebased($folder, $what) . "\n\n`make ex$number`\n";
}

my $ways = slurp('chapters/README.md');
my $new  = "# Sheets for weeks and sessions\n\nOne sheet for each week of [the course](README.md#contact-mechanics-in-seven-weeks) and each session of "
    . "[the seminar](README.md#a-seminar-a-paper-read-critically), to be\nprinted and handed out. In print each begins a page.\n\n"
    . "<!-- written by tools/sheets.pl from the chapters and their exercises -->\n";
my $kind = 'Week';
while ($ways =~ /^(?:\| (week|session) \||\| (\d+) \| ([^|]*) \| ([^|]*) \| (\d+) \| ([^|]*\/exercises\/[^|]*) \| (\d+) \|$)/gm) {
    if (defined $1) { $kind = ucfirst $1; next }
    my ($n, $question, $chapters, $read, $exercises, $minutes) = ($2, $3, $4, $5, $6, $7);
    $new .= "\n<div class=\"sheet\"></div>\n\n## $kind $n: $question\n\n";
    my (@read, @learn, @predict);
    for my $path ($chapters =~ /\]\(([^)]+)\)/g) {
        my ($link, $learn, $predict) = chapter($path);
        push @read, $link;
        push @learn, @$learn;
        push @predict, @$predict;
    }
    $new .= "*Read before the lectures* ($read minutes): " . join('; ', @read) . ".\n\n";
    $new .= "*Afterwards you can explain, each with an example of your own:*\n\n" . join("\n", @learn) . "\n\n" if @learn;
    $new .= "*Answer before you open the figure*, and write the answer down:\n\n" . join("\n", map { '* ' . s/\n/ /gr } @predict) . "\n\n" if @predict;
    $new .= "*Tasks* ($minutes minutes):\n\n" . join("\n", map { task($_) } $exercises =~ /\]\(([^)]+)\)/g);
}
my $old = -f $file ? slurp($file) : '';
exit 0 if $new eq $old;
if ($check) {
    print "$file is not what the chapters and exercises say: type make text\n";
    exit 1;
}
open my $out, '>', $file or die "sheets.pl: $file: $!\n";
print $out $new;
close $out or die "sheets.pl: $file: $!\n";
print "wrote $file\n";
