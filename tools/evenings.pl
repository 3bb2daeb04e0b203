#!/usr/bin/env perl
# evenings.pl --check [ROOT], evenings.pl --leads ROOT: the sources of the library as pages to read.
#
# src/evenings lists the files of src/signorini/ and src/papers/ in the order in which they are read. --check complains if a file
# stands on no evening or on two, if a header includes one that comes later, if a file has more than 250 lines or if less than a
# quarter of its lines that are not blank are comments, and if a link or
# an equation in a comment leads nowhere. tools/book makes the pages. For them --leads prints, for each function of a source that a
# header declares, the file, the line at which its code begins and, in Markdown, where it leads: to its contract (of a private one, that
# of its class), to tests and chapters that use it, and to equations of the papers that its comments name.
use strict;
use warnings;
use File::Basename qw(basename dirname);
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns

my ($longest, $share) = (250, 4);    # lines of a file; one line of so many narrates
my $mode = @ARGV ? shift @ARGV : '';
my ($root) = (@ARGV, '.');
die "usage: evenings.pl --check [ROOT] | --leads ROOT\n" if $mode !~ /^--(?:check|leads)$/;
chdir $root or die "evenings.pl: no folder $root\n";
my @complaints;

sub slurp {
    my ($file) = @_;
    open my $in, '<', $file or die "evenings.pl: $file: $!\n";
    local $/;
    return <$in>;
}

# ---- The list: evenings with title, text and files.

my (@evening, @page);
for (split /\n/, slurp('src/evenings')) {
    next if /^#|^$/;
    if (/^evening \d+: (.+)/) { push @evening, { title => $1, text => '', files => [] } }
    elsif (/^ +(.*)/ && @evening) { $evening[-1]{text} .= "$1\n" }
    elsif (/^\w[\w\/]*$/ && @evening) {
        my @there = grep { -f "src/$_" } "$_.hpp", "$_.cpp";
        push @complaints, "src/evenings: there is no $_.hpp and no $_.cpp" if !@there;
        push @{ $evening[-1]{files} }, @there;
    }
    else { push @complaints, "src/evenings: expected an evening or a name, got: $_" }
}
for my $n (1 .. @evening) { push @page, map { { path => $_, evening => $n } } @{ $evening[$n - 1]{files} } }
my (%at, %text);
$at{ $page[$_]{path} }++ && push @complaints, "src/evenings: $page[$_]{path} stands twice" for 0 .. $#page;
%at = map { $page[$_]{path} => $_ } 0 .. $#page;
for (map { s{^src/}{}r } glob('src/{signorini/*,papers}/*.[ch]pp')) {
    push @complaints, "src/evenings: $_ stands on no evening" if !exists $at{$_};
}
$text{ $_->{path} } = slurp("src/$_->{path}") for @page;

# ---- What a file has to be.

