#!/usr/bin/env perl
# batch.pl OUT FILE...               writes OUT, which compiles the files as one: what they include comes first and is read once, then each
#                                    stands in a namespace of its own, so that their names cannot clash
# batch.pl OUT --main NAME FILE...   the same for the programs of a chapter: the program NAME calls the main() of each, see run_programs()
# batch.pl --long FILE...            prints those whose heading, the comment at their beginning, has a line "// Takes longer than 5 s"
# A file still reads, and compiles, as one for itself; messages of the compiler name it.  Every #include is lifted, whatever condition it
# stands under; a brace that is missing in one file is reported in the next.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;
use File::Path 'make_path';

my ($out, @files) = @ARGV;
my $main;
(undef, $main) = splice @files, 0, 2 if @files && $files[0] eq '--main';
die "batch.pl OUT [--main NAME] FILE..., or batch.pl --long FILE...\n" if !@files;

sub content { my ($file) = @_; open my $in, '<', $file or die "batch.pl: $file: $!\n"; local $/; return scalar <$in> }

# The files that a program writes, after "Writes:" in its heading and on the next lines as long as one ends with a comma; empty if it takes less than 5 s.
sub committed {
    my ($file) = @_;
    my ($heading) = content($file) =~ m{\A((?://[^\n]*\n)*)};
    return '' if $heading !~ m{^// Takes longer than 5 s}m;
    my ($list) = $heading =~ m{\bWrites:\s*((?:[^\n]*,[ \t]*\n//)*[^\n]*)};
    my @written = grep { length } split m{[\s,/]+}, $list // '';
    die "batch.pl: $file takes longer than 5 s, but its heading does not say what it writes, as in: Writes: NAME.results, fig_1_2.csv\n" if !@written;
    return "@written";
}

if ($out eq '--long') { print map { "$_\n" } grep { committed($_) } @files; exit }

my (@headers, %known, $wrapped, $programs);
for my $file (@files) {
    my $folder = dirname($file);
    for my $header (content($file) =~ /^[ \t]*#[ \t]*include[ \t]*([<"][^>"]+[>"])/mg) {
        $header =~ s{^"(.*)"$}{'"' . abs_path("$folder/$1") . '"'}e if $header =~ /^"(.*)"$/ && -e "$folder/$1";
        push @headers, $header if !$known{$header}++;
    }
    my $name = basename($file, '.cpp');
    $name = basename($folder) . "_$name" if $name =~ /^test(?:_heldout)?$/;    # of an exercise
    (my $space = $name) =~ s/\W/_/g;
    $wrapped .= qq(namespace batch_$space {\n#include ") . abs_path($file) . qq("\n}\n);
    $programs .= qq(    {"$name", batch_$space\::main, ") . committed($file) . qq("},\n) if $main;
}
my $frame = '"signorini/report/program.hpp"';
push @headers, $frame if $main && !$known{$frame};
@headers = sort { ($a =~ /^</) <=> ($b =~ /^</) } @headers;    # ours first, so that each still has what it needs
my $text = '// Made by tools/batch.pl from ' . join(', ', map { basename(dirname($_)) . '/' . basename($_) } @files) . ": edit those.\n";
$text .= join('', map { "#include $_\n" } @headers) . $wrapped;
$text .= qq(int main(int argc, char** argv) {\n  return signorini::run_programs("$main", {\n$programs  }, argc, argv);\n}\n) if $main;
make_path(dirname($out));
open my $into, '>', $out or die "batch.pl: $out: $!\n";
print $into $text;
close $into or die "batch.pl: $out: $!\n";
