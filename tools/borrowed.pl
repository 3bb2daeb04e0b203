#!/usr/bin/perl
# borrowed.pl ex6.1 FILE BUILD   has the answer FILE, which passes its tests, from the book what its exercise leaves to its author?
# borrowed.pl ROOT               does a starter or a solution below ROOT include what its exercise forbids?
# Exit status: 0 if not, 1 if so, with what it is, 2 if that cannot be found out.  tools/grade.pl asks borrowed() of whole folders.
#
# An answer is written with the standard library, Eigen and signorini/core.  What else of the library it may call stands on the page
# of its exercise behind "May call.": headers or folders below src/, or names of functions.  Three questions find what is borrowed:
#   includes  the headers that the compiler read: none of a chapter or a test, and of the library those that declare what may be
#             called, or that exercise.hpp reads
#   calls     the object file, compiled with -O0 so that inline functions and templates leave their symbols: no function of the
#             library but those; classes of the headers above may be used
#   copies    runs of sixteen tokens, blind to the names that an author gives: not two thirds of those of a function of the library
#             or of a chapter, unless the starter has them.  A function of fewer than fifty tokens can hardly be written in two ways.
#             An answer that stands in the place of its starter is not asked this.
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename qw(dirname);
use File::Find ();
use File::Temp qw(tempdir);
use JSON::PP ();
use Text::ParseWords qw(shellwords);

my $run      = 16;
my $shortest = 50;
my $most     = 2 / 3;
my $keyword  = join '|', qw(auto bool break case catch char class const constexpr continue decltype default delete do double else enum
    explicit false float for friend if int long mutable namespace new noexcept nullptr operator private public return short signed
    sizeof struct switch template this throw true try typename union unsigned using void volatile while);
my %text;

sub text_of {
    my ($file) = @_;
    return $text{$file} //= do {
        open my $in, '<', $file or die "borrowed.pl: cannot read $file: $!\n";
        local $/;
        <$in> // '';
    };
}

# The command of an entry of compile_commands.json without its input and output and without a compiler cache.
sub compile_words {
    my @words = shellwords($_[0]);
    shift @words if $words[0] =~ m{(?:^|/)(?:s?ccache|distcc)$};
    my @kept;
    while (@words) {
        my $word = shift @words;
        if ($word eq '-o' || $word eq '-c') { shift @words }
        else                                { push @kept, $word }
    }
    return @kept;
}

