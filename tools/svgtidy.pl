#!/usr/bin/env perl
# svgtidy.pl FILE.svg ...: removes what gnuplot's SVG does not need: empty groups, the line with gnuplot's
# version, titles (they are commands of gnuplot), blanks, the second decimal and a polygon's last point, which
# is its first; joins neighbouring polygons of one colour; gives the text a second and third choice of font,
# for machines without DejaVu; and keeps the blanks of labels that change their style, which programs other
# than browsers drop.  The text of labels stays as it is.
# svgtidy.pl --check FILE.svg ...: fails if a file is not as this program would leave it.
use strict;
use warnings;

my $check = @ARGV && $ARGV[0] eq '--check' && shift;
my $untidy = 0;

sub tidy_tag {  # only what is between < and >: the text of labels stays as it is
    my ($tag) = @_;
    $tag =~ s/(\d\.\d)\d(?=[,\s'"])/$1/g;
    $tag =~ s/[ \t]+(?='|\n)//g;
    $tag =~ s/\n\s+/\n/g;
    return $tag;
}

sub one_path {  # of neighbours of one colour: no seam between them, and half the size
    my ($polygons, $fill) = @_;
    my $d = '';
    for my $points ($polygons =~ /points='([^']*)'/g) {
        my ($x, $y, @rest) = split /[ ,]/, $points;
        my $start = "M$x,$y";
        my @steps;
        while (my ($to_x, $to_y) = splice @rest, 0, 2) {
            my $step = sprintf '%g,%g', map { sprintf '%.1f', $_ } $to_x - $x, $to_y - $y;
            push @steps, $step unless $step =~ /^-?0,-?0$/;
            ($x, $y) = ($to_x, $to_y);
        }
        $d .= $start . "l@{steps}z" if @steps > 1;
    }
    $d =~ s/-0(?=[, z])/0/g;
    $d =~ s/(?<![\d.])0\././g;
    $d =~ s/[, ]-/-/g;
    return $d eq '' ? '' : "<path fill=$fill d='$d'/>\n";
}

for my $file (@ARGV) {
    open my $in, '<', $file or die "$file: $!\n";
    my $svg = do { local $/; <$in> };
    close $in;
    my $before = $svg;
    $svg =~ s{<desc>.*?</desc>\n}{}s;
    $svg =~ s{<title>.*?</title>}{}sg;
    1 while $svg =~ s{<g [^>]*>\s*</g>\n?}{}g;
    $svg =~ s{(<[^>]*>)}{tidy_tag($1)}ge;
    $svg =~ s/(?<=>)\s*\n\s*(?=<)/\n/g;
    $svg =~ s{\s+\z}{\n};
    $svg =~ s{font-family="DejaVu Sans"}{font-family="DejaVu Sans,Verdana,Helvetica,Arial,sans-serif"}g;
    $svg =~ s/rgb\( *(\d+), *(\d+), *(\d+)\)/sprintf '#%02x%02x%02x', $1, $2, $3/ge;
    1 while $svg =~ s{<polygon fill =('[^']*') points ='(\S+)( [^']*) \2'/>}{<polygon fill=$1 points='$2$3'/>}g;
    $svg =~ s{(<polygon fill=('[^']*') points='[^']*'/>\n(?:<polygon fill=\2 points='[^']*'/>\n)+)}{one_path($1, $2)}ge;
    $svg =~ s{<text>(?=<tspan[^>]*>[^<]*</tspan><tspan)}{<text xml:space="preserve">}g;
    $untidy ||= $svg ne $before;
    next if $check;
    open my $out, '>', $file or die "$file: $!\n";
    print $out $svg;
    close $out or die "$file: $!\n";
}
exit 1 if $check && $untidy;
