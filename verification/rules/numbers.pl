# SPDX-License-Identifier: Apache-2.0
# Rule numbers (rules.sh), run in the tree: the pages say the numbers that LIST names. Reads what their sources say from standard input, a
# line for each line of LIST. usage: numbers.pl LIST MOST
use strict;
use warnings;

my ($list, $most) = @ARGV;
my ($numbers, %lines_of) = (0);

sub lines_of {
  my ($page) = @_;
  if (!$lines_of{$page}) {
    open(my $in, '<', $page) or die "$page: $!";
    $lines_of{$page} = [<$in>];
  }
  return @{$lines_of{$page}};
}

open(my $in, '<', $list) or die "$list: $!";
while (<$in>) {
  chomp;
  chomp(my $number = <STDIN> // '');
  ++$numbers if /^[^#]/;
  next if $_ eq '' || /^#/;
  my ($page, $pattern, $source, $row, $column, $scale, $format) = split /\t/;
  if (!defined $format || !-f $page || !-f $source) {
    print "$list:$.: $page, ", $source // '', ": seven columns and two files of the tree are needed\n";
    next;
  }
  my $says = join "\n", map { /.*$pattern/ ? $1 : () } lines_of($page);
  print "$page: '$pattern' says '$says', $source ($row, $column): $number\n" unless $says eq $number;
}
print "$list: $numbers numbers in sentences, allowed are $most: let a table say them (docs/tables.tsv)\n" if $numbers > $most;
