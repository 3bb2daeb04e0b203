#!/usr/bin/env perl
# compare.pl [--update] CHAPTER FRESH
#
# Compares what the program of CHAPTER (chapters/chNN_topic) has just written into FRESH with what is
# committed: CHAPTER/results/chNN*.results, CHAPTER/results/*.md and figures/fig_N_*.csv.
#   chNN*.results  key by key: same unit, value within the tolerance of the committed file; lines marked
#                 `varies` and `# headline` lines must exist, the latter with the same words and reference
#   *.csv         same names, words and number of rows, numbers within the tolerance
#   *.md          words equal, integers exact, other numbers within one unit of the last printed digit
# What stands under a name that ends with ≈ (seconds, as a rule) was measured and is not compared.
# The tolerance is relative 1e-6 and absolute 0 (results) or 1e-9 (csv), or what a line of the file says:
#     # tolerance rel 1e-4 abs 1e-12
# With --update the files that differ are copied from FRESH, so that another compiler changes nothing.
use strict;
use warnings;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns
use File::Basename;

my $update = @ARGV && $ARGV[0] eq '--update' ? shift : 0;
@ARGV == 2 or die "usage: compare.pl [--update] chapters/chNN_topic FRESH\n";
my ($chapter, $fresh) = map { s{/+$}{}r } @ARGV;
my ($id, $nr) = basename($chapter) =~ /^(ch0*(\d+))_/ or die "compare.pl: '$chapter' is no chapters/chNN_topic\n";
my $figures = dirname($chapter) . '/../figures';
my $number  = qr/[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/;

sub slurp {
    my ($file) = @_;
    open my $in, '<', $file or return undef;
    local $/;
    return scalar <$in>;
}

sub names { my ($pattern) = @_; return map { basename $_ } grep { -f } glob $pattern }

sub larger { my ($x, $y) = @_; return $x > $y ? $x : $y }

sub tolerance {    # (relative, absolute) of a committed file
    my ($text, $rel, $abs) = @_;
    ($rel, $abs) = ($1, $2) if $text =~ /^# tolerance rel ($number) abs ($number)\s*$/m;
    return ($rel, $abs);
}

sub measured { my ($name) = @_; return $name =~ /\xe2\x89\x88\s*$/ }    # a column: its name ends with the sign

sub tolerance_line { my ($text) = @_; return $text =~ /^(# tolerance.*?)\s*$/m ? $1 : '' }

sub near {         # two words: equal, or numbers within the tolerance
    my ($old, $new, $rel, $abs) = @_;
    return 1 if $old eq $new;
    return 0 if $old !~ /^$number$/ || $new !~ /^$number$/;
    return abs($old - $new) <= larger($abs, $rel * larger(abs $old, abs $new));
}

sub last_digit {   # one unit in the last printed digit; 0 for an integer
    my ($mantissa, $exponent) = $_[0] =~ /^[-+]?([\d.]+)(?:[eE]([-+]?\d+))?$/;
    my $decimals = $mantissa =~ /\.(\d+)/ ? length $1 : 0;
    return 0 if !$decimals && !defined $exponent;
    return 1.000001 * 10**(($exponent // 0) - $decimals);
}

sub keys_of {      # lines of a results file: key -> [words]; headlines by their key as well
    my %line;
    for (split /\n/, $_[0]) {
        if    (/^# headline (\S+)\s+(.*)/)     { $line{"headline $1"} = [split ' ', $2] }
        elsif (!/^\s*(#|$)/ && /^(\S+)\s+(.*)/) { $line{$1} = [split ' ', $2] }
    }
    return \%line;
}

sub differ_results {
    my ($old, $new) = @_;
    my ($rel, $abs) = tolerance($old, 1e-6, 0);
    my ($o, $n) = (keys_of($old), keys_of($new));
    my @why = map { "'$_' is new" } grep { !$o->{$_} } sort keys %$n;
    for my $key (sort keys %$o) {
        if (!$n->{$key}) { push @why, "'$key' is no longer written"; next }
        my ($x, @unit_old) = @{ $o->{$key} };
        my ($y, @unit_new) = @{ $n->{$key} };
        push @why, "'$key' is in '@unit_new' instead of '@unit_old'" if "@unit_old" ne "@unit_new";
        next if $key !~ /^headline/ && (($unit_old[1] // '') eq 'varies');
        push @why, "$key is $y instead of $x" if !near($x, $y, $rel, $abs);
    }
    return join '; ', @why;
}

sub differ_csv {
    my ($old, $new) = @_;
    my ($rel, $abs) = tolerance($old, 1e-6, 1e-9);
    my @o = grep { !/^#/ } split /\n/, $old;
    my @n = grep { !/^#/ } split /\n/, $new;
    return 'has ' . @n . ' rows instead of ' . @o if @o != @n;
    my @column = split /,/, $o[0] // '';
    for my $i (0 .. $#o) {
        my @x = split /\s*,\s*/, $o[$i], -1;
        my @y = split /\s*,\s*/, $n[$i], -1;
        return "row $i: '$n[$i]' instead of '$o[$i]'" if @x != @y;
        for my $k (0 .. $#x) {
            next if near($x[$k], $y[$k], $rel, $abs) || ($i > 0 && measured($column[$k] // ''));
            return "row $i: " . ($column[$k] // "column $k") . " is $y[$k] instead of $x[$k]";
        }
    }
    return '';
}

sub differ_md {
    my ($old, $new) = @_;
    my @o = split /\n/, $old;
    my @n = split /\n/, $new;
    return 'has ' . @n . ' lines instead of ' . @o if @o != @n;
    my @leave;
    for my $i (0 .. $#o) {
        my @cell = map { [split /(?<!\\)\|/, $_, -1] } $o[$i], $n[$i];
        @leave = grep { measured($cell[0][$_]) } 0 .. $#{ $cell[0] } if $i == 0 || $o[$i - 1] !~ /^\|/;
        if (@leave && @{ $cell[0] } == @{ $cell[1] } && $o[$i] =~ /^\|/ && !grep { measured($_) } @{ $cell[0] }) {
            $_->@[@leave] = ('') x @leave for @cell;
            ($o[$i], $n[$i]) = map { join '|', @$_ } @cell;
        }
        my @x = split /($number)/, $o[$i] =~ s/[ \t]+/ /gr;
        my @y = split /($number)/, $n[$i] =~ s/[ \t]+/ /gr;
        for my $k (0 .. larger($#x, $#y)) {
            my ($p, $q) = ($x[$k] // '', $y[$k] // '');
            next if $p eq $q;
            my $numbers = $p =~ /^$number$/ && $q =~ /^$number$/;
            next if $numbers && abs($p - $q) <= larger(last_digit($p), last_digit($q));
            return 'line ' . ($i + 1) . ': ' . ($numbers ? "$q instead of $p" : "'$n[$i]' instead of '$o[$i]'");
        }
    }
    return '';
}

my %seen = ("$chapter/results/$id.results" => 1);
$seen{"$chapter/results/$_"} = 1 for map { names("$chapter/results/$_"), names("$fresh/$_") } "${id}_*.results", '*.md';
$seen{"$figures/$_"}         = 1 for names("$figures/fig_${nr}_*.csv"), names("$fresh/fig_${nr}_*.csv");
my $bad = 0;
for my $committed (sort keys %seen) {
    my $written = "$fresh/" . basename $committed;
    my ($old, $new) = (slurp($committed), slurp($written));
    my $shown = $committed =~ s{[^/]+/\.\./}{}r;
    if (!defined $new && !defined $old) { print "$written: the program did not write it\n"; $bad++; next }
    my $why =
        !defined $old ? 'is not committed'
      : !defined $new ? 'is no longer written'
      : tolerance_line($old) ne tolerance_line($new) ? 'has another tolerance now'
      : $committed =~ /\.md$/  ? differ_md($old, $new)
      : $committed =~ /\.csv$/ ? differ_csv($old, $new)
      :                          differ_results($old, $new);
    next if $why eq '';
    if (!$update) { print "$shown: $why\n"; $bad++; next }
    if (!defined $new) { unlink $committed or die "$committed: $!\n"; print "removed $shown\n"; next }
    mkdir dirname $committed if !-d dirname $committed;
    open my $out, '>', $committed or die "$committed: $!\n";
    print $out $new;
    close $out or die "$committed: $!\n";
    print "updated $shown ($why)\n";
}
print "If the new values are right: make results\n" if $bad;
exit($bad ? 1 : 0);
