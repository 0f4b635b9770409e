# SPDX-License-Identifier: Apache-2.0
# Rules mutation_lines and ablation_lines (rules.sh): every line of the list matches a name and changes its file; there are not too many.
# Reads the names, those of tests, from standard input. One sed for each file, not for each line: processes cost most of the time.
# usage: mutation_lines.pl LIST MOST
use strict;
use warnings;

my ($list, $most) = @ARGV;
my $names = do { local $/; <STDIN> } // '';
my (%of_file, @lines);
open(my $in, '<', $list) or die "$list: $!";
while (<$in>) {
  chomp;
  next if /^#/ || /^\s*$/;
  my ($test, $file, $expression) = split /\t/;
  push @lines, $.;
  print "$list:$.: '$test' matches no test\n" unless eval { $names =~ /$test/m };
  if (-f $file) { push @{$of_file{$file}}, [$., $expression] } else { print "$list:$.: no file $file\n" }
}
print "$list: ", scalar(@lines), " lines, $most at most: what is no error of physics is left to scripts/tests/random_mutations.py\n" if @lines > $most;

# Each line of the file is kept, changed by each expression in turn and, if that made it another, answered by the expression's line.
for my $file (sort keys %of_file) {
  my $script = join '', map { "h\n$_->[1]\nG\n/^\\(.*\\)\\n\\1\$/!{\ns/.*/$_->[0]/p\n}\ng\n" } @{$of_file{$file}};
  open(my $sed, '-|', 'sed', '-n', '-e', $script, $file) or die "sed: $!";
  my %changes = map { chomp; ($_ => 1) } <$sed>;
  close $sed;
  $changes{$_->[0]} or print "$list:$_->[0]: '$_->[1]' changes nothing in $file\n" for @{$of_file{$file}};
}