# What the page of an exercise allows, besides signorini/core.
sub may_call {
    my ($folder) = @_;
    my ($line) = text_of("$folder/README.md") =~ /\*\*May call\.\*\* (.*)/;
    return defined $line ? $line =~ /`([^`]+)`/g : ();
}

sub library {    # headers of the library, as paths below src/
    my ($root) = @_;
    my @found;
    File::Find::find({ no_chdir => 1, wanted => sub { push @found, s{^\Q$root\E/src/}{}r if /\.hpp$/ } }, "$root/src");
    return sort @found;
}

# Headers below src/ that these read, themselves among them.
sub read_by {
    my ($root, @files) = @_;
    my %seen;
    while (defined(my $file = shift @files)) {
        next if $seen{$file}++;
        push @files, grep { -f "$root/src/$_" } text_of("$root/src/$file") =~ /^\s*#\s*include\s*"([^"]+)"/mg;
    }
    return keys %seen;
}

# The headers that an answer may include, and the names of functions and classes that it may use.
sub allowed {
    my ($root, $folder) = @_;
    my @asked  = ('signorini/core', may_call($folder));
    my @all    = library($root);
    my (@whole, @declare, %name);
    for my $asked (@asked) {
        if ($asked =~ m{/}) { push @whole, grep { $_ eq $asked || index($_, "$asked/") == 0 } @all }
        else                { $name{$asked} = undef; push @declare, grep { text_of("$root/src/$_") =~ /\b\Q$asked\E\(/ } @all }
    }
    my @given = grep { -f "$root/src/$_" } text_of("$folder/exercise.hpp") =~ /^#include "([^"]+)"/mg;
    my @headers = read_by($root, @whole, @declare, @given);
    for my $header (@whole)   { @name{ text_of("$root/src/$header") =~ /\b([A-Za-z_]\w*)/g } = () }
    for my $header (@headers) { @name{ text_of("$root/src/$header") =~ /^\s*(?:struct|class|enum class|enum)\s+(\w+)/mg } = () }
    return ({ map { $_ => 1 } @headers }, \%name);
}

# Function bodies of a source: [name, tokens], and all tokens.  A name that an author gives is "i".
sub functions {
    my ($source) = @_;
    $source =~ s{//[^\n]*|/\*.*?\*/}{ }gs;
    $source =~ s/^\s*#.*$//gm;
    $source =~ s/\b(?:std|Eigen|signorini)\s*:://g;
    $source =~ s/\b(?:const|static|inline)\b//g;
    $source =~ s/"(?:\\.|[^"\n])*"/""/g;
    my @raw = $source =~ /(?:\.|->|::)\s*[A-Za-z_]\w*|[A-Za-z_]\w*|\d[\w.]*(?:[eE][-+]\d+)?|""|'(?:\\.|[^'])*'|<=|>=|==|!=|&&|\|\||\+\+|--|[-+*\/]=|\S/g;
    my @plain = map {    # functions of an object keep their names
        my $call = ($raw[$_ + 1] // '') eq '(';
        $raw[$_] =~ /^[A-Za-z_]/ && $raw[$_] !~ /^(?:$keyword)$/o ? 'i' : $raw[$_] =~ /^(\.|->)\s*[A-Za-z_]/ && !$call ? "$1i" : $raw[$_];
    } 0 .. $#raw;
    my @found;
    for (my $i = 1; $i < @raw; ++$i) {
        next if $raw[$i] ne '{' || $raw[$i - 1] ne ')';
        my ($depth, $name, $end) = (0, $i - 1, $i);
        do { $depth += ($raw[$name] eq ')') - ($raw[$name] eq '('); --$name } while $depth && $name >= 0;
        next if $name < 0 || $raw[$name] !~ /^(?:::\s*)?[A-Za-z_]\w*$/ || $raw[$name] =~ /^(?:if|for|while|switch|catch)$/;
        do { $depth += ($raw[$end] eq '{') - ($raw[$end] eq '}'); ++$end } while $depth && $end < @raw;
        push @found, [$raw[$name] =~ s/^::\s*//r, @plain[$i .. $end - 1]];
        $i = $end - 1;
    }
    return (\@plain, @found);
}

sub runs { return map { join ' ', @_[$_ .. $_ + $run - 1] } 0 .. $#_ - $run + 1 }

my %known;    # root -> functions of the book: [file, name, tokens]

sub book {
    my ($root) = @_;
    return @{ $known{$root} //= do {
        my @found;
        File::Find::find({ no_chdir => 1, wanted => sub {
            return if !/\.[ch]pp$/ || m{/exercises/};
            my ($file, undef, @functions) = ($File::Find::name, functions(text_of($_)));
            push @found, map { [$file, @$_] } grep { @$_ > $shortest } @functions;
        } }, "$root/src", "$root/chapters");
        \@found;
    } };
}

sub copied {
    my ($root, $folder, $answer) = @_;
    my %mine    = map { $_ => 1 } runs(@{ (functions($answer))[0] });
    my %starter = map { $_ => 1 } runs(@{ (functions(text_of("$folder/attempt.cpp")))[0] });
    for (book($root)) {
        my ($file, $name, @tokens) = @$_;
        my @theirs = grep { !$starter{$_} } runs(@tokens);
        next if @theirs < $shortest - $run;
        return "$name() of " . $file =~ s{^\Q$root\E/}{}r if $most * @theirs < grep { $mine{$_} } @theirs;
    }
    return;
}

# What an answer has from the book: nothing, or a sentence.
# exercise, its folder; the answer's source; its object file, compiled with -O0, and the list of what the compiler read for it
sub borrowed {
    my ($exercise, $folder, $source, $object, $read) = @_;
    my $root = abs_path("$folder/../../../..");
    my ($headers, $name) = allowed($root, $folder);
    my $way = '. An answer to ' . $exercise . ' may call of the library: ' . join(', ', 'signorini/core', may_call($folder))
        . '. Write the rest yourself, in attempt.cpp.';
    for my $file (split /[\s\\]+/, text_of($read)) {
        my $path = abs_path($file) // next;
        next if $path !~ m{^\Q$root\E/(src/(.+)|(?:chapters|tests)/.+\.hpp)$} || $path =~ m{/exercise\.hpp$} || defined $2 && $headers->{$2};
        return "includes $1$way";
    }
    open my $nm, '-|', 'nm', '-P', $object or die "no nm: $!\n";
    for (<$nm>) {
        my ($symbol, $length, $rest) = /^(_ZN[KVrRO]*9signorini(\d+)(\S+)) [A-Zuivw] / or next;
        next if exists $name->{ substr $rest, 0, $length };
        open my $in, '-|', 'c++filt', $symbol or die "no c++filt: $!\n";
        return 'calls ' . <$in> =~ s/\n//r . $way;
    }
    return if $source eq "$folder/attempt.cpp";
    my $copied = copied($root, $folder, text_of($source));
    return defined $copied ? "copies $copied$way" : undef;
}

sub judge_own {    # an answer that stands where the build compiles it
    my ($exercise, $file, $build) = @_;
    my $work = tempdir(CLEANUP => 1);
    my $path = abs_path($file);
    my ($entry) = grep { $_->{file} eq $path && index($_->{command}, "/${exercise}_attempt.dir/") >= 0 }
        @{ JSON::PP::decode_json(text_of("$build/compile_commands.json")) };
    my @command = compile_words(($entry // die "borrowed.pl: $build does not say how to compile $file\n")->{command});
    system(@command, qw(-O0 -w -MD -MF), "$work/answer.d", '-o', "$work/answer.o", '-c', $path) == 0
        or die "borrowed.pl: $file does not compile without optimisation\n";
    my $reason = borrowed($exercise, dirname($path), $path, "$work/answer.o", "$work/answer.d") // return 0;
    print "$exercise: but your answer $reason\n";
    return 1;
}

sub included {    # starters and solutions that include what they may not
    my ($root) = @_;
    my $bad = 0;
    for my $folder (glob "$root/chapters/ch*/exercises/ex*") {
        my ($headers) = allowed($root, $folder);
        for my $file (grep { -f } map { "$folder/$_.cpp" } qw(attempt solution)) {
            for my $header (grep { $_ ne 'exercise.hpp' && !$headers->{$_} } text_of($file) =~ /^\s*#\s*include\s*"([^"]+)"/mg) {
                print $file =~ s{^\Q$root\E/}{}r, ": includes $header, which its page does not allow\n";
                $bad = 1;
            }
        }
        for my $asked (may_call($folder)) {
            next if grep { $asked =~ m{/} ? $_ eq $asked || index($_, "$asked/") == 0 : text_of("$root/src/$_") =~ /\b\Q$asked\E\(/ } library($root);
            print $folder =~ s{^\Q$root\E/}{}r, "/README.md: the library has no $asked\n";
            $bad = 1;
        }
    }
    return $bad;
}

exit(eval { @ARGV == 3 ? judge_own(@ARGV) : included(abs_path($ARGV[0] // '.')) } // do { print STDERR $@; 2 }) if !caller;
1;
