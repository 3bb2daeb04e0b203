#!/usr/bin/env perl
# named.pl ROOT: every file, target of make, group of the set-up, command and option that the guides name exists; every open
# family of the library has its row in CONTRIBUTING.md, with the table that its source has; every exercise is of the kind that the instructor's sheet counts; and CITATION.cff has the
# version of CMakeLists.txt, and the Containerfile runs the commands of the README.  Then plants a fault in each of these, and expects it to be found.
use strict;
use warnings;
use File::Glob ':bsd_glob';

my ($root) = @ARGV;
chdir $root or die "named.pl: no folder $root\n";
my @guides = ('README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'chapters/README.md', glob 'docs/*.md');
my %text;    # file -> what it is taken to say

sub slurp {
    my ($file) = @_;
    return $text{$file} if defined $text{$file};
    open my $in, '<', $file or die "named.pl: $file: $!\n";
    local $/;
    return $text{$file} = <$in>;
}

my $makefile = slurp('Makefile');
my $options  = join '', map { slurp($_) } glob('src/command_line/*.cpp');
my %group    = map { $_ => 1 } slurp('tools/setup.sh') =~ /^    (\w+)\) wanted=/mg;
my %command  = map { $_ => 1 } $options =~ m{\bapp(?:,|\.add_subcommand\()\s*"(\w+)"}g;
die "named.pl: found no groups or no commands\n" if !%group || !%command;

sub exists_target {
    my ($target) = @_;
    return $makefile =~ /^\Q$target\E:/m if $target !~ /^(?:ch(\d\d)|ex(\d+)\.(\d+))$/;
    my @found = glob(defined $1 ? "chapters/ch$1_*" : sprintf('chapters/ch%02d_*/exercises/ex%d_*', $2, $3));
    return scalar @found;
}

