#!/usr/bin/env perl
# linked_lines.pl ROOT [CHAPTER...]: how many lines of code of the library a chapter is linked with, read from the sources: one counts,
# with its own header, if it defines a function that is named where its declaration is included, in the chapter or in a source that
# counts, and src/plan allows the call. A folder with registered.cpp registers itself if the chapter includes a header of it. Two functions of one name that
# stand in one header are taken for one, so that a few sources too many count. Lines of code are neither comments nor blank.
# Without CHAPTER, such as ch02, holds the bounds below; then makes chapter 2 include a scene, in memory, and expects that to be found.
use strict;
use warnings;
use File::Find;

my ($root, @asked) = @ARGV;
chdir $root or die "linked_lines.pl: no folder $root\n";
# Round numbers above what each needs; a scene in chapter 2 alone adds thousands.
my %most = (ch02 => 6000, ch06 => 12000, ch11 => 12000);

my (%raw, %text, %includes, %all, %words, %declares, %defined, %may, %uses);

sub load {
    my ($file) = @_;
    return if exists $raw{$file};
    open my $in, '<', $file or die "linked_lines.pl: cannot read $file\n";
    local $/;
    $raw{$file} = $text{$file} = <$in>;
    $text{$file} =~ s{/\*.*?\*/|//[^\n]*}{}gs;
    $text{$file} =~ s{R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"}{""}gs;
    (my $folder = $file) =~ s{/[^/]*$}{};
    for my $header ($raw{$file} =~ /^#include "([^"]+)"/mg) {
        my ($found) = grep { -e } "src/$header", "$folder/$header", "tests/$header";
        next if !defined $found;
        1 while $found =~ s{[^/]+/\.\./}{};
        push @{ $includes{$file} }, $found;
    }
    $words{$file} = { map { $_ => 1 } $text{$file} =~ /([A-Za-z_]\w*)/g };
}

sub included {    # all headers that a file includes, also through others
    my ($file) = @_;
    load($file);
    return $all{$file} if $all{$file};
    my (%seen, @open);
    @open = @{ $includes{$file} // [] };
    while (defined(my $header = pop @open)) {
        next if $seen{$header}++;
        load($header);
        push @open, @{ $includes{$header} // [] };
    }
    return $all{$file} = \%seen;
}

sub arguments {    # between the parentheses that open at a place, without default values and blanks
    my ($code, $at) = @_;
    my ($depth, $end) = (1, $at);
    while ($depth > 0 && $end < length $code) {
        my $sign = substr $code, $end++, 1;
        $depth += $sign eq '(' ? 1 : $sign eq ')' ? -1 : 0;
    }
    my $list = substr $code, $at, $end - $at - 1;
    $list =~ s/=[^,]*//g;
    $list =~ s/\s+//g;
    return ($list, substr $code, $end, 60);
}

sub folder { my ($file) = @_; return $file =~ m{^src/(.*)/[^/]*$} ? $1 : '' }
sub own_header { my ($source) = @_; return $source =~ s/cpp$/hpp/r }

open my $plan, '<', 'src/plan' or die "linked_lines.pl: no src/plan\n";
while (<$plan>) {
    next if !m{^([a-z_/]+):(.*)};
    my ($name, $used) = ($1, $2);
    $may{$name}{$_} = 1 for $name, split ' ', $used;
}
my @sources;
find({ no_chdir => 1, wanted => sub { push @sources, $_ if /\.[ch]pp$/ } },
    map { "src/$_" } qw(signorini meshes closed_form papers addons));
load($_) for @sources;
for my $header (grep { /hpp$/ } @sources) {
    while ($text{$header} =~ /([A-Za-z_]\w*)\s*\(/g) {
        my $name = $1;
        my ($list) = arguments($text{$header}, pos $text{$header});
        $declares{$name}{$header}{$list}++;
    }
}
for my $source (grep { /cpp$/ } @sources) {
    (my $code = $text{$source}) =~ s/^namespace \{.*?^\}//gms;
    while ($code =~ /^(?!using|namespace|return|struct|class|template|static|#)[A-Za-z_][^;{}=()]*?(?:([A-Z]\w*)::)?(~?[a-z_A-Z]\w*)\(/mg) {
        my ($class, $name) = ($1, $2);
        my ($list, $after) = arguments($code, pos $code);
        next if $after !~ /^\s*(?:const|noexcept|\s)*(?:\{|:[^:])/;
        my @heads = grep { $declares{$name}{$_} } keys %{ included($source) };
        my @exact = grep { $declares{$name}{$_}{$list} } @heads;
        @heads = grep { $text{$_} =~ /\b(?:class|struct) $class\b/ } @heads if $class;
        $defined{$name}{$source}{$_} = 1 for !$class && @exact ? @exact : @heads;
        $defined{$name}{$source}{''} = 1 if !$class && $list eq '';    # perhaps of a table, which declares it itself
    }
}

sub only_declared {    # whether a header says a name once for each list of arguments, and so calls it nowhere
    my ($name, $header) = @_;
    my $lists = $declares{$name}{$header} or return 0;
    return !grep { $_ > 1 } values %$lists;
}

sub named {    # sources whose functions a file names
    my ($file) = @_;
    return $uses{$file} if $uses{$file};
    my ($headers, %found) = (included($file));
    for my $name (grep { $defined{$_} } keys %{ $words{$file} }) {
        for my $source (keys %{ $defined{$name} }) {
            next if $source eq $file || (included($source)->{$file} && only_declared($name, $file));
            my $heads = $defined{$name}{$source};
            my $table = $heads->{''} && $raw{$file} =~ /^#define SIGNORINI_\w+(?:[^\n]*\\\n)*[^\n]*\b$name\(\)/m;
            $found{$source} = 1 if $table || grep { $headers->{$_} || $_ eq $file } keys %$heads;
        }
    }
    return $uses{$file} = \%found;
}

sub called {    # by a file and the headers that it includes
    my ($file) = @_;
    my %found;
    for my $part ($file, grep { m{^src/} } keys %{ included($file) }) {
        for my $source (keys %{ named($part) }) {
            $found{$source} = 1 if !$may{ folder($file) } || $may{ folder($file) }{ folder($source) };
        }
    }
    return keys %found;
}

sub code_lines { my ($file) = @_; return scalar grep { /\S/ && !m{^\s*//} } split /\n/, $raw{$file} }

sub linked {    # a chapter, by its folder: lines of code
    my ($folder) = @_;
    my @own = glob "$folder/*.cpp $folder/*.hpp";
    my %allowed = map { folder($_) => 1 } map { keys %{ included($_) } } @own;
    my (%seen, @open);
    push @open, grep { $allowed{ folder($_) } } map { called($_) } @own;
    push @open, grep { -e } map { "src/$_/registered.cpp" } keys %allowed;
    while (defined(my $source = pop @open)) { push @open, called($source) if !$seen{$source}++ }
    my %files = map { $_ => 1 } keys %seen, grep { -e } map { own_header($_) } keys %seen;
    my $lines = 0;
    $lines += code_lines($_) for keys %files;
    return ($lines, scalar keys %seen);
}

my $bad = 0;
for my $chapter (@asked ? @asked : sort keys %most) {
    my ($folder) = glob "chapters/${chapter}_*";
    my ($lines, $sources) = linked($folder);
    print "$chapter: $lines lines of code in $sources sources\n" if @asked;
    next if @asked || $lines <= $most{$chapter};
    print "$chapter is linked with $lines lines of code in $sources sources, at most $most{$chapter} are wanted: ",
        "look at what it includes\n";
    $bad = 1;
}
exit $bad if $bad || @asked;

my ($folder) = glob 'chapters/ch02_*';
my ($header) = grep { load($_); $includes{$_} } glob "$folder/*.hpp";
push @{ $includes{$header} }, 'src/signorini/scene/readings.hpp';
$words{$header}{solved} = 1;
(%all, %uses) = ();
my ($lines) = linked($folder);
exit 0 if $lines > $most{ch02} + 3000;
print "linked_lines.pl: a scene in chapter 2 makes it $lines lines, and should make it many more\n";
exit 1;
