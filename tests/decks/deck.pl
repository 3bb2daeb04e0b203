#!/usr/bin/env perl
# deck.pl PROGRAM DECKS FOLDER NAME: solves the scene DECKS/NAME.toml with PROGRAM, the command `signorini`, in FOLDER, and compares it with DECKS/references.
# deck.pl PROGRAM DECKS FOLDER --update: does so with all of them and writes the table of DECKS/README.md anew, and what DECKS/needs.csv counts.
# deck.pl PROGRAM DECKS FOLDER --check: no scene, mesh or row of that table is without its deck, and the counts are those.
#
# A row of DECKS/references is `quantity | reference | where the reference stands`, with a fourth part if it has a tolerance of its own, or `differs: why`.
# A quantity is `WHAT of WHOM`, and behind that, where it has a meaning, ` at PLACE`, ` time T`, ` over W`, by which ours is divided, and ` grown BODY x,y x,y`: ours is multiplied
# by the area that the straight side between these two nodes has after loading, over the area before. WHAT is:
#   u_x u_y of BODY at x,y                     displacement of the node that was there before loading; ` turned A`: in a scene that is turned back by A degrees
#   s_xx s_yy s_xy of BODY at x,y              stress there
#   R_x R_y of BODY                            what its supports bear
#   F_x F_y peak normal_force closed of SOURCE sums of the contact of that source
#   pressure force gap slip slip_total shear_force shear_traction of SOURCE at x or x,y    a column of the nearest pair, where it stands now
#   least_pressure largest_pressure of SOURCE  of a tie
#   pressing of SOURCE                         how many of its pairs press
#   rms of BODY                                root of the mean square of all components of displacement of its nodes
use strict;
use warnings;
use File::Basename;
use File::Path qw(make_path remove_tree);
use lib dirname(__FILE__) . '/../docs';
use Json;

my ($program, $decks, $folder, $asked) = @ARGV;
die "deck.pl PROGRAM DECKS FOLDER NAME\n" if !defined $asked;
my %column = map { $_ => 1 } qw(pressure force gap slip slip_total shear_force shear_traction);
my %sum = (F_x => ['force', 0], F_y => ['force', 1], peak => ['peak_pressure'], normal_force => ['normal_force'], closed => ['closed']);
my %field = (u_x => ['displacement', 0], u_y => ['displacement', 1], s_xx => ['stress', 0], s_yy => ['stress', 1], s_xy => ['stress', 2]);

sub slurp { my ($file) = @_; open my $in, '<', $file or die "deck.pl: $file: $!\n"; local $/; return scalar <$in> }
sub words { return grep { length } split ' ', $_[0] }

