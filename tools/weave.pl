#!/usr/bin/env perl
# weave.pl [--check] FILE.md ...
#
# Fills the quoted parts of a text in place, so that it is complete wherever it is read:
#   <!--= key %.3f -->1.234<!--/-->                 value of `key` in results/chNN*.results beside the text
#   <!--= ch06.key %.3f -->1.234<!--/-->            the same from another chapter
#   <!-- table NAME.md --> ... <!-- /table -->      results/NAME.md, a table written by the program
#   <!-- code PATH#block --> ... <!-- /code -->     the lines of PATH between two "// [block]"
#   <!-- code PATH --> ... <!-- /code -->           all lines of PATH
#   <!-- nav --> ... <!-- /nav -->                  links to the neighbouring chapters, in the order of the table in chapters/README.md
# What stands in a fence or between back quotes is left alone.  With --check nothing is written; what is
# stale is listed and the exit status is 1.
use strict;
use warnings;
use File::Glob ':bsd_glob';    # a blank in a path does not separate patterns
use File::Basename;

my $check = @ARGV && $ARGV[0] eq '--check' ? shift : 0;
my $bad   = 0;

sub slurp {
    my ($file) = @_;
    open my $in, '<', $file or return undef;
    local $/;
    return scalar <$in>;
}

sub title { my ($dir) = @_; return (slurp("$dir/README.md") // '') =~ /^#\s+(.*?)\s*$/m ? $1 : basename $dir }

my %values;    # chapter folder -> { key -> [value, unit, varies] }

sub value {
    my ($dir, $key, $format) = @_;
    if ($key =~ /^(ch\d\d)\.(.+)/) {
        ($dir) = grep { -d } map { glob "$_/$1_*" } "$dir/chapters", $dir, "$dir/..", "$dir/../chapters", "$dir/../../..";
        return (undef, "no chapter '$1'") if !defined $dir;
        $key = $2;
    }
    if (!$values{$dir}) {
        my @file = glob "$dir/results/ch[0-9][0-9]*.results";
        return (undef, "'$key' is quoted, but there is no results/chNN.results") if !@file;
        for (map { split /\n/, slurp($_) } @file) {
            my ($k, @rest) = split ' ';
            next if !defined $k || $k =~ /^#/;
            return (undef, "two programs write '$k'") if $values{$dir}{$k};
            $values{$dir}{$k} = \@rest;
        }
    }
    my $found = $values{$dir}{$key} or return (undef, "no value '$key'");
    return (undef, "'$key' varies from run to run and cannot be quoted") if ($found->[2] // '') eq 'varies';
    return (undef, "'$key' needs a format such as %.3f") if $format !~ /^%[-+ 0]*\d*(?:\.\d+)?[defgEG]$/;
    return (undef, "'$key' is $found->[0], no integer for $format")
        if $format =~ /d$/ && $found->[0] != int $found->[0];
    return sprintf $format, $found->[0];
}

sub block {    # the lines of a source between two marks, without their common indentation
    my ($file, $name) = @_;
    my $source = slurp($file) // return (undef, "no file $file");
    return $source if !defined $name;
    my @part = split m{^[ \t]*//[ \t]*\[\Q$name\E\][ \t]*\n}m, $source, -1;
    return (undef, "$file needs exactly two lines '// [$name]', it has " . (@part - 1)) if @part != 3;
    my $code = $part[1];
    $code =~ s{^[ \t]*//[ \t]*\[[^\]\n]+\][ \t]*\n}{}mg;    # marks of other blocks
    my ($indent) = sort { length $a <=> length $b } $code =~ /^( *)\S/mg;
    $code =~ s/^\Q$indent\E//mg if defined $indent;
    return $code;
}

sub in_order {    # folders of chapters as chapters/README.md lists them, then those that it does not list
    my ($chapters, @folders) = @_;
    my ($readme, %place) = slurp("$chapters/README.md") // '';
    $place{$1} //= keys %place while $readme =~ m{\((ch\d\d_[^/)]*)/README\.md\)}g;
    my $of = sub { $place{ basename $_[0] } // 1000 };
    return sort { $of->($a) <=> $of->($b) || $a cmp $b } @folders;
}

sub navigation {
    my ($dir) = @_;
    my ($up, $chapters) = $dir =~ m{^(.*/)?ch\d\d_[^/]*$} ? ('../', dirname $dir) : ('', $dir);
    my @all = in_order($chapters, glob "$chapters/ch[0-9][0-9]_*");
    my ($i) = $up ? grep { $all[$_] eq $dir } 0 .. $#all : (-1);
    my $link = sub { my ($d, $l, $r) = @_; '[' . $l . title($d) . $r . "]($up" . basename($d) . '/README.md)' };
    my @link;
    push @link, $link->($all[$i - 1], '← ', '') if $i > 0;
    push @link, "[Contents](${up}README.md)";
    push @link, $link->($all[$i + 1], '', ' →') if $i < $#all;
    return join ' · ', @link;
}

for my $file (@ARGV) {
    my $dir = dirname $file;
    my $old = slurp($file) // die "weave.pl: cannot read $file\n";
    my @problem;
    my $fill = sub {    # the filled part, or the old one and a complaint
        my ($all, $head, $tail, $new, $why) = @_;
        return $head . $new . $tail if defined $new;
        push @problem, $why;
        return $all;
    };

    my $text = $old =~ s{
        (?<code>  (?<head><!--\ code\ (?<path>[^\s\#]+)(?:\#(?<block>[^>\n]+?))?\ -->\n) .*? (?<tail>^<!--\ /code\ -->) )
      | (?<table> (?<head><!--\ table\ (?<name>\S+)\ -->\n) .*? (?<tail>^<!--\ /table\ -->) )
      | (?<nav>   (?<head><!--\ nav\ -->\n) .*? (?<tail>^<!--\ /nav\ -->) )
      | (?<fence> ^[ >]*(?<f>```+|~~~+)[^\n]*\n .*? ^[ >]*\k<f>[ \t]*$ )
      | (?<span>  (?<b>`+)(?!`)[^\n]*?(?<!`)\k<b>(?!`) )
      | (?<value> (?<head><!--=\s*(?<key>\S+?)(?:\s+(?<format>%\S+))?\s*-->) (?<was>[^\n]*?) (?<tail><!--/-->) )
    }{
        my %p = %+;
        my $all = $&;
        if (defined $p{code}) {
            my ($code, $why) = block("$dir/$p{path}", $p{block});
            my $language = $p{path} =~ /\.toml$/ ? 'toml' : 'cpp';
            $fill->($all, $p{head}, $p{tail}, defined $code ? "\n```$language\n$code```\n\n" : undef, $why);
        }
        elsif (defined $p{table}) {
            my $table = slurp("$dir/results/$p{name}");
            $fill->($all, $p{head}, $p{tail}, defined $table ? "\n$table\n" : undef, "no table results/$p{name}");
        }
        elsif (defined $p{nav}) { $p{head} . "\n" . navigation($dir) . "\n\n" . $p{tail} }
        elsif (defined $p{value}) {
            my ($value, $why) = value($dir, $p{key}, $p{format} // '');
            push @problem, "'$p{key}' is $value, the text says $p{was}" if $check && defined $value && $value ne $p{was};
            $fill->($all, $p{head}, $p{tail}, $value, $why);
        }
        else { $all }
    }gemsxr;

    (my $prose = $text) =~ s/^[ >]*(```+|~~~+).*?^[ >]*\1[ \t]*$//gms;
    $prose =~ s/(`+)(?!`)[^\n]*?(?<!`)\1(?!`)//g;
    push @problem, 'a quoted value must not begin a line' if $prose =~ /^[ >]*<!--=/m;
    push @problem, 'no <!-- nav --> block' if $dir =~ m{(^|/)ch\d\d_[^/]*$} && $prose !~ /^<!-- nav -->\n.*^<!-- \/nav -->/ms;
    my %open = (code => 0, table => 0, nav => 0, '=' => 0);
    while ($prose =~ /<!--(?: (\/?)(code|table|nav)\b|(=)|(\/)-->)/g) {
        $open{ $2 // '=' } += ($1 || $4) ? -1 : 1;
    }
    push @problem, "a quotation <!--$_ ... is not closed, or closed twice" for grep { $open{$_} } sort keys %open;

    print "$file: $_\n" for @problem;
    $bad += @problem;
    next if $text eq $old;
    if ($check) {
        print "$file: quoted numbers, tables or code are stale, run 'make text'\n";
        $bad++;
    }
    else {
        open my $out, '>', $file or die "$file: $!\n";
        print $out $text;
        close $out or die "$file: $!\n";
        print "wove $file\n";
    }
}
exit($bad ? 1 : 0);
