# Json.pm: reads JSON without a module that a small installation of Perl lacks.  Dies with the place of what is no JSON.
package Json;
use strict;
use warnings;

sub value {    # from a reference to the rest of the text
    my ($rest) = @_;
    $$rest =~ s/^\s+//;
    return list($rest, qr/\]/, sub { value($rest) }) if $$rest =~ s/^\[//;
    return { @{ list($rest, qr/\}/, sub { my $name = value($rest); $$rest =~ s/^\s*:// or die "no colon: ", substr($$rest, 0, 40), "\n"; return ($name, value($rest)) }) } } if $$rest =~ s/^\{//;
    return $1 =~ s{\\(?:u([0-9a-f]{4})|(.))}{defined $1 ? chr(hex $1) : $2}ger if $$rest =~ s/^"((?:[^"\\]|\\.)*)"//;
    return $1 eq 'true' ? 1 : $1 eq 'false' ? 0 : undef if $$rest =~ s/^(true|false|null)\b//;
    return $1 + 0 if $$rest =~ s/^(-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)//;
    die 'no JSON: ', substr($$rest, 0, 40), "\n";
}

sub list {    # behind its first bracket
    my ($rest, $end, $item) = @_;
    my @all;
    return \@all if $$rest =~ s/^\s*$end//;
    do { push @all, $item->() } while $$rest =~ s/^\s*,//;
    $$rest =~ s/^\s*$end// or die 'no end of a list: ', substr($$rest, 0, 40), "\n";
    return \@all;
}

sub decode {
    my ($text) = @_;
    my $read = value(\$text);
    $text =~ /^\s*$/ or die 'more than JSON: ', substr($text, 0, 40), "\n";
    return $read;
}
1;
