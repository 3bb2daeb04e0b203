#!/usr/bin/env perl
# whose.pl ROOT               every number of an equation says whose it is: (A 12) of Xuan & Li, (B 12) of Lin et al., and leads there
# whose.pl ROOT A|B FILE ...  mends files: (12), (12)-(14) and [(12)](...) become [(A 12)](... #eq-12), for one paper; read the result
#
# In the texts of chapters, their exercises, notation and list of words a number in brackets that could be an equation, (1) to
# (46), is bare: two papers have it.  Formulas, code, tables that a
# program writes, and the first cell of a table row whose heading names the paper are left
# alone, and so is the glossary, where (1) and (2) are the papers.  The number of a caption need not be a link, all others must.
use strict;
use warnings;
use File::Basename;
use File::Glob ':bsd_glob';

my ($root, $paper, @mend) = @ARGV;
chdir($root // '') or die "usage: whose.pl ROOT [A|B FILE ...]\n";
my %last   = (A => 39, B => 46);
my $number = qr/[1-9]|[1-3]\d|4[0-6]/;

sub slurp {
    my ($file) = @_;
    open my $in, '<', $file or die "whose.pl: cannot read $file: $!\n";
    local $/;
    return scalar <$in>;
}

# The parts of a text that are neither formula, code nor quoted value: calls $do->(part) and puts its result there.
sub in_words {
    my ($text, $do) = @_;
    my $kept = qr{
        ^[\ >]*(```+|~~~+)[^\n]*\n.*?^[\ >]*\g{-1}[ \t]*$ | \$`.*?`\$ | (`+)(?!`)[^\n]*?(?<!`)\g{-1}(?!`)
      | (?<![\\\w])\$(?!\s)(?:\\.|[^\$\\\n])*?(?<!\s)\$(?!\w) | <!--\ (?:table|code)\ .*?<!--\ /(?:table|code)\ --> | <!--.*?-->
      | ^\|\ \[(?:section\ [\d.]+,\ (?:after|before)\ )?\($number\)[^]\n]*\]\([^)\n]*\)\ \|
    }msx;
    my ($done, $from) = ('', 0);
    while ($text =~ /$kept/g) {
        my ($start, $end) = ($-[0], $+[0]);
        $done .= $do->(substr($text, $from, $start - $from)) . substr($text, $start, $end - $start);
        $from = $end;
    }
    return $done . $do->(substr $text, $from);
}

my %paper_of;    # chapter -> letter of its paper
for (split /\n/, slurp('docs/parts')) { if (/^paper (\w) \w+: (\d+)-(\d+)/) { $paper_of{$_} = $1 for $2 .. $3 } }
my %home;        # equation -> file that has its anchor
for my $file (sort glob 'chapters/ch[0-9][0-9]_*/README.md') {
    my ($chapter) = $file =~ /ch(\d\d)_/;
    my $of = $paper_of{ $chapter + 0 } // next;
    my $text = slurp($file);
    $home{"$of $1"} //= $file while $text =~ /<a id="eq-(\d+)">/g;
}

sub link_to {
    my ($file, $name) = @_;
    my $n    = (split ' ', $name)[1];
    my $home = $home{$name} or return "($name)";
    return "[($name)](#eq-$n)" if $home eq $file;
    my $up = '../' x (() = dirname($file) =~ m{/}g);
    return "[($name)]($up" . $home =~ s{^chapters/}{}r . "#eq-$n)";
}

sub mended {    # formulas stay; a caption is no place for links
    my ($file, $text) = @_;
    return in_words($text, sub {
        my ($part) = @_;
        $part =~ s{\[\(($number)\)\]\([^)\s]*\)}{link_to($file, "$paper $1")}ge;
        $part =~ s{(?<![\w\]])\(($number)\)(?!\()}{ $1 <= $last{$paper} ? "($paper $1)" : "($1)" }ge;
        $part =~ s{(?<!\[)\(([AB] $number)\)(?!\])}{ link_to($file, $1) }ge;
        return join "\n", map { /^!\[/ ? s{\[\(([AB] \d+)\)\]\([^)]*\)}{($1)}gr : $_ } split /\n/, $part, -1;
    });
}

if ($paper) {
    $last{$paper} or die "whose.pl: the papers are A and B\n";
    for my $file (@mend) {
        my $old = slurp($file);
        my $new = mended($file, $old);
        next if $new eq $old;
        open my $out, '>', $file or die "$file: $!\n";
        print $out $new;
        close $out or die "$file: $!\n";
        print "mended $file\n";
    }
    exit 0;
}

my $bad = 0;
for my $file (sort glob('chapters/ch[0-9][0-9]_*/README.md'), glob('chapters/ch*/exercises/*/README.md'), 'chapters/README.md', 'chapters/notation.md',
    'README.md', grep { !/(?:instructor|references|teaching)\.md$/ } glob 'docs/*.md') {
    my @fault;
    my $text = slurp($file);
    in_words($text, sub {
        my ($part) = @_;
        push @fault, "($1) of which paper?" while $part =~ /(?<![\w\]])\(($number)\)/g;
        push @fault, "no equation ($1 $2)" while $part =~ /\(([AB]) (\d+)\)/g and $2 > $last{$1};
        for my $line (split /\n/, $part) {
            next if $line =~ /^!\[/;
            push @fault, "($1) is no link" while $line =~ /(?<!\[)\(([AB] \d+)\)(?!\])/g;
        }
        return $part;
    });
    if (@fault) { print "$file: $fault[0]", @fault > 1 ? " and " . (@fault - 1) . " more" : '', "\n"; $bad++ }
}
exit($bad ? 1 : 0);