sub wrong_words {    # what a piece of code names that does not exist
    my ($code) = @_;
    my @bad;
    push @bad, map { "no target $_ of make" } grep { !/NN/ && !exists_target($_) } $code =~ /(?:^|&& |; )make ([a-z][\w.-]*)/g;
    if ($code =~ m{^tools/setup\.sh (.*?)(?: &&|$)}) { push @bad, map { "no group $_ of the set-up" } grep { !$group{$_} } split ' ', $1 }
    if ($code =~ m{^(?:build/bin/)?signorini ([a-z]\w*)}) { push @bad, "no command $1 of signorini" if !$command{$1} }
    if ($code =~ m{^(?:build/bin/)?signorini |^--}) {
        push @bad, map { "no option $_ of signorini" } grep { $options !~ /"(?:-\w,)?$_\b/ && !/^--help$/ } $code =~ /(?<!\S)(--[a-z]+)/g;
    }
    for my $path ($code =~ m{(?<![\w./-])((?:\./)?(?:src|tests|tools|chapters|examples|figures|docs|cmake|bench|\.ci|\.)/[\w./*-]+)}g) {
        next if $path =~ m{NN|exK|NAME|\.\.\.$|^\./build/};
        push @bad, "no file $path" if !grep { -e } glob $path;
    }
    return @bad;
}

sub check {
    my @found;
    for my $file (@guides) {
        my ($fence, $n) = ('', 0);
        for my $line (split /\n/, slurp($file)) {
            $n++;
            if ($line =~ /^\s*(```+)(\w*)/) { $fence = $fence ? '' : $2 || 'text'; next }
            my @code = $fence eq 'sh' ? $line =~ s/\s+#\s.*//r : $fence ? () : $line =~ /`([^`]+)`/g;
            push @found, map { "$file:$n: $_" } map { wrong_words($_) } @code;
        }
    }
    my %row;    # file of the table -> its name
    for (split /\n/, slurp('CONTRIBUTING.md')) {
        $row{$3} = [$1, $2] if /^\| ([\w ]+) \| .* \| `(\w+)(?:\(\))?` in \[\w+\.cpp\]\(([\w\/.]+)\) \|/;
    }
    for my $file (glob 'src/{signorini/*,papers,addons/*}/*.cpp') {
        my ($members) = slurp($file) =~ /static (?:const )?std::vector<\w+> family = \{\s*(\w*)/ or next;
        my $row = delete $row{$file};
        if (!$row) { push @found, "CONTRIBUTING.md has no row for the family of $file"; next }
        push @found, "CONTRIBUTING.md: no table $row->[1] in $file" if slurp($file) !~ /\b$row->[1]\b/;
    }
    push @found, "CONTRIBUTING.md: $_ has no family" for sort keys %row;
    for my $page (-f 'docs/instructor.md' ? glob 'chapters/ch*/exercises/ex*/README.md' : ()) {
        my ($chapter, $k) = $page =~ m{/ch(\d+)_.*/ex(\d+)_};
        my $exercise = $chapter + 0 . ".$k";
        my ($kind) = slurp($page) =~ /^\*\*Kind\.\*\* (\w+)/m;
        my ($rung) = slurp('docs/instructor.md') =~ /^\| \Q$exercise\E \| (\w+) \|/m;
        push @found, "$page: its kind is " . ($kind // 'not given') . ', the rung of docs/instructor.md ' . ($rung // 'missing') if ($kind // 0) ne ($rung // 1);
    }
    my %rung = (read => 0, modify => 1, complete => 2, extend => 3);
    for my $chapter (glob 'chapters/ch*/README.md') {    # easiest first
        my ($folder, $last) = ($chapter =~ s/README\.md//r, 0);
        my $text = slurp($chapter);
        while ($text =~ /^\* [\d.]+ \[[^\]]*\]\((exercises\/[^)]*)\)(.*)/mg) {
            my ($page, $says) = ($1, $2);
            my ($kind, $minutes) = slurp("$folder$page") =~ /^\*\*Kind\.\*\* (\w+) · \*\*Time\.\*\* (\d+) minutes/m;
            push @found, "$chapter: $page is '$kind, $minutes minutes'" if index($says, ", $kind, $minutes minutes:") != 0;
            push @found, "$chapter: $page stands behind harder ones" if $rung{$kind} < $last;
            $last = $rung{$kind};
        }
    }
    for my $page (-f 'tests/exercises/wrong' ? glob 'chapters/ch*/exercises/ex*/README.md' : ()) {
        my ($chapter, $k) = $page =~ m{/ch0*(\d+)_.*/ex(\d+)_};
        push @found, "tests/exercises/wrong has no mistake of exercise $chapter.$k" if slurp('tests/exercises/wrong') !~ /^ex$chapter\.$k /m;
    }
    my $citation = slurp('CITATION.cff');
    my ($version) = slurp('CMakeLists.txt') =~ /project\(signorini VERSION ([\d.]+)/;
    push @found, "CITATION.cff has not the version $version" if $citation !~ /^version: \Q$version\E$/m;
    push @found, "CHANGELOG.md does not tell of $version"    if slurp('CHANGELOG.md') !~ /^## .*\Q$version\E/m;
    for my $key (qw(cff-version message title authors references)) { push @found, "CITATION.cff has no $key" if $citation !~ /^$key:/m }
    my ($two) = slurp('README.md') =~ /^## Two commands\n.*?^```sh\n(.*?)^```/ms;
    my $wanted = join '; ', map { s/\s+#.*//r } grep { /^\.\// } split /\n/, $two // '';
    my @step = map { /^([A-Z]+) (.+)$/ ? [$1, $2] : () } grep { !/^#/ } split /\n/, slurp('Containerfile');
    my $runs = join '; ', map { $_->[1] } grep { $_->[0] eq 'RUN' } @step;
    push @found, "Containerfile runs '$runs', README.md says '$wanted'" if $runs ne $wanted || $wanted eq '';
    push @found, "Containerfile: the order is FROM WORKDIR COPY RUN RUN ENTRYPOINT CMD" if "@{[map { $_->[0] } @step]}" ne 'FROM WORKDIR COPY RUN RUN ENTRYPOINT CMD';
    push @found, 'Containerfile: no image of Debian, slim' if slurp('Containerfile') !~ m{^FROM docker\.io/library/debian:\d+-slim$}m;
    my ($program) = slurp('Containerfile') =~ /^ENTRYPOINT \["([^"]+)"\]$/m;
    push @found, "Containerfile ends with $program, README.md with another program" if index(slurp('README.md'), "\n$program ") < 0;
    return @found;
}

my @found = check();
print "$_\n" for @found;
my $failures = @found;

sub fault {    # file, what is replaced, by what, part of the complaint
    my ($file, $old, $new, $complaint) = @_;
    my $kept = slurp($file);
    ($text{$file} = $kept) =~ s/$old/$new/ or do { print "named.pl: '$old' is not in $file\n"; $failures++ };
    my @now = check();
    if (!grep { index($_, $complaint) >= 0 } @now) { print "named.pl: nobody misses: $complaint\n"; $failures++ }
    $text{$file} = $kept;
}
fault('CONTRIBUTING.md', qr/make conformance/, 'make conformity', 'no target conformity');
fault('CONTRIBUTING.md', qr{tools/weave\.pl}, 'tools/weaver.pl', 'no file tools/weaver.pl');
fault('CONTRIBUTING.md', qr{setup\.sh parallel}, 'setup.sh serial', 'no group serial');
fault('CONTRIBUTING.md', qr/SIGNORINI_EFFECTS/, 'EFFECTS', 'no table EFFECTS');
fault('CONTRIBUTING.md', qr/^\| solver .*\n/m, '', 'no row for the family of src/papers/solver_table.cpp');
fault('CHANGELOG.md', qr/signorini plan/, 'signorini plot', 'no command plot');
fault('chapters/README.md', qr/--accuracy/, '--exactness', 'no option --exactness');
fault('chapters/README.md', qr/make ex10\.2/, 'make ex10.9', 'no target ex10.9');
fault('README.md', qr/make ch06/, 'make ch60', 'no target ch60');
fault('docs/commands.md', qr/setup\.sh build/, 'setup.sh bild', 'no group bild');
fault('docs/program.md', qr/signorini plan/, 'signorini pan', 'no command pan');
fault('docs/instructor.md', qr/^\| 4\.2 \| \w+/m, '| 4.2 | sleep', 'its kind is complete') if -f 'docs/instructor.md';
fault('chapters/ch08_complementarity/README.md', qr/read, 45 minutes:/, 'read, 5 minutes:', "is 'read, 45 minutes'");
fault('chapters/ch08_complementarity/exercises/ex3_reading_residuals/README.md', qr/Kind\.\*\* read/, 'Kind.** extend', 'stands behind harder ones');
fault('CITATION.cff', qr/^version: .*/m, 'version: 9.9.9', 'has not the version');
fault('Containerfile', qr/^RUN .*test$/m, 'RUN make test', 'Containerfile runs');
fault('Containerfile', qr/^RUN/m, 'run', 'Containerfile: the order');
fault('README.md', qr{^\./run\.sh test}m, './run.sh all', 'Containerfile runs');
exit($failures ? 1 : 0);
