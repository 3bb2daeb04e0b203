#!/usr/bin/env perl
# doxfilter.pl FILE: Doxygen's input filter.  The texts are written to be read where the repository is
# browsed, the sources for an editor; this says the same in Doxygen's own commands.  Line numbers are kept,
# so that Doxygen's warnings point to the right line.
#
#   $x$, $`x`$                    ->  \f$x\f$
#   ```math ... ```               ->  \f[ ... \f]
#   *text with $x$*               ->  <em>: Doxygen sees no emphasis across a formula,
#   half-*plane*                      or within a word
#   # Title, ## Section           ->  the same with the labels chapter-06, chapter-06-section
#   <a id="eq-23"></a>            ->  \anchor chapter-06-eq-23   (the number belongs to a page)
#   [text](../x/README.md#name)   ->  @ref label "text"
#   [`name`](../../src/x.hpp)     ->  @ref signorini::name
#   [text](exercises/...)         ->  \subpage, so that the sidebar shows the exercise below its chapter
#   [text](any other file)        ->  a link to a copy of it, files/PATH.txt
#   ![caption](figure.svg)        ->  a figure with its caption; class "field" if its script uses a palette
#   <details>, </details>         ->  the same as raw HTML: Doxygen closes its own at the end of a paragraph
#   [text](a source, or its list)  ->  @ref page-..., the page that evenings.pl made of it below BOOK_PAGES
#   <!-- live name -->            ->  the place of a figure that computes, see docs/live.js
#   <!-- code file#name --> ...   ->  a line that links to the file, and the code
#   \PaperEq{XuanLi2002, 23}      ->  an alias that links to the reference, and if a chapter explains this
#                                     equation, to the equation
# Expects BOOK_ROOT, the project, BOOK_HTML, the folder of the pages, and BOOK_PAGES, that of the texts made from sources: a + in
# the name of one stands for a /, and its links are as from there.
use strict;
use warnings;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns
use File::Basename;
use Cwd 'abs_path';

my ($file) = @ARGV;
my $root = abs_path($ENV{BOOK_ROOT} // '.');
my $html = $ENV{BOOK_HTML} // "$root/build/book";
my $made = $ENV{BOOK_PAGES} // "$html.work/pages";
my $rel  = abs_path($file) =~ s{^\Q$root\E/}{}r;
$rel = basename($file) =~ tr{+}{/}r if dirname(abs_path($file)) eq $made;

# Which chapters speak of which paper: its equation numbers are their equation numbers.
my %chapters_of = (XuanLi2002 => [1 .. 7], LinEtAl => [8 .. 14]);

sub slurp {
    my ($name) = @_;
    open my $in, '<', $name or return undef;
    local $/;
    return scalar <$in>;
}

sub complain { my ($n, $why) = @_; print STDERR "$file:$n: error: $why\n" }

sub label {    # the label of a text, given relative to the root
    my ($text) = @_;
    return 'index' if $text eq 'README.md';
    return 'ways'  if $text eq 'chapters/README.md';
    return "exercise-$1-$2" if $text =~ m{^chapters/ch(\d\d)_[^/]+/exercises/ex(\d+)_[^/]+/README\.md$};
    return "chapter-$1"     if $text =~ m{^chapters/ch(\d\d)_[^/]+/README\.md$};
    return 'page-' . $1 =~ tr{/.}{-}r if $text =~ m{^src/(.*\.[ch]pp)\.md$};
    return basename($text, '.md');
}

sub place {    # the label of a place in a text; the entries of the references have short labels
    my ($text, $name) = @_;
    return label($text) if !defined $name;
    return $name if $text eq 'docs/references.md';
    return label($text) . "-$name";
}

sub clean {
    my @part;
    for (split m{/}, $_[0]) {
        if    ($_ eq '..')             { pop @part }
        elsif ($_ ne '.' && $_ ne '')  { push @part, $_ }
    }
    return join '/', @part;
}

sub slug {     # the anchor that a heading gets where the repository is browsed
    my $s = lc $_[0];
    $s =~ s/[^\w\- ]//g;
    $s =~ s/ /-/g;
    return $s;
}

sub copy_as_text {    # puts a file that is no page beside the pages; the link to it
    my ($path) = @_;
    my ($to, $content) = ("files/$path.txt", slurp("$root/$path"));
    my $folder = $html;
    for (split m{/}, dirname $to) { $folder .= "/$_"; mkdir $folder if !-d $folder }
    open my $out, '>', "$html/$to" or die "$html/$to: $!\n";
    print $out $content;
    close $out or die "$html/$to: $!\n";
    return $to;
}

my %nested;    # exercises that this chapter has already taken in

sub reference {    # Doxygen 1.9 shows back quotes inside its links as they are
    my ($label, $words) = @_;
    my $code = $words =~ /^`([^`]*)`\s*$/;
    my $link = "\@ref $label \"" . ($words =~ s/["`]//gr =~ s/\s+$//r) . '"';
    return $code ? "<tt>$link</tt>" : $link;
}

