#!/usr/bin/env perl
# lint-md.pl FILE.md ...: finds what would look wrong where the repository is browsed or in the book.
#  * formulas in $...$ that Markdown may damage: write $`...`$ instead
#  * macros that browsers of repositories refuse, formulas in links and titles, dollar signs without partner
#  * links and images that lead nowhere, or to what a hand-out does not have; exercises nobody links to
#  * hints of exercises that are not folded, and folded text that is shown as it is typed
#  * what a merge left behind; anchors that exist twice, equation numbers that do not fit their anchor: <a id="eq-23"></a> and \tag{23}
use strict;
use warnings;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns
use File::Basename;

my ($bad, %anchors) = (0);
my $refused = qr/\\(?:operatorname|newcommand|def|bm|eqref|label|ref|mathbbm)\b/;

sub complain { my ($file, $line, $what) = @_; print "$file:$line: $what\n"; $bad++ }

sub slug { my $s = lc $_[0]; $s =~ s/[^\w\- ]//g; $s =~ s/ /-/g; return $s }

sub clean {    # a/b/../c -> a/c
    my @part;
    for (split m{/}, $_[0]) {
        if    ($_ eq '..' && @part && $part[-1] ne '..') { pop @part }
        elsif ($_ ne '.' && $_ ne '')                    { push @part, $_ }
    }
    return join '/', @part;
}

sub lines_of {
    my ($file) = @_;
    open my $in, '<', $file or die "lint-md.pl: cannot read $file: $!\n";
    my @line = <$in>;
    return @line;
}

sub anchors_of {    # anchor -> how often, headings included
    my ($file) = @_;
    return $anchors{$file} if $anchors{$file};
    my ($fence, %a) = ('');
    for (-f $file ? lines_of($file) : ()) {
        if ($fence) { $fence = '' if /^\s*\Q$fence\E\s*$/; next }
        if (/^\s*(```+|~~~+)/) { $fence = $1; next }
        $a{ slug($1) }++ if /^#+ (.*?)\s*$/;
        $a{$1}++ while /<a id="([^"]+)">/g;
    }
    return $anchors{$file} = \%a;
}

sub check_formula {    # one line of a formula in $...$
    my ($file, $n, $formula) = @_;
    complain($file, $n, "write \$`$formula`\$, Markdown may damage \$$formula\$")
        if $formula =~ /[*<>]/ || $formula =~ /\\[^A-Za-z]/ || $formula =~ /(?<![A-Za-z0-9])_/;
}

sub check_links {
    my ($file, $n, $text, $linked) = @_;
    while ($text =~ /(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)/g) {
        my ($image, $words, $url) = ($1, $2, $3);
        complain($file, $n, 'a formula inside a link is not shown') if !$image && $words =~ /\$/;
        complain($file, $n, 'an image needs a caption')             if $image  && $words eq '';
        next if $url =~ /^\w+:/;
        my ($path, $place) = $url =~ /^([^#]*)(?:#(.*))?$/;
        my $target = $path eq '' ? $file : clean(dirname($file) . "/$path");
        $linked->{$target} = 1;
        if (!-e $target) { complain($file, $n, "dead link $url"); next }
        complain($file, $n, "$url is missing in a hand-out, do not link to it")
            if $target =~ m{/exercises/.*/(solution|test_heldout)\.cpp$};
        complain($file, $n, "no place #$place in $target")
            if defined $place && $target =~ /\.md$/ && !anchors_of($target)->{$place};
    }
}

sub check_folding {    # <details><summary>Title</summary>, blank, text, blank, </details>; hints only so
    my ($file, @line) = @_;
    my $open = 0;
    for my $i (0 .. $#line) {
        my ($text, $n) = ($line[$i], $i + 1);
        complain($file, $n, 'fold the hint: <details><summary>Hint 1</summary>') if $file =~ m{/exercises/} && $text =~ /^\W*Hint\b/;
        next if $text !~ m{^\s*</?(?:details|summary)\b};
        my $begins = $text =~ m{^<details><summary>[^<]+</summary>$};
        my $ends   = $text =~ m{^</details>$};
        complain($file, $n, 'write <details><summary>Title</summary> or </details>, alone on the line') if !$begins && !$ends;
        complain($file, $n, 'folded text begins and ends with an empty line') if ($line[$begins ? $i + 1 : $i - 1] // '') =~ /\S/;
        complain($file, $n, $begins ? 'folded text inside folded text' : '</details> without <details>') if $open != ($ends ? 1 : 0);
        $open = $begins ? 1 : 0;
    }
    complain($file, scalar @line, '</details> is missing') if $open;
}

sub check_file {
    my ($file) = @_;
    my @line = lines_of($file);
    my ($fence, $math, $anchor, %number, %linked) = ('', 0, '');
    my $own = anchors_of($file);
    complain($file, 1, "the anchor '$_' exists $own->{$_} times") for grep { $own->{$_} > 1 } sort keys %$own;
    complain($file, 1, 'the first line must be the title, "# Title"') if ($line[0] // '') !~ /^# \S/;
    complain($file, scalar @line, 'a chapter has at most 350 lines') if @line > 350 && $file =~ m{^chapters/ch\d\d_[^/]*/README\.md$};
    complain($file, scalar @line, 'the front door has at most 120 lines, the rest stands in docs/') if @line > 120 && $file eq 'README.md';
    check_folding($file, @line);
    for my $i (0 .. $#line) {
        my ($text, $n) = ($line[$i], $i + 1);
        complain($file, $n, 'two states of the text stand side by side, a merge was not finished') if $text =~ /^(?:<{7}|={7}|>{7})(?: |$)/;
        if ($fence) {
            if ($text =~ /^[\s>]*\Q$fence\E\s*$/) { ($fence, $math) = ('', 0); next }
            next if !$math;
            complain($file, $n, "$1 is not known everywhere") if $text =~ /($refused)/;
            complain($file, $n, "use aligned instead of $1")
                if $text =~ /\\begin\{((?:align|equation|eqnarray|gather)\*?)\}/;
            complain($file, $n, 'a quoted value does not work inside a formula') if $text =~ /<!--/;
            if ($text =~ /\\tag\{([^}]+)\}/) {
                (my $want = "eq-$1") =~ s/[^\w-]+/-/g;
                complain($file, $n, "number ($1) needs <a id=\"$want\"></a> on a line before the formula") if $anchor ne $want;
                complain($file, $n, "number ($1) is given twice") if $number{$1}++;
                $anchor = '';
            }
            next;
        }
        if ($text =~ /<a id="(eq-[^"]+)">/) {
            complain($file, $n, "the anchor $anchor has no \\tag") if $anchor ne '';
            $anchor = $1;
        }
        if ($text =~ /^[\s>]*(```+|~~~+)\s*(\w*)/) { ($fence, $math) = ($1, $2 eq 'math'); next }

        complain($file, $n, 'write a ```math fence instead of $$') if $text =~ /\$\$/;
        (my $plain = $text) =~ s/\$`([^`]*)`\$/ /g;
        complain($file, $n, "$1 is not known everywhere") if $text =~ /\$`[^`]*($refused)/;
        $plain =~ s/(`+)(?!`).*?(?<!`)\1(?!`)/ /g;
        (my $rest = $plain) =~ s{(?<![\\\w])\$(?!\s)((?:\\.|[^\$\\])*?)(?<!\s)\$(?!\w)}{ check_formula($file, $n, $1); ' ' }ge;
        complain($file, $n, "$1 is not known everywhere") if $plain =~ /\$[^\$]*($refused)/;
        complain($file, $n, 'a quoted value does not work inside a formula') if $plain =~ /\$[^\$]*<!--=[^\$]*<!--\/-->[^\$\s]*\$/;
        complain($file, $n, 'no formula in a heading, the sidebar cannot show it') if $text =~ /^#+ .*\$/;
        complain($file, $n, 'a dollar sign is left over: write \$, and keep a formula on one line') if $rest =~ /(?<!\\)\$/;
        complain($file, $n, 'a quoted value, or words that set a figure, must not begin a line') if $text =~ /^[ >]*<!--(=| set )/;
        complain($file, $n, 'an image stands alone on its line, or the book loses its caption')
            if $plain =~ /!\[[^\]]*\]\(/ && $plain !~ /^!\[.*\]\([^)\s]+\)\s*$/;
        check_links($file, $n, $plain, \%linked);
    }
    complain($file, scalar @line, 'a fence is not closed') if $fence;
    complain($file, scalar @line, "the anchor $anchor has no \\tag") if $anchor ne '';
    if ($file =~ m{(^|/)chapters/ch\d\d_[^/]+/README\.md$}) {
        for (map { clean($_) } glob dirname($file) . '/exercises/*/README.md') {
            complain($file, scalar @line, "no link to the exercise $_") if !$linked{$_};
        }
    }
}

check_file(clean($_)) for @ARGV;
exit($bad ? 1 : 0);