sub narrates { my @line = grep { /\S/ } split /\n/, $_[0]; return $share * grep({ m{^\s*//} } @line) >= @line }

for my $path (sort keys %text) {
    my $lines = ($text{$path} =~ tr/\n//);
    push @complaints, "src/$path: $lines lines, at most $longest are read in one go" if $lines > $longest;
    push @complaints, "src/$path: fewer comments than one line of $share" if !narrates($text{$path});
    next if $path !~ /hpp$/;
    for my $used ($text{$path} =~ /^#include "([^"]+)"/mg) {
        push @complaints, "src/evenings: $path includes $used, which comes later" if exists $at{$used} && $at{$used} > $at{$path};
    }
}

# ---- A file as pieces of prose and code.

sub pieces {
    my @piece;
    my ($n, $in) = (0, '');
    for my $line (split /\n/, $_[0]) {
        ++$n;
        next if $line =~ m{^// \[[\w ]+\]$};    # where a chapter quotes the file
        if ($line =~ m{^///? ?(.*)}) {
            push @piece, { prose => [], code => [] } if $in ne 'prose' && !(@piece && !@{ $piece[-1]{code} });
            push @{ $piece[-1]{prose} }, $1;
            $in = 'prose';
        }
        elsif ($line =~ /\S/ || $in eq 'code') {
            push @piece, { prose => [], code => [] } if !@piece;
            $piece[-1]{first} //= $n;
            push @{ $piece[-1]{code} }, $line;
            $in = 'code';
        }
        else { push @{ $piece[-1]{prose} }, '' if @piece; $in = '' }    # a blank line after a comment
    }
    for (@piece) { pop @{ $_->{code} } while @{ $_->{code} } && $_->{code}[-1] !~ /\S/ }
    return @piece;
}

# ---- What functions lead to.

# Functions that a piece of code defines at file scope, as NAMESPACE::CLASS::NAME; $spaces are the namespaces that are open.
sub defined_here {
    my ($code, $spaces) = @_;
    my (@name, $head, $open);
    for (@$code) {
        if    (/^(?:inline )?namespace ?([\w:]*) ?\{/) { push @$spaces, $1 eq '' ? '-' : $1 }
        elsif (m{^\}  // namespace} || (/^\}$/ && !$open)) { pop @$spaces }
        elsif (/^[a-zA-Z\[]/ && !/^(?:using|struct|class|enum|template|namespace|typedef|extern|static_assert)\b/) { $head = $_ }
        elsif (/^\s/ && defined $head && $head !~ /[{;]$/) { $head .= $_ }
        $open = 0 if /^\}/;
        next if !defined $head || $head !~ /[{;}]\s*(?:\/\/.*)?$/;
        $open = 1 if $head =~ /\{$/;
        my $inside = join('::', grep { $_ ne 'signorini' } @$spaces) =~ s/^signorini:://r;
        push @name, ($inside ? "${inside}::" : '') . $1
            if $head !~ /;\s*(?:\/\/.*)?$/ && $head !~ /^[^(]*=/ && $head =~ /^[^(]*?((?:\w+::)*~?\w+)\(/ && $inside !~ /-/;
        undef $head;
    }
    return @name;
}

# Functions that headers declare for everybody, as NAMESPACE::CLASS::NAME: the header, and the equations of their contract.
my (%declared, %class_in);
for my $header (glob 'src/{signorini/*,papers}/*.hpp') {
    my (@space, @class, $said, $kept);    # a class has a name, its indentation, and whether what follows is public
    for (split /\n/, slurp($header)) {
        if    (/^namespace (\w*) ?\{/) { push @space, $1 }
        elsif (m{^\}  // namespace}) { pop @space }
        elsif (/^( *)(class|struct) (\w+)[^;]*\{$/) { push @class, { name => $3, at => length $1, public => $2 eq 'struct' }; $class_in{$3} = $header if $1 eq '' }
        elsif (/^( *)\};/ && @class && length $1 == $class[-1]{at}) { pop @class }
        elsif (/^ *(public|private|protected):/ && @class) { $class[-1]{public} = $1 eq 'public' }
        if (m{^\s*///}) { $said = ($kept ? '' : $said // '') . "$_\n"; $kept = 0; next }
        $kept = 1 if !/\S/ || /[;{}]/;    # the comment belongs to what is declared below it, until that ends
        next if !/^( *)(?=\S)(?:.*?[^\w.>:~])??(~?[A-Za-z]\w*)\((?!\*)/ || length $1 != (@class ? $class[-1]{at} + 2 : 0) || grep { !$_->{public} } @class;
        next if $2 =~ /^(?:if|for|while|return|switch|defined|decltype|sizeof)$/ || /^\s*(?:\/\/|#|using)/;
        my $name = join '::', (grep { $_ ne 'signorini' } @space), (map { $_->{name} } @class), $2;
        $declared{$name} //= { header => $header, equations => [($said // '') =~ /\\PaperEq\{[^}]*\}/g] };
    }
}

# Which texts and programs of chapters, and which tests, use a function; one that defines the name itself does not use the library's.
my (%used_by, %explained);
for my $file (glob('chapters/ch[0-9][0-9]_*/*.{md,cpp,hpp}'), glob('tests/*/test_*.cpp')) {
    my $content = slurp($file);
    my %own  = map { $_ => 1 } $content =~ /^\w[^\n(=;]* (\w+)\([^;{}]*\{$/mg;
    my %name = map { $_ => 1 } $content =~ /(?<![\w.>:])(\w+)(?:<[\w:]+>)?\(/g, $content =~ /`([\w:]+)(?:\(\))?`/g, $content =~ /\b([A-Z]\w*) \w+[({]/g;
    my %member = map { $_ => 1 } $content =~ /(?:\.|->|::)(\w+)\(/g;
    my %type   = map { $_ => 1 } $content =~ /\b([A-Z]\w*)\b/g;
    push @{ $used_by{$_} }, $file for grep { !$own{$_} } keys %name;
    for (keys %declared) { push @{ $used_by{$_} }, $file if /(\w+)::(\w+)$/ && !$name{$_} && $type{$1} && $member{$2} }
    my $paper = $file =~ /ch0[1-7]/ ? 'XuanLi2002' : 'LinEtAl';    # whose numbers the equations of a chapter are
    for ($file =~ /README/ ? $content =~ /<a id="eq-(\w+)">/g : ()) { $explained{"$paper $_"} = 1 }
}
$used_by{"${_}::$_"} = $used_by{$_} for grep { /^[A-Z]\w*$/ } keys %used_by;    # a constructor

sub users { my ($name, $where) = @_; return sort grep { /$where/ } @{ $used_by{$name} // $used_by{ $name =~ s/^[a-z]\w*:://r } // [] } }

sub away { my ($from, $to) = @_; return '../' x (() = $from =~ m{/}g) . $to }    # a path from the root, as from the file $from

sub own_test { return 'tests/' . basename(dirname($_[0])) . '/test_' . basename($_[0]) =~ s/\.[ch]pp$/.cpp/r }

sub leads {    # where a function leads
    my ($from, $name, @equations) = @_;
    my $known = $declared{$name};
    return "part of [`$1`](" . away($from, $class_in{$1}) . ")" if !$known && $name =~ /^(\w+)::\w+$/;    # a private function
    my $line = '[`' . ($name =~ /^(.*\b(\w+))::~?\2$/ ? $1 : "$name()") . '`](' . away($from, $known->{header}) . ')';
    my $own   = own_test($from);
    my @tests = users($name, '^' . dirname($own) . '/');
    @tests = ($own) if grep { $_ eq $own } @tests;
    my %number = map { m{ch(\d\d)_} => '[' . ($1 + 0) . '](' . away($from, dirname($_) . '/README.md') . ')' }
        users($name, '^chapters/');
    my %seen;
    @equations = grep { !$seen{$_}++ } @{ $known->{equations} }, @equations;
    $line .= ' · ' . join ', ', map { '[' . basename($_) . '](' . away($from, $_) . ')' } @tests[0 .. ($#tests < 2 ? $#tests : 2)] if @tests;
    $line .= ' · chapter' . (keys %number > 1 ? 's ' : ' ') . join ', ', map { $number{$_} } sort keys %number if %number;
    $line .= ' · ' . join ', ', @equations if @equations;
    return $line;
}

# ---- What was asked for.

sub functions {    # of a source: the line at which the code of a function begins, and where it leads
    my ($path) = @_;
    my @spaces;
    for my $piece (pieces($text{$path})) {
        my ($n, @equations) = ($piece->{first}, join("\n", @{ $piece->{prose} }) =~ /\\PaperEq\{[^}]*\}/g);
        for my $part (split /(?<=\n)(?=\n\S)/, join '', map { "$_\n" } @{ $piece->{code} }) {
            my %seen;
            my @name = grep { (exists $declared{$_} || /^(\w+)::\w+$/ && exists $class_in{$1}) && !$seen{$_}++ } defined_here([split /\n/, $part], \@spaces);
            print "src/$path\t", $n + ($part =~ /^\n/), "\t", leads("src/$path", $_, @equations), "\n" for @name;
            @equations = () if @name;
            $n += ($part =~ tr/\n//);
        }
    }
}

if ($mode eq '--leads') {
    functions($_->{path}) for grep { $_->{path} =~ /cpp$/ } @page;
    exit 0;    # pages are made of a list with faults, too
}
for my $path (sort keys %text) {    # links and equations of comments lead somewhere
    my $said = join "\n", map { @{ $_->{prose} } } pieces($text{$path});
    while ($said =~ /\\PaperEq\{\s*(\w+)\s*,\s*(\w+)\s*\}/g) {
        push @complaints, "src/$path: no chapter explains equation ($2) of $1" if !$explained{"$1 $2"};
    }
    $said =~ s/`[^`\n]*`//g;
    for my $to ($said =~ /\]\(([^)\s#]+)[^)]*\)/g) {
        push @complaints, "src/$path: there is no $to" if $to !~ /^\w+:/ && !-e dirname("src/$path") . "/$to";
    }
}
print STDERR "$_\n" for @complaints;
exit(@complaints ? 1 : 0);