sub link_to {
    my ($words, $url, $n) = @_;
    return reference(place($rel, $1), $words) if $url =~ /^#(.*)/;
    my ($path, $name) = $url =~ /^([^#]*)(?:#(.*))?$/;
    $path = clean(dirname($rel) . "/$path");
    $path .= '.md' if $path !~ /\.hpp$/ && -f "$made/" . "$path.md" =~ tr{/}{+}r;
    if ($path =~ /\.md$/ && $path !~ m{/results/}) {
        my $to = place($path, $name);
        return reference($to, $words) if (label($rel) . " $to") !~ /^(chapter\S* exercise-\d+-\d+|evenings evening-\d+|evening-\d+ page-\S+)$/ || $nested{$to}++;
        return "\\subpage $to \"" . ($words =~ s/["`]//gr) . '"';    # an exercise belongs to its chapter, a page to its evening
    }
    return $words if -d "$root/$path";
    return reference("signorini::$1", $words) if $path =~ m{^src/} && $words =~ /^`(?:signorini::)?([\w:~]+)(?:\(\))?`$/;
    return reference($path, $words) if $path =~ m{^(src/.*\.hpp|chapters/[^/]+/[^/]+\.cpp)$};
    if (!-f "$root/$path") { complain($n, "no file $path"); return $words }
    return "<a href=\"" . copy_as_text($path) . "\">$words</a>";
}

sub formulas {    # $...$ in text without code spans
    my ($s) = @_;
    $s =~ s/(?<![\\\w\$])\$(?![\s\$])((?:\\.|[^\\\$])*?(?:\\.|[^\\\$\s]))\$(?![\w\$])/\\f\$$1\\f\$/g;
    return $s;
}

sub prose {       # one line of Markdown outside of fences
    my ($s, $n) = @_;
    $s =~ s{(?<![^\s(])\*(?=[^\s*])([^*\$`]*\$[^\$]+\$(?:[^*\$`]|\$[^\$]+\$)*)(?<=\S)\*(?!\w)}{<em>$1</em>}g;
    $s =~ s{(?<=\w-)\*([^*\$`]+)\*(?!\w)}{<em>$1</em>}g;
    $s =~ s{<a id="([\w-]+)"></a>}{'\anchor ' . place($rel, $1)}ge;
    $s =~ s/\\PaperEq\{\s*(\w+)\s*,\s*([^}]*?)\s*\}/paper_equation($1, $2)/ge;
    $s =~ s{(?<!!)\[((?:`[^`]*`|[^\]`])+)\]\(([^)\s]+)\)}{
        my ($all, $words, $url) = ($&, $1, $2);
        $url =~ m{^\w+:} ? $all : link_to($words, $url, $n) }ge;
    my $out = '';
    while ($s =~ m{\G(?: \$`(?<math>.+?)`\$ | (?<tick>`+)(?!`)(?<code>.*?)(?<!`)\k<tick>(?!`) | (?<comment><!--.*?-->) | (?<text>[^`\$<]+|.) )}gsx) {
        $out .= defined $+{math} ? "\\f\$$+{math}\\f\$" : defined $+{tick} ? "\x01$+{tick}$+{code}$+{tick}\x02" : $+{text} // '';
    }
    return join '', map { /^\x01(.*)\x02$/s ? $1 : formulas($_) } split /(\x01.*?\x02)/s, $out;
}

my %equations;    # paper -> { number -> label of the place that explains it }

sub equation_place {
    my ($paper, $number) = @_;
    if (!$equations{$paper}) {
        $equations{$paper} = {};
        for my $chapter (map { sprintf '%02d', $_ } @{ $chapters_of{$paper} // [] }) {
            my ($text) = glob "$root/chapters/ch${chapter}_*/README.md";
            next if !defined $text;
            my $content = slurp($text);
            $equations{$paper}{$1} //= "chapter-$chapter-eq-$1" while $content =~ /<a id="eq-([\w-]+)">/g;
        }
    }
    return $equations{$paper}{$number};
}

sub paper_equation {    # \PaperEq{Key, 23}
    my ($key, $numbers) = @_;
    my @number = map { my $place = equation_place($key, $_); $place ? "\@ref $place \"$_\"" : $_ } split /\s*,\s*/, $numbers;
    return "\\PaperEq{$key," . join('\, ', @number) . '}';
}

sub filter_source {
    for (@_) {
        next if !m{^\s*(///|\*|/\*\*)|///<};
        s/\\PaperEq\{\s*(\w+)\s*,\s*([^}]*?)\s*\}/paper_equation($1, $2)/ge;
    }
    print @_;
}

sub filter_text {
    my @line = @_;
    my ($fence, $display, $titled, $nav) = ('', 0, 0, 0);
    for my $i (0 .. $#line) {
        my ($text, $n) = ($line[$i], $i + 1);
        if ($fence) {
            if ($text =~ /^\s*\Q$fence\E\s*$/) {
                $text =~ s/\Q$fence\E/\\f]/ if $display;
                ($fence, $display) = ('', 0);
            }
            print $text;
        }
        elsif ($text =~ /^<!-- code ([^\s#]+)#/) {
            print '<div class="source">from ' . link_to('`' . basename($1) . '`', $1, $n) . "</div>\n";
        }
        elsif ($text =~ /^<!-- live (\w+) -->\s*$/) {
            my $source = clean(dirname($rel) . "/live/$1.cpp");
            my $copy   = -f "$root/$source" ? copy_as_text($source) : complain($n, "no live figure $1: expected $source");
            print qq{\\htmlonly[block]<div class="live" data-figure="$1" data-source="$copy"></div>\\endhtmlonly\n};
        }
        elsif ($text =~ /^\s*```math\s*$/) {
            $text =~ s/```math/\\f[/;
            ($fence, $display) = ('```', 1);
            print $text;
        }
        elsif ($text =~ /^\s*(```+|~~~+)/) { $fence = $1; print $text }
        elsif (!$titled && $text =~ /^# (.*?)\s*$/) {
            print "# $1" . (label($rel) eq 'index' ? '' : ' {#' . label($rel) . '}') . "\n";
            $titled = 1;
        }
        elsif ($titled == 1 && $text =~ /^\s*$/ && label($rel) =~ /^(chapter|notation)/) { print "\\tableofcontents\n"; $titled = 2 }
        elsif ($text =~ /^(##+) (.*?)\s*$/) {
            my ($level, $words) = ($1, $2);
            print "$level " . (prose($words, $n) =~ s/\s+$//r) . ' {#' . label($rel) . '-' . slug($words) . "}\n";
        }
        elsif ($text =~ /^!\[(.*)\]\(([^)\s]+)\)\s*$/) {    # raw HTML, so that every Doxygen treats it alike
            my ($words, $path) = ($1, clean(dirname($rel) . "/$2"));
            (my $alt = $words) =~ s/["<>&\$\\`]//g;
            complain($n, "no figure $path") if !-f "$root/$path";
            my $field = (slurp("$root/" . ($path =~ s/\.svg$/.gp/r)) // '') =~ /^[^#]*\bpalette\b/m ? ' field' : '';
            print qq{<div class="image$field"><img src="$path" alt="$alt"/><div class="caption">} . prose($words, $n) . "</div></div>\n";
        }
        elsif ($text =~ m{^(<details><summary>.*?</summary>|</details>)\s*$}) { print "\\htmlonly[block]$1\\endhtmlonly\n" }
        elsif ($text =~ /^<!-- (\/?)nav -->/) { $nav = !$1; print "\n" }
        elsif ($nav && $text =~ /\S/) { print '<div class="chapter-nav">' . (prose($text, $n) =~ s/\s+$//r) . "</div>\n" }
        else { print prose($text, $n) }
    }
}

my @line = split /^/, slurp($file) // die "doxfilter.pl: cannot read $file\n";
$file =~ /\.md$/ ? filter_text(@line) : filter_source(@line);