sub references {    # name -> what the file says of that deck, and the order of the names
    my (%deck, @order, $name);
    for (split /\n/, slurp("$decks/references")) {
        next if /^\s*(#|$)/;
        if (/^\[(\w+)\]$/) { $name = $1; push @order, $name; $deck{$name} = { rows => [] }; next }
        die "deck.pl: references: no deck before '$_'\n" if !defined $name;
        if (/^(project|source|shows|tolerance)\s*=\s*(\S.*)$/) { $deck{$name}{$1} = $2; next }
        my @part = split /\s*\|\s*/;
        die "deck.pl: references: $name: expected quantity | reference | where, got '$_'\n" if @part < 3;
        push @{ $deck{$name}{rows} }, { asked => $part[0], reference => $part[1], where => $part[2], map { /^differs: (.*)/ ? (differs => $1) : (tolerance => $_) } @part[3 .. $#part] };
    }
    for (@order) { die "deck.pl: references: $_ lacks project, source, shows, tolerance or rows\n" if grep({ !defined } @{ $deck{$_} }{qw(project source shows tolerance)}) || !@{ $deck{$_}{rows} } }
    return (\%deck, \@order);
}

sub solved {    # the document of the program, the steps of it and their VTU files
    my ($name) = @_;
    make_path($folder);
    my $vtu = "$folder/$name.vtu";
    unlink glob("$folder/${name}*.vtu"), "$folder/$name.pvd";
    open my $run, '-|', $program, 'solve', "$decks/$name.toml", '--json', '--ascii', '--vtu', $vtu or die "deck.pl: $program: $!\n";
    my $said = do { local $/; <$run> };
    close $run;
    die "deck.pl: $name is not solved, exit code ", $? >> 8, "\n" if $?;
    my $read = Json::decode($said);
    my @steps = $read->{steps} ? @{ $read->{steps} } : ($read);
    my $axial = slurp("$decks/$name.toml") =~ /^[^#]*state = "axial symmetry"/m;
    for my $k (0 .. $#steps) { $steps[$k]{axial} = $axial; $steps[$k]{vtu} = $read->{steps} ? sprintf("$folder/%s_%04d.vtu", $name, $k + 1) : $vtu }
    return \@steps;
}

sub pieces {    # of a VTU file, a body each: name of an array -> its numbers
    my ($step) = @_;
    return $step->{pieces} if $step->{pieces};
    my ($text, %array) = slurp($step->{vtu});
    while ($text =~ m{<DataArray[^>]*Name="(displacement|stress|points|connectivity|offsets|body)"[^>]*>\s*(.*?)</DataArray>}gs) { $array{$1} = [words($2)] }
    my ($nodes, $begin, @body, @all) = (@{ $array{points} } / 3, 0);
    for my $cell (0 .. $#{ $array{offsets} }) {
        my $end = $array{offsets}[$cell];
        $body[$_] = $array{body} ? $array{body}[$cell] : 0 for @{ $array{connectivity} }[$begin .. $end - 1];
        $begin = $end;
    }
    for my $name (qw(displacement stress points)) {
        my $width = @{ $array{$name} } / $nodes;
        push @{ $all[$body[$_]]{$name} }, @{ $array{$name} }[$width * $_ .. $width * ($_ + 1) - 1] for 0 .. $nodes - 1;
    }
    return $step->{pieces} = \@all;
}

sub piece_of {    # a body
    my ($step, $body) = @_;
    my @names = map { $_->{name} } @{ $step->{bodies} };
    my ($k) = grep { $names[$_] eq $body } 0 .. $#names;
    die "no body '$body'; there are: @names\n" if !defined $k;
    return pieces($step)->[$k];
}

sub at_node {    # a component of a field of a body
    my ($step, $body, $place, $field, $component) = @_;
    my $piece = piece_of($step, $body);
    my ($x, $y) = split /,/, $place;
    my ($points, $nearest, $least) = ($piece->{points}, 0, 'inf');
    for my $i (0 .. @$points / 3 - 1) {
        my $square = ($points->[3 * $i] - $x)**2 + ($points->[3 * $i + 1] - $y)**2;
        ($nearest, $least) = ($i, $square) if $square < $least;
    }
    die sprintf("no node of '%s' at %s, the nearest is %g away\n", $body, $place, sqrt $least) if sqrt($least) > 1e-6 * (1 + abs($x) + abs($y));
    my $values = $piece->{$field};
    return $values->[@$values / (@$points / 3) * $nearest + $component];
}

sub pairs_of {    # numbers of the pairs of a source
    my ($step, $source) = @_;
    my $pairs = $step->{pairs};
    my @contacts = map { $_->{name} } @{ $step->{contacts} };
    my @mine = grep { !$pairs->{contact} || $pairs->{contact}[$_] =~ /^\Q$source\E on / } 0 .. $#{ $pairs->{x} };
    die "no pair of '$source'; contacts are: @contacts\n" if !@mine;
    return @mine;
}

sub of_pair {    # a column of the nearest pair of a source
    my ($step, $source, $place, $column) = @_;
    my $pairs = $step->{pairs};
    my @mine = pairs_of($step, $source);
    my ($x, $y) = split /,/, $place;
    my %away = map { $_ => ($pairs->{x}[$_] - $x)**2 + (defined $y ? ($pairs->{y}[$_] - $y)**2 : 0) } @mine;
    my ($nearest) = sort { $away{$a} <=> $away{$b} || $a <=> $b } @mine;
    die "no column '$column'\n" if !$pairs->{$column};
    return $pairs->{$column}[$nearest];
}

sub growth {    # area of the straight side between two nodes of a body after loading, over that before; of revolution where the scene is
    my ($step, $body, @ends) = @_;
    my (@before, @after);
    for (@ends) {
        my ($x, $y) = split /,/;
        push @before, [$x, $y];
        push @after, [$x + at_node($step, $body, $_, 'displacement', 0), $y + at_node($step, $body, $_, 'displacement', 1)];
    }
    my $area = sub {
        my ($p, $q) = @_;
        return sqrt(($q->[0] - $p->[0])**2 + ($q->[1] - $p->[1])**2) * ($step->{axial} ? abs($p->[0] + $q->[0]) : 1);
    };
    return $area->(@after) / $area->(@before);
}

sub root_mean_square {
    my ($u, $sum) = (piece_of(@_)->{displacement}, 0);
    $sum += $_**2 for @$u;    # the third component is 0
    return sqrt($sum / (2 * @$u / 3));
}

sub ours {
    my ($steps, $asked) = @_;
    my ($what, $whom, $place, $turned, $time, $over, $grown) = $asked =~ /^(\w+) of (\S+?)(?: at (\S+))?(?: turned (\S+))?(?: time (\S+))?(?: over (\S+))?(?: grown (\S+ \S+ \S+))?$/
        or die "'$asked': expected WHAT of WHOM at PLACE turned A time T over W grown BODY x,y x,y\n";
    my ($step) = defined $time ? grep({ abs($_->{time} - $time) < 1e-9 } @$steps) : $steps->[-1];
    die "no step at time $time\n" if !$step;
    my $value;
    if (defined $turned) {
        my ($x, $y) = map { at_node($step, $whom, $place, 'displacement', $_) } 0, 1;
        my $angle = $turned * atan2(1, 1) / 45;
        $value = $what eq 'u_x' ? $x * cos($angle) - $y * sin($angle) : $x * sin($angle) + $y * cos($angle);
    }
    elsif ($column{$what}) { $value = of_pair($step, $whom, $place // die("'$asked': where?\n"), $what) }
    elsif ($field{$what}) { $value = at_node($step, $whom, $place // die("'$asked': where?\n"), @{ $field{$what} }) }
    elsif ($sum{$what}) {
        my ($contact) = grep { $_->{name} =~ /^\Q$whom\E on / } @{ $step->{contacts} } or die "no contact of '$whom'\n";
        my ($key, $component) = @{ $sum{$what} };
        $value = defined $component ? $contact->{$key}[$component] : $contact->{$key};
    }
    elsif ($what =~ /^R_([xy])$/) {
        my ($body) = grep { $_->{name} eq $whom } @{ $step->{bodies} } or die "no body '$whom'\n";
        $value = $body->{supports}[$1 eq 'y'];
    }
    elsif ($what =~ /^(?:least|largest)_pressure$/) {
        my ($tie) = grep { $_->{name} =~ /^\Q$whom\E to / } @{ $step->{bonds} } or die "no tie of '$whom'\n";
        $value = $tie->{$what};
    }
    elsif ($what eq 'pressing') { $value = grep { $step->{pairs}{force}[$_] > 0 } pairs_of($step, $whom) }
    elsif ($what eq 'rms') { $value = root_mean_square($step, $whom) }
    die "'$asked': unknown quantity\n" if !defined $value;
    return $value / ($over // 1) * (defined $grown ? growth($step, split / /, $grown) : 1);
}

sub allowed { my ($tolerance, $reference) = @_; return $tolerance =~ /^(\S+) %$/ ? $1 / 100 * abs($reference) : $tolerance }

sub compared {    # rows with what is ours and how much of the tolerance it takes
    my ($name, $deck) = @_;
    my $steps = solved($name);
    my @rows = @{ $deck->{rows} };
    for (@rows) {
        $_->{ours} = eval { ours($steps, $_->{asked}) };
        die "deck.pl: $name: $@" if $@;
        $_->{part} = abs($_->{ours} - $_->{reference}) / allowed($_->{tolerance} // $deck->{tolerance}, $_->{reference});
    }
    return @rows;
}

sub weight { my ($row) = @_; return $row->{part} < 0.1 ? 0 : sprintf '%.1e', $row->{part} }    # rounding decides nothing

sub table_row {    # of README.md: the quantity that is worst within, the first of several, and how many there are
    my ($name, $deck, @rows) = @_;
    my ($worst) = sort { weight($b) <=> weight($a) } grep { !$_->{differs} } @rows;
    my @outside = grep { $_->{differs} } @rows;
    my $shown = $worst // $outside[0];
    my $agree = @rows - @outside;
    return sprintf("| [%s](%s.toml) | %s | %s | %s | %.6g | %.6g | %s | %d of %d |\n", $name, $name, $deck->{project}, $deck->{shows}, $shown->{asked}, $shown->{reference}, $shown->{ours},
        $shown->{tolerance} // $deck->{tolerance}, $agree, scalar @rows);
}

sub alike {    # two rows of the table: the same words, and numbers that differ in the last digits at most
    my @one = split /(?<=[ |])/, $_[0];
    my @two = split /(?<=[ |])/, $_[1];
    return 0 if @one != @two;
    for (0 .. $#one) {
        next if $one[$_] eq $two[$_];
        my ($p, $q) = map { /^(-?\d[\d.]*(?:e[-+]\d+)?) $/ ? $1 : return 0 } $one[$_], $two[$_];
        return 0 if abs($p - $q) > 2e-5 * abs($p);
    }
    return 1;
}

sub total {    # how many decks have no row that `differs`, of each project, and what these rest on
    my ($deck, $order) = @_;
    my (%all, %whole, $grown, $counts);
    for (map { $deck->{$_} } @$order) {
        ++$all{ $_->{project} };
        my @rows = @{ $_->{rows} };
        next if grep { $_->{differs} } @rows;
        ++$whole{ $_->{project} };
        ++$grown if grep { $_->{asked} =~ / grown / } @rows;
        ++$counts if !grep { $_->{asked} !~ /^pressing / } @rows;
    }
    my ($sum, $sum_of_all) = (0, 0);
    $sum += $_ for values %whole;
    $sum_of_all += $_ for values %all;
    return sprintf "%d of %d decks agree in every number: %s. In %d of these some are taken on the deformed area, and %d compare counts of nodes alone.\n", $sum, $sum_of_all,
        join(', ', map { sprintf '%s %d of %d', $_, $whole{$_} // 0, $all{$_} } sort { $all{$b} <=> $all{$a} || $a cmp $b } keys %all), $grown, $counts;
}

sub counted {    # of needs.csv: a line for each deck, in quotes where it has commas
    my ($deck) = @_;
    my ($all, $small, $moving, $unsure, $here, %missing) = (0, 0, 0, 0, 0);
    for my $line (split /\n/, slurp("$decks/needs.csv")) {
        my ($name, undef, undef, @cells) = map { s/^"|"$//gr } $line =~ /("[^"]*"|[^,]*)(?:,|$)/g;
        next if $name eq 'deck';
        my ($at_rest, $if_bodies_move, $missing, undef, $scenes) = @cells;
        die "needs.csv: $name: small and moving are yes, no or unsure\n" if grep { !/^(yes|no|unsure)$/ } $at_rest, $if_bodies_move;
        die "needs.csv: $name: what cannot be written, and nothing else, misses something\n" if ($if_bodies_move eq 'no') != ($missing ne '');
        for (split ' ', $scenes // '') { die "needs.csv: $name: no scene '$_', or the deck cannot be written\n" if !$deck->{$_} || $if_bodies_move ne 'yes' }
        ++$all;
        ++$small if $at_rest eq 'yes';
        ++$moving if $if_bodies_move eq 'yes';
        ++$unsure if $if_bodies_move eq 'unsure';
        ++$here if $scenes;
        ++$missing{$_} for split /;/, $missing;
    }
    my @most = sort { $missing{$b} <=> $missing{$a} || $a cmp $b } keys %missing;
    return sprintf "Of %d decks, %d can be written at small sliding and small strain, %d if bodies move, and of %d we are not sure; %d are here. The others need %s.\n", $all, $small,
        $moving, $unsure, $here, join(', ', map { "$_ ($missing{$_})" } @most);
}

my ($deck, $order) = references();
my $readme = "$decks/README.md";
if ($asked eq '--update') {
    my $table = "| deck | project | what it shows | worst within the tolerance | reference | ours | tolerance | agree |\n|:--|:--|:--|:--|--:|--:|--:|--:|\n";
    $table .= table_row($_, $deck->{$_}, compared($_, $deck->{$_})) for @$order;
    my $text = slurp($readme);
    $text =~ s/(<!-- decks -->\n\n).*?(\n<!-- \/decks -->)/$1@{[total($deck, $order)]}\n$table$2/s or die "deck.pl: $readme: no <!-- decks -->\n";
    $text =~ s/(<!-- needs -->\n\n).*?(\n<!-- \/needs -->)/$1@{[counted($deck)]}$2/s or die "deck.pl: $readme: no <!-- needs -->\n";
    open my $out, '>', $readme or die "deck.pl: $readme: $!\n";
    print $out $text;
    close $out or die "deck.pl: $readme: $!\n";
    exit 0;
}
if ($asked eq '--check') {
    my %used = map { $_ => 1 } map { ("$_.toml", slurp("$decks/$_.toml") =~ /file = "([^"]+)"/g) } @$order;
    my @idle = grep { !$used{$_} } map { basename($_) } glob("$decks/*.toml $decks/*.msh");
    my @told = slurp($readme) =~ /^\| \[(\w+)\]\(/mg;
    print "no deck of references needs $_\n" for @idle;
    print "the table of README.md has other decks than references, or in another order: run --update\n" if "@told" ne "@$order";
    my @unsaid = grep { index(slurp($readme), $_) < 0 } total($deck, $order), counted($deck);
    print "README.md should say: $_" for @unsaid;
    exit(@idle || "@told" ne "@$order" || @unsaid ? 1 : 0);
}
die "deck.pl: no deck '$asked' in references\n" if !$deck->{$asked};
my @rows = compared($asked, $deck->{$asked});
my $failures = 0;
for (@rows) {
    my $good = $_->{differs} ? $_->{part} > 1 : $_->{part} <= 1;
    printf "%s %s: reference %s (%s), ours %.9g, %.3g of the tolerance %s%s\n", $good ? 'ok  ' : 'FAIL', $_->{asked}, $_->{reference}, $_->{where}, $_->{ours}, $_->{part},
        $_->{tolerance} // $deck->{$asked}{tolerance}, $_->{differs} ? ", differs: $_->{differs}" : '';
    ++$failures if !$good;
}
my $row = table_row($asked, $deck->{$asked}, @rows);
my ($told) = slurp($readme) =~ /^(\| \[\Q$asked\E\]\(.*\n)/m;
if (!defined $told || !alike($told, $row)) { print "FAIL README.md says\n", $told // "nothing\n", "and should say\n$row"; ++$failures }
exit($failures ? 1 : 0);
