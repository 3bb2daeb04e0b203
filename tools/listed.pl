# listed.pl: what words.pl and equations.pl share, which each write one list from marks that stand in the sources.
use strict;
use warnings;
use utf8;

# The text of a file.
sub slurp {
    my ($file) = @_;
    open my $in, '<:utf8', $file or die "$file: $!\n";
    local $/;
    return <$in>;
}

# Writes the list to its file, or with $check only complains if the file says otherwise; ends with 1 after any complaint.
sub list_and_exit {
    my ($tool, $file, $list, $check, $source, @complaints) = @_;
    my $old = -e $file ? slurp($file) : '';
    if ($check) {
        push @complaints, "$file is not what the $source say: type make text" if $old ne $list;
    } elsif ($old ne $list) {
        open my $write, '>:utf8', $file or die "$tool: $file: $!\n";
        print $write $list;
        close $write or die "$tool: $file: $!\n";
        print "wrote $file\n";
    }
    print STDERR "$tool: $_\n" for @complaints;
    exit(@complaints ? 1 : 0);
}

1;
