#!/usr/bin/env perl
# findings.pl OUT chNN   says in words and units what a chapter that has run into OUT/chNN found, and which picture to open first
# findings.pl --check    whether every chapter's file `findings` fits the committed results, pictures and text; its exit status is 1 if not
#
# The file chapters/chNN_topic/findings has a line "figure fig_6_2", the picture that shows the headline, and sentences, one a line, the
# first with the headline, in which {key %.2f} is a value of the chapter's results with its unit, {reference %.2f} what the headline is
# compared with, and {deviation} how far it is from that, in percent.  Lines that begin with # are comments.
use strict;
use warnings;
use utf8;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns
use open ':std', ':encoding(UTF-8)';

sub slurp { my ($file) = @_; open my $in, '<', $file or return undef; local $/; return scalar <$in> }

sub results_of {    # key -> [number, unit], and the headline, of the files *.results of a folder
    my ($folder, $id) = @_;
    my (%value, @headline);
    for my $file (glob "$folder/$id*.results") {
        my $main = $file eq "$folder/$id.results";
        for (split /\n/, slurp($file)) {
            if    (/^# headline (\S+) (\S+)/) { @headline = ($1, $2) if $main }
            elsif (/^([^#\s]\S*) (\S+) (.+)/) { $value{$1} = [$2, $3] }
        }
    }
    return (\%value, @headline);
}

sub with_unit {
    my ($format, $number, $unit) = @_;
    $unit =~ s/\^2/²/, $unit =~ s/\^3/³/, $unit =~ s/\*/ /g, $unit =~ s/\bdeg\b/degrees/, $unit =~ s/\bu(?=[mJ]\b)/µ/;
    my $said = sprintf $format, $number;
    $said =~ s/^-(?=0(?:\.0*)?$)// if $format !~ /\+/;    # no -0
    return $said . ($unit eq '-' ? '' : " $unit");
}

sub quoted {    # what stands for {KEY FORMAT}, or undef and why
    my ($key, $format, $value, $headline, $reference) = @_;
    my $of = $key =~ /^(?:reference|deviation)$/ ? $headline : $key;
    return (undef, "there is no headline for {$key}") if !defined $of;
    my $found = $value->{$of} or return (undef, "no value '$of'");
    my ($number, $unit) = @$found;
    return (undef, "'$of' varies from run to run") if $unit =~ / varies$/;
    return (undef, "'$format' is no format such as %.3f") if $format !~ /^%[+]?\d*(?:\.\d+)?[defgEG]$/;
    return with_unit($format, $key eq 'reference' ? $reference : $number, $unit) if $key ne 'deviation';
    return (undef, 'no deviation from zero') if $reference == 0;
    return sprintf '%+.2g %%', 100 * ($number / $reference - 1);
}

sub filled {    # a sentence with its values; complaints go to @$bad
    my ($sentence, $value, $headline, $reference, $bad) = @_;
    $sentence =~ s{\{([\w.]+)(?: (%[^\}]*))?\}}{
        my ($said, $why) = quoted($1, $2 // '%.5g', $value, $headline, $reference);
        push @$bad, $why if defined $why;
        $said // "($1)";
    }ge;
    push @$bad, "a value is not closed: $sentence" if $sentence =~ /[{}]/;
    return $sentence;
}

sub findings_of {    # the picture and the sentences of a chapter's folder
    my ($folder) = @_;
    my @line = grep { /\S/ && !/^#/ } split /\n/, slurp("$folder/findings") // '';
    my ($figure) = map { /^figure (\S+)$/ ? $1 : () } @line;
    return ($figure, grep { !/^figure / } @line);
}

sub wrapped {    # at most 100 columns
    my ($text) = @_;
    my ($all, $line) = ('', '  ');
    for (split ' ', $text) {
        if (length($line) + length > 100) { $all .= "$line\n"; $line = '  ' }
        $line .= ($line eq '  ' ? '' : ' ') . $_;
    }
    return "$all$line\n";
}

sub complaints {
    my ($folder) = @_;
    my ($id) = $folder =~ m{(ch\d\d)_};
    my ($figure, @sentence) = findings_of($folder);
    my ($value, $headline, $reference) = results_of("$folder/results", $id);
    my @bad;
    push @bad, 'names no picture to open first, "figure fig_6_2"' if !defined $figure;
    push @bad, "there is no picture figures/$figure.svg" if defined $figure && !-f "$folder/../../figures/$figure.svg";
    push @bad, "README.md does not show $figure.svg" if defined $figure && slurp("$folder/README.md") !~ m{^!\[.*\]\([^)]*/\Q$figure\E\.svg\)$}m;
    push @bad, 'needs three to six sentences, it has ' . @sentence if @sentence < 3 || @sentence > 6;
    push @bad, "its first sentence does not have the headline, {$headline}" if defined $headline && ($sentence[0] // '') !~ /\{\Q$headline\E[ }]/;
    for my $sentence (@sentence) {
        my $said = filled($sentence, $value, $headline, $reference, \@bad);
        push @bad, "is no sentence, with a full stop and no semicolon: $said" if $said !~ /^[A-Z0-9].*\.$/ || $said =~ /;/;
        push @bad, "is longer than 240 signs: $said" if length $said > 240;
    }
    return @bad;
}

my ($out, $id) = @ARGV;
defined $out && ($out eq '--check' || defined $id) or die "usage: findings.pl OUT chNN, or findings.pl --check\n";
if ($out eq '--check') {
    my $bad = 0;
    for my $folder (grep { glob "$_/*.cpp" } glob 'chapters/ch[0-9][0-9]_*') {
        for (complaints($folder)) { print "$folder/findings: $_\n"; $bad++ }
    }
    exit($bad ? 1 : 0);
}
my ($folder) = glob "chapters/${id}_*" or die "findings.pl: no chapter $id\n";
my ($value, $headline, $reference) = results_of("$out/$id", $id);
my $seconds = slurp("$out/$id/seconds");
if (!%$value || !defined $seconds) { print "$id has failed, or has not run\n"; exit 1 }
my ($figure, @sentence) = findings_of($folder);
my $text = slurp("$folder/README.md") // '';
my ($number, $title) = $text =~ /^# (?:(\d+) )?(.*)/;
my @bad;
my @said = map { filled($_, $value, $headline, $reference, \@bad) } @sentence;
printf "Chapter %d: %s\n\n", $number // $id =~ s/ch//r, $title // $folder;
print wrapped($_) for @said;
if (defined $figure) {
    my ($caption) = $text =~ m{^!\[(Figure [\d.]+: .*)\]\([^)]*/\Q$figure\E\.svg\)$}m;
    my $picture = -f "$out/$id/$figure.svg" ? "$out/$id/$figure.svg" : "figures/$figure.svg";
    print "\nOpen first: $picture\n", defined $caption ? wrapped($caption) : '';
}
printf "\n%.2f s of processor time; numbers, tables and all figures are in %s\n", $seconds, "$out/$id";
print "findings.pl: $_\n" for @bad;
exit(@bad ? 1 : 0);
