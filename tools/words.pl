#!/usr/bin/env perl
# words.pl [--check] [ROOT [PAPER-1 PAPER-2]]: writes chapters/words.md, the way from the words of chapters/glossary.md to the
# sections that explain or use them.  A place is a section of a chapter that sets the word in italics or has it in its
# heading; in other chapters the section that says it most often, if the chapter says it three times.  A word that stands
# in more than eight chapters keeps the places of the first kind only, and so does a verb.
# Complains of words without meaning, out of order or twice, and of a Chinese word without its source; given both papers,
# of one that is not in them.
# --check writes nothing: it fails if the file is not what would be written.
use strict;
use warnings;
use utf8;
use Cwd 'abs_path';
use File::Basename 'dirname';
use File::Glob ':bsd_glob';
require(abs_path(dirname(__FILE__)) . '/listed.pl');
binmode STDERR, ':utf8';

my $check = @ARGV && $ARGV[0] eq '--check' ? shift @ARGV : '';
my ($root, @papers) = @ARGV;
chdir($root // '.') or die "words.pl: no folder $root\n";
my $glossary = 'chapters/glossary.md';
my ($often, $chapters) = (3, 8);

sub slug { my $s = lc $_[0]; $s =~ s/[^\w\- ]//g; $s =~ s/ /-/g; return $s }

sub plain { my $w = lc $_[0]; $w =~ s/^to //; $w =~ s/-/ /g; $w =~ s/[^\w' ]//g; return $w }    # what the order goes by

my (@complaints, @words, %seen);
my @paper = map { s/[\s\$]//gr } map { slurp($_) } @papers;
my $n = 0;
for my $line (split /\n/, slurp($glossary)) {
    $n++;
    next if $line !~ /^\| / || $line =~ /^\| (?:word|:--)/;
    my ($word, $chinese, $means) = map { s/^\s+|\s+$//gr } (split /\|/, $line)[1 .. 3];
    my $complain = sub { push @complaints, "$glossary:$n: $word: $_[0]" };
    $complain->('no meaning') if ($means // '') eq '';
    $complain->('stands twice') if $seen{plain($word)}++;
    $complain->('comes before ' . $words[-1]) if @words && plain($word) lt plain($words[-1]);
    $complain->('give (1), (2), (1, 2) or \* behind the Chinese word') if $chinese ne '' && $chinese !~ /^\S.* (?:\((?:1|2|1, 2)\)|\\\*)$/;
    if (@paper && $chinese =~ /^(.*) \((.*)\)$/) {
        my ($say, $in) = ($1, $2);
        $say =~ s/\s//g;
        index($paper[$_ - 1], $say) >= 0 || $complain->("'$1' is not in paper $_") for split /, /, $in;
    }
    push @words, $word;
}

my (%place, %most);    # word -> chapter -> places; section that says it most
for my $file (sort(glob('chapters/ch[0-9][0-9]_*/README.md'))) {
    my ($number) = $file =~ m{/ch(\d\d)_};
    my ($fence, @section) = ('', ['', '', '']);    # of a section its title, what it is found by, and the text
    for my $line (split /\n/, slurp($file)) {
        if ($fence) { $fence = '' if $line =~ /^\s*\Q$fence\E\s*$/; next }
        if ($line =~ /^\s*(```+|~~~+)/) { $fence = $1; next }
        if ($line =~ /^# (.*?)\s*$/)  { $section[0][1] = $1; next }
        if ($line =~ /^## (.*?)\s*$/) { push @section, [$1, $1, '']; next }
        $line =~ s/<!--.*?-->//g;
        $line =~ s/\]\([^)]*\)/]/g;
        $section[-1][2] .= " $line";
    }
    for my $word (@words) {
        my $say = lc($word =~ s/^to //r =~ s/`//gr);
        my $code = $word =~ /`/;
        my $one = join '[\s-]+', map { quotemeta } split /[\s-]+/, $say;
        my $what = $code ? qr/`\Q@{[$word =~ s{`}{}gr]}\E\b/ : qr/(?<![\w-])$one(?:s|es)?(?![\w-])/i;
        my ($all, $best, @main) = (0);
        for my $section (@section) {
            my ($title, $heading, $text) = @$section;
            my $count = () = "$heading $text" =~ /$what/g;
            $all += $count;
            $best = [$count, $title] if $count && (!$best || $count > $best->[0]);
            push @main, $title if $heading =~ $what || $text =~ /(?<![\w*`])\*$what\*(?![\w*])/;
        }
        $place{$word}{$number} = [$file, @main] if @main;
        $most{$word}{$number} = [$file, $best->[1]] if $best && ($all >= $often || $code) && $word !~ /^to /;
    }
}

sub links {
    my ($file, $number, @title) = @_;
    $file =~ s{^chapters/}{};
    return map { $_ eq '' ? sprintf('[%d](%s)', $number, $file) : sprintf('[%d %s](%s#%s)', $number, $_, $file, slug($_)) } @title;
}

my $out = <<'END';
# Index

From the words of the [glossary](glossary.md) to the sections of the chapters that explain them, in **bold**, or use them much.

<!-- written by tools/words.pl from the glossary and the chapters -->

| word | sections |
|:--|:--|
END
for my $word (@words) {
    my ($main, $use) = ($place{$word} // {}, $most{$word} // {});
    my %all = (%$use, %$main);
    my $many = keys %all > $chapters && %$main;
    my @links;
    for my $number (sort keys %all) {
        next if $many && !$main->{$number};
        my ($file, @title) = @{ $all{$number} };
        push @links, $main->{$number} ? map { "**$_**" } links($file, $number, @title) : links($file, $number, @title);
    }
    push @links, 'and throughout' if $many;
    $out .= "| $word | " . join(', ', @links) . " |\n" if @links;
}

list_and_exit('words.pl', 'chapters/words.md', $out, $check, 'chapters', @complaints);
