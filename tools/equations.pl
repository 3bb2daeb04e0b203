#!/usr/bin/env perl
# equations.pl [--check] [ROOT]: writes chapters/equations.md, the way from every numbered equation of the papers to
# the chapter that explains it, the functions that evaluate it and the tests that hold it.
#   chapter    <a id="eq-23"></a> in chapters/chNN_*/README.md
#   functions  \PaperEq{XuanLi2002, 23} in a comment of src/ or of a chapter's code: what is declared below it
#   tests      [XuanLi2002-23] among the tags of a TEST_CASE
#   kinds      rows of chapters/notation.md that begin with | [(23)](...) | Left open |
# --check writes nothing: it fails if the file is not what would be written.  Both fail if an equation leads nowhere.
use strict;
use warnings;
use utf8;
use Cwd 'abs_path';
use File::Basename 'dirname';
use File::Glob ':bsd_glob';
require(abs_path(dirname(__FILE__)) . '/listed.pl');
binmode STDERR, ':utf8';

my $check = @ARGV && $ARGV[0] eq '--check' ? shift @ARGV : '';
chdir($ARGV[0] // '.') or die "equations.pl: no folder $ARGV[0]\n";

# Paper, its words, last equation, its chapters.
my @papers = (['XuanLi2002', 'Xuan & Li (2002)', 39, 1, 7], ['LinEtAl', 'Lin et al.', 46, 8, 14]);

sub declared {    # the name that a line of C++ declares, or nothing
    my ($line) = @_;
    return $1 if $line =~ /^\s*explicit\s+(\w+)\(/;
    return $1 if $line =~ /^\s*(?:struct|class|enum class)\s+(\w+)/;
    return $1 if $line =~ /(?<![\w.>:])([a-z]\w*)\s*\((?!\*)/ && $line !~ /^\s*(?:if|for|while|return)\b/;
    return $1 if $line =~ /^\s*(?:const\s+)?[\w:<>, ]+[\s&]\s*(\w+)\s*(?:=|;|\{)/;
    return;
}

my (%function, %test, %chapter, %kind);
my @complaints;

for my $file (sort(glob('src/{signorini/*,meshes,closed_form,papers,addons/*}/*.{hpp,cpp}'), glob('chapters/ch*/*.hpp'), glob('chapters/ch*/*.cpp'))) {
    my @lines = split /\n/, slurp($file);
    for my $i (0 .. $#lines) {
        next unless $lines[$i] =~ /\\PaperEq\{/;
        my @numbers;
        my $rest = $lines[$i];
        while ($rest =~ /\\PaperEq\{\s*(\w+)\s*,\s*(\d+)\s*\}(?:\s*to\s*\\PaperEq\{\s*\w+\s*,\s*(\d+)\s*\})?/g) {
            my ($key, $from, $to) = ($1, $2, $3 // $2);
            push @numbers, map { "$key-$_" } $from .. $to;
        }
        my $name;
        if ($lines[$i] !~ m{^\s*//} || $lines[$i] =~ m{///<}) { $name = declared($lines[$i]) }
        my $below = $i + 1;
        while (!defined $name && $below <= $#lines && $below < $i + 60) {
            $name = declared($lines[$below]) if $lines[$below] !~ m{^\s*(?://|$)};
            ++$below;
        }
        my $global = $lines[$below - 1] !~ /^\s/;
        if (!defined $name) {
            push @complaints, "$file:" . ($i + 1) . ": no declaration below this equation";
            next;
        }
        my $link = $global && $file =~ /^src.*hpp$/ ? "[`$name`](../$file)" : "[$name](../$file)";    # members have no page
        $link =~ s{\.\./chapters/}{};
        for my $n (@numbers) {
            push @{$function{$n}}, $link unless grep { $_ eq $link } @{$function{$n}};
        }
    }
}

for my $file (sort(glob('tests/*.cpp'), glob('tests/*/*.cpp'), glob('chapters/ch*/exercises/*/test.cpp'))) {
    my $text = slurp($file);
    while ($text =~ /TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+),\s*((?:"[^"]*"\s*)+)\)/g) {
        my ($claim, $tags) = ($1, $2);
        $claim = join '', $claim =~ /"((?:[^"\\]|\\.)*)"/g;
        $claim =~ s/\\(.)/$1/g;
        $claim =~ s/\|/\\|/g;
        $claim =~ s/([_*])/\\$1/g;
        my $link = $file =~ m{^chapters/(.*)} ? $1 : "../$file";
        push @{$test{$1}}, "[$claim]($link)" while $tags =~ /\[((?:XuanLi2002|LinEtAl)-\d+)\]/g;
    }
}

for my $paper (@papers) {
    my ($key, undef, undef, $first, $last) = @$paper;
    for my $file (sort(glob('chapters/ch[0-9][0-9]_*/README.md'))) {
        my ($folder, $number) = $file =~ m{^chapters/(ch(\d\d)_\w+)/};
        next if $number < $first || $number > $last;
        my $text = slurp($file);
        while ($text =~ /<a id="eq-(\d+)"><\/a>/g) {
            $chapter{"$key-$1"} //= sprintf '[%d](%s/README.md#eq-%d)', $number, $folder, $1;
        }
    }
}
for my $row (split /\n/, slurp('chapters/notation.md')) {
    my ($equations, $number, $kind) = $row =~ /^\| (\[.*?\]\(ch(\d\d)_.*?\)[^|]*)\| (Misprint|Left open|Our verdict) \|/ or next;
    my ($paper) = grep { $number >= $_->[3] && $number <= $_->[4] } @papers;
    $kind{"$paper->[0]-$_"}{$kind} = 1 for $equations =~ /\((\d+)\)/g;
}

my $out = <<'END';
# Equations

Where every numbered equation of the papers is explained, evaluated and tested. Chapters link to the equation, functions to the
file that documents them, tests to the claim they check. The last column links to
[where we differ from the papers](notation.md#where-we-differ-from-the-papers).

<!-- written by tools/equations.pl from the tags in chapters, code and tests -->
END
for my $paper (@papers) {
    my ($key, $words, $last) = @$paper;
    $out .= "\n## $words\n\n| equation | chapter | functions | tests | |\n|:--|:--|:--|:--|:--|\n";
    for my $n (1 .. $last) {
        my $id = "$key-$n";
        push @complaints, "equation ($n) of $key has no chapter: <a id=\"eq-$n\"></a>" unless $chapter{$id};
        push @complaints, "equation ($n) of $key has no function: \\PaperEq{$key, $n}" unless $function{$id};
        push @complaints, "equation ($n) of $key has no test: [$id]" unless $test{$id};
        $out .= sprintf "| (%d) | %s | %s | %s | %s |\n", $n, $chapter{$id} // '', join(', ', @{$function{$id} // []}),
            join('; ', @{$test{$id} // []}),
            join(', ', map { "[\l$_](notation.md#where-we-differ-from-the-papers)" } sort keys %{$kind{$id} // {}});
    }
}

list_and_exit('equations.pl', 'chapters/equations.md', $out, $check, 'tags', @complaints);
