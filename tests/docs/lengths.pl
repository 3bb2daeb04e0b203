#!/usr/bin/env perl
# lengths.pl ROOT: no function of src/ has more than 40 lines, from the first line of its name and result to its last brace.
# Then plants long and short functions, and expects the long ones to be found.
use strict;
use warnings;
use File::Find;

my ($root) = @ARGV;
chdir $root or die "lengths.pl: no folder $root\n";
my $most = 40;

sub blank { my ($said) = @_; return $said =~ s/[^\n]/ /gr }

my $scope    = qr/^\s*(?:template\s*<.*>\s*)?(?:inline\s+)?(?:namespace|struct|class|union|extern)\b(?!.*\))/s;
my $function = qr/([~\w]+|operator\W+)\s*\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)\s*(?:const|noexcept|override|final|->[^()]*|:.*|\s)*$/s;

sub functions {    # name, first line and number of lines of each function of a source
    my ($code) = @_;
    $code =~ s{(R"(\w*)\(.*?\)\2"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|//[^\n]*|/\*.*?\*/)}{blank($1)}gse;
    $code =~ s/^[ \t]*#(?:[^\n]*\\\n)*[^\n]*/blank($&)/gme;
    my @found;
    my @open;                   # what the braces around this place are: scopes, functions, others
    my ($begin, $at) = (0, 0);  # of what is said since the last brace or semicolon, and of this place
    my $parens = 0;
    for my $part (split /([{};()])/, $code) {
        my $end = $at + length $part;
        if    ($part eq '(') { $parens++ }
        elsif ($part eq ')') { $parens-- }
        elsif ($part eq '{') {
            my $head = substr $code, $begin, $at - $begin;
            my %one  = (parens => $parens, inside => $parens || scalar($head =~ /\)\s*:(?!:).*\w\s*$/s));    # of arguments, or a member's
            if (!$one{inside} && !grep { !$_->{scope} } @open) {
                $one{scope} = $head =~ $scope;
                if (!$one{scope} && $head =~ $function) {
                    $one{name}  = $1;
                    $one{first} = $begin + length(($head =~ /^(\s*)/)[0]);
                }
            }
            push @open, \%one;
            $parens = 0;
            $begin  = $end if !$one{inside};
        } elsif ($part eq '}') {
            my $one = pop @open or die "lengths.pl: a brace that closes nothing\n";
            $parens = $one->{parens};
            $begin  = $end if !$one->{inside};
            push @found, [$one->{name}, map { 1 + tr/\n// } substr($code, 0, $one->{first}), substr($code, $one->{first}, $at - $one->{first})]
                if $one->{name};
        } elsif ($part eq ';') { $begin = $end if !$parens }
        $at = $end;
    }
    die "lengths.pl: a brace that nothing closes\n" if @open;
    return @found;
}

my $bad   = 0;
my $count = 0;
my @sources;
find({ no_chdir => 1, wanted => sub { push @sources, $_ if /\.[ch]pp$/ } }, 'src');
for my $file (sort @sources) {
    open my $in, '<', $file or die "lengths.pl: $file: $!\n";
    local $/;
    for my $one (functions(<$in>)) {
        my ($name, $line, $length) = @$one;
        $count++;
        next if $length <= $most;
        print "$file:$line: $name() has $length lines, at most $most are read at once: name its parts\n";
        $bad = 1;
    }
}
if ($count < 1000) { print "lengths.pl: found $count functions in src/, expected thousands\n"; $bad = 1 }

sub expect {    # what is found in a source, as NAME:LINE:LENGTH
    my ($wanted, $code) = @_;
    my $got = join ' ', map { join ':', @$_ } functions($code);
    return if $got eq $wanted;
    print "lengths.pl: expected '$wanted' of a planted source, got '$got':\n$code\n";
    $bad = 1;
}
my $body = "  x();\n" x 39;
expect('f:1:41', "void f() {\n$body}\n");
expect('f:2:3', "\nint f(int a) {\n  return a;\n}\n");
expect('f:1:4', "std::pair<int, int>\nf(int a,\n  int b) {\n}\n");
expect('g:4:42', "namespace a {\nnamespace {\n/// f() {\nvoid g(const std::function<void(int)>& f,\n   B b = {}) {\n$body}\n}\n}\n");
expect('A:3:42 size:45:1', "struct A : B {\n  int k = 0;\n  A(int a)\n      : k(a) {\n$body  }\n  int size() const { return k; }\n};\n");
expect('f:2:5', "template <typename T>\nclass A {}; auto f(T& t) -> int {\n  const auto g = [&] {\n    t();\n  };\n}\n");
expect('A:2:4', "struct A {\n  A(int a, B b = {})\n      : k{a}, b_(std::move(b)) {\n    x();\n  }\n};\n");
expect('operator():1:1', "bool operator()(int a) const { return a; }\n");
expect('h:2:3', "const int k[] = {1, 2, [](int a) { return a; }};\nvoid h() {\n  say(\"{\", '{', R\"(})\");  // {\n}\n");
exit $bad;
