#!/usr/bin/env perl
# svgtidy.pl FILE.svg ...: removes what gnuplot's SVG does not need: empty groups, the line with gnuplot's
# version, blanks, the second decimal and a polygon's last point, which is its first; gives the text a second
# and third choice of font, for machines without DejaVu; and keeps the blanks of labels that change their
# style, which programs other than browsers drop.
# svgtidy.pl --check FILE.svg ...: fails if a file is not as this program would leave it.
use strict;
use warnings;

my $check = @ARGV && $ARGV[0] eq '--check' && shift;
my $untidy = 0;
for my $file (@ARGV) {
    open my $in, '<', $file or die "$file: $!\n";
    my $svg = do { local $/; <$in> };
    close $in;
    my $before = $svg;
    $svg =~ s{<desc>.*?</desc>\n}{}s;
    1 while $svg =~ s{<g [^>]*>\s*</g>\n?}{}g;
    $svg =~ s/(\d\.\d)\d(?=[,\s'"])/$1/g;
    $svg =~ s/[ \t]+(?='|\n)//g;
    $svg =~ s/\n\s+/\n/g;
    $svg =~ s{font-family="DejaVu Sans"}{font-family="DejaVu Sans,Verdana,Helvetica,Arial,sans-serif"}g;
    $svg =~ s/rgb\( *(\d+), *(\d+), *(\d+)\)/sprintf '#%02x%02x%02x', $1, $2, $3/ge;
    1 while $svg =~ s{<polygon fill =('[^']*') points ='(\S+)( [^']*) \2'/>}{<polygon fill=$1 points='$2$3'/>}g;
    $svg =~ s{<text>(?=<tspan[^>]*>[^<]*</tspan><tspan)}{<text xml:space="preserve">}g;
    $untidy ||= $svg ne $before;
    next if $check;
    open my $out, '>', $file or die "$file: $!\n";
    print $out $svg;
    close $out or die "$file: $!\n";
}
exit 1 if $check && $untidy;
