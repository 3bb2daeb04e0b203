#!/usr/bin/env perl
# claims.pl [ROOT [PAPER1.txt PAPER2.txt]]: what the book says of the papers has its line in tests/reference/claims.md.
#  * a box of a chapter, `> **Kind.** ...`, is a Misprint, Left open or Our verdict, and has <a id="box-N-M"></a> on the line
#    before it, N the chapter and M from 1 on
#  * every box has one row with its kind, every row box-N-M has its box; a row names paper, lines and a quotation
#  * rows of the tables below "Where we differ from the papers" in chapters/notation.md have one of the three kinds, and
#    their row there, note-K, of the same kind
# With the papers as plain text: every quotation stands in the lines that its row names.  White space does not count, and
# what the row has between two dots ... may be anything.  Characters of the font Symbol count as the signs that they show.
use strict;
use warnings;
use utf8;
use File::Glob ':bsd_glob';
binmode STDOUT, ':utf8';

die "usage: claims.pl [ROOT [PAPER1.txt PAPER2.txt]]\n" unless @ARGV <= 1 || @ARGV == 3;
my ($root, @papers) = (@ARGV ? @ARGV : '.');
my $list  = 'tests/reference/claims.md';
my $notes = 'chapters/notation.md';
my %known = map { $_ => 1 } 'Misprint', 'Left open', 'Our verdict';
my $bad   = 0;

sub complain { my ($file, $line, $what) = @_; print "$file:$line: $what\n"; $bad++ }

sub lines_of {
    my ($file) = @_;
    open my $in, '<:encoding(UTF-8)', $file or die "claims.pl: cannot read $file: $!\n";
    my @line = <$in>;
    return @line;
}

sub cells {    # of a row of a table
    my ($row) = @_;
    $row =~ s/^\|\s*|\s*\|\s*$//g;
    return split /\s*(?<!\\)\|\s*/, $row, -1;
}

my %box;       # id -> [file, line, kind]
for my $file (bsd_glob("$root/chapters/ch[0-9][0-9]_*/README.md")) {
    my ($name)   = $file =~ m{^\Q$root\E/(.*)};
    my ($number) = $file =~ m{/ch0?(\d+)_[^/]*/README\.md$};
    my ($before, $n, $fence, $boxes) = ('', 0, '', 0);
    for (lines_of($file)) {
        $n++;
        if    ($fence) { $fence = '' if /^\s*\Q$fence\E\s*$/ }
        elsif (/^\s*(```+|~~~+)/) { $fence = $1 }
        elsif (/^> \*\*(.*?)\.?\*\*/) {
            my ($kind, $want) = ($1, "box-$number-" . ++$boxes);
            complain($name, $n, "a box is a Misprint, Left open or Our verdict, not $kind") unless $known{$kind};
            complain($name, $n, "this box needs <a id=\"$want\"></a> on the line before it")
                unless $before eq "<a id=\"$want\"></a>\n";
            $box{$want} = [$name, $n, $kind];
        }
        elsif ($before =~ /^<a id="(box-[^"]*)">/) { complain($name, $n - 1, "no box below the anchor $1") }
        $before = $_;
    }
}

sub spoken {    # text as it is compared: signs of the font Symbol as signs, no brackets in parts, no white space
    my ($text) = @_;
    my %sign = (
        0x2b => '+', 0x2d => '−', 0x3d => '=', 0x44 => 'Δ', 0x47 => 'Γ', 0x54 => 'T', 0x57 => 'Ω', 0x5e => '⊥',
        0x66 => 'φ', 0x6a => 'ϕ', 0x6d => 'μ', 0x6e => 'ν', 0x71 => 'θ', 0x73 => 'σ', 0x74 => 'τ', 0xa2 => '′',
        0xae => '→', 0xb4 => '×', 0xb6 => '∂', 0xce => '∈', 0xdb => '⇔', 0xe5 => 'Σ', 0xf2 => '∫'
    );
    $text =~ s/([\x{f000}-\x{f0ff}])/$sign{ ord($1) - 0xf000 } \/\/ ''/ge;
    $text =~ s/\s//g;
    return $text;
}

my @text = map { [lines_of($_)] } @papers;

sub check_quotation {
    my ($n, $paper, $where, $quotation) = @_;
    my $lines = '';
    for (split /,\s*/, $where) {
        my ($from, $to) = /^(\d+)(?:–(\d+))?$/ or return;
        $to //= $from;
        return complain($list, $n, "paper $paper has no lines $_") if $from > $to || $to > @{ $text[$paper - 1] };
        $lines .= join '', @{ $text[$paper - 1] }[$from - 1 .. $to - 1];
    }
    $lines = spoken($lines);
    for my $part (grep { /\S/ } split /\.\.\./, $quotation) {
        complain($list, $n, "not in lines $where of paper $paper: $part") if index($lines, spoken($part)) < 0;
    }
}

my (%row, %noted, $n);
for (lines_of("$root/$list")) {
    $n++;
    next unless /^\| ((?:box|claim|note|head|eq)-[\w-]+) \|/;
    my ($id, $kind, $where, $claim, $paper, $lines, $quotation) = my @cell = cells($_);
    complain($list, $n, "$id stands here and in line $row{$id}") if $row{$id};
    $row{$id} = $n;
    if (@cell != 7 || grep { $_ eq '' } @cell) { complain($list, $n, "$id needs seven columns, none empty"); next }
    complain($list, $n, "$kind is no kind of a claim") unless $known{$kind} || $kind eq 'statement' && $id !~ /^box/;
    complain($list, $n, "the paper is 1 or 2, not $paper")   unless $paper =~ /^[12]$/;
    complain($list, $n, "lines are numbers, not $lines")     unless $lines =~ /^\d+(–\d+)?(, \d+(–\d+)?)*$/;
    if ($quotation !~ s/^(`+)\s*(\S.*?)\s*\1$/$2/) { complain($list, $n, "the quotation stands between backticks"); next }
    $quotation =~ s/\\\|/|/g;
    check_quotation($n, $paper, $lines, $quotation) if @papers && $paper =~ /^[12]$/;
    $noted{"$1 $kind"} = 1 if $id =~ /^note/ && $where =~ /^\[(.*?)\]\(/;
    next unless $id =~ /^box/;
    my $there = $box{$id} or do { complain($list, $n, "no chapter has $id"); next };
    complain($list, $n, "$id is called $there->[2] in $there->[0]:$there->[1]") if $kind ne $there->[2];
    complain($list, $n, "$id does not link to its box") if index($where, "../../$there->[0]#$id)") < 0;
}
for my $id (grep { !$row{$_} } sort keys %box) { complain(@{ $box{$id} }[0, 1], "$id has no row in $list") }

my ($inside, $tables, $header) = (0, 0, 0);
$n = 0;
for (lines_of("$root/$notes")) {
    $n++;
    $inside = /Where we differ from the papers/ if /^## /;
    if (!$inside || !/^\|/) { $header = 0; next }
    if ($header < 2) {    # titles and the line below them
        $tables++ if ++$header == 2;
        next;
    }
    my ($what, $kind) = cells($_);
    if (!$known{ $kind // '' }) {
        complain($notes, $n, 'the second column is Misprint, Left open or Our verdict, not ' . ($kind // ''));
        next;
    }
    $what =~ s/^\[(.*?)\]\(.*/$1/;
    complain($notes, $n, "$what, $kind, has no row in $list") unless $noted{"$what $kind"};
}
complain($notes, $n, "no table below \"Where we differ from the papers\"") unless $tables;

exit($bad ? 1 : 0);
