#!/usr/bin/env perl
# batch.pl OUT FILE...               writes OUT, which compiles the files as one: what they include comes first and is read once, then each
#                                    stands in a namespace of its own, so that their names cannot clash
# batch.pl OUT --main NAME FILE...   the same for the programs of a chapter: the program NAME calls the main() of each, see run_programs()
# A file still reads, and compiles, as one for itself; messages of the compiler name it.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename;

my ($out, @files) = @ARGV;
my $main;
(undef, $main) = splice @files, 0, 2 if @files && $files[0] eq '--main';
die "batch.pl OUT [--main NAME] FILE...\n" if !@files;

sub content { my ($file) = @_; open my $in, '<', $file or die "batch.pl: $file: $!\n"; local $/; return scalar <$in> }

my (@headers, %known, $wrapped, $programs);
for my $file (@files) {
    my $folder = dirname($file);
    for my $header (content($file) =~ /^#include\s+([<"][^>"]+[>"])/mg) {
        $header =~ s{^"(.*)"$}{'"' . abs_path("$folder/$1") . '"'}e if $header =~ /^"(.*)"$/ && -e "$folder/$1";
        push @headers, $header if !$known{$header}++;
    }
    my $name = basename($file, '.cpp');
    $name = basename($folder) . "_$name" if $name =~ /^test(?:_heldout)?$/;    # of an exercise
    (my $space = $name) =~ s/\W/_/g;
    $wrapped .= qq(namespace batch_$space {\n#include ") . abs_path($file) . qq("\n}\n);
    my $long = content($file) =~ m{^// Takes longer than 5 s}m ? ', true' : '';
    $programs .= qq(    {"$name", batch_$space\::main$long},\n);
}
@headers = sort { ($a =~ /^</) <=> ($b =~ /^</) } @headers;    # ours first, so that each still has what it needs
push @headers, '"signorini/report/program.hpp"' if $main;
my $text = join('', map { "#include $_\n" } @headers) . $wrapped;
$text .= qq(int main(int argc, char** argv) {\n  return signorini::run_programs("$main", {\n$programs  }, argc, argv);\n}\n) if $main;
open my $into, '>', $out or die "batch.pl: $out: $!\n";
print $into $text;
close $into or die "batch.pl: $out: $!\n";
