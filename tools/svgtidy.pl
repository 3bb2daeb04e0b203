#!/usr/bin/env perl
# svgtidy.pl FILE.svg ...: removes what gnuplot's SVG does not need: empty groups, the line with gnuplot's
# version, blanks, the second decimal and a polygon's last point, which is its first; gives the text a second
# and third choice of font, for machines without DejaVu; and says where blanks between two styles stay.
use strict;
use warnings;

for my $file (@ARGV) {
    open my $in, '<', $file or die "$file: $!\n";
    my $svg = do { local $/; <$in> };
    close $in;
    $svg =~ s{<desc>.*?</desc>\n}{}s;
    1 while $svg =~ s{<g [^>]*>\s*</g>\n?}{}g;
    $svg =~ s/(\d\.\d)\d(?=[,\s'"])/$1/g;
    $svg =~ s/[ \t]+(?='|\n)//g;
    $svg =~ s/\n\s+/\n/g;
    $svg =~ s{font-family="DejaVu Sans"}{font-family="DejaVu Sans,Verdana,Helvetica,Arial,sans-serif"}g;
    $svg =~ s/rgb\( *(\d+), *(\d+), *(\d+)\)/sprintf '#%02x%02x%02x', $1, $2, $3/ge;
    $svg =~ s{<polygon fill =('[^']*') points ='(\S+)( [^']*) \2'/>}{<polygon fill=$1 points='$2$3'/>}g;
    $svg =~ s{<text>(?=<tspan[^>]*>[^<]*</tspan><tspan)}{<text xml:space="preserve">}g;
    open my $out, '>', $file or die "$file: $!\n";
    print $out $svg;
    close $out or die "$file: $!\n";
}
