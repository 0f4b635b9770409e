# SPDX-License-Identifier: Apache-2.0
# Rule table_heads (rules.sh), run in the tree: what docs/charts, docs/figures and docs/gallery hold says what it was made on and by, and LIST says from
# which files. usage: table_heads.pl LIST
use strict;
use warnings;

my ($list) = @ARGV;
my @made = grep { -f && !m{/README\.md$} } glob('docs/charts/* docs/figures/* docs/gallery/*');

for my $file (grep { /\.csv$/ } @made) {
  open(my $in, '<', $file) or die "$file: $!";
  my $head = '';
  while (<$in>) {
    s/^# gasjet [^ ]+ \(([0-9a-f]+[^,]*), ([^,]+), ([^)]+)\)$/# commit: $1\n# compiler: $2\n# flags: $3/;
    $head .= $_;
    last unless /^#/;
  }
  for my $part (qw(machine commit compiler flags)) {
    $head =~ /^# $part: ./m or print "$file:1: the lines above the columns do not name its $part (docs/make/charts/common.sh)\n";
  }
  print "$file:1: made by a build of changed sources, of which no commit tells\n" if $head =~ /-dirty/;
}

open(my $in, '<', $list) or die "$list: $!";
chomp(my @lines = <$in>);
my %named = map { ((split /\t/, $_)[0] // '') => 1 } @lines;
for my $file (@made) {
  $named{$file} or print "$list: no line for $file: add the file, the script that makes it and the code that it depends on (tabs between)\n";
}
for (@lines) {
  my ($file, $script, $paths) = split /\t/, $_, 3;
  next if !defined $file || $file eq '' || $file =~ /^#/;
  $script //= '';
  print "$list: $file by '$script': no such files\n" unless $file =~ /^@/ || (-f $file && -f $script);
  my @paths = split ' ', $paths // '';
  print "$list: $file depends on nothing\n" unless @paths;
  for my $path (@paths) {
    my $there = $path =~ /^@/ ? $named{$path} : $path =~ /^:\(/ || grep { -e } glob $path;
    print "$list: $file depends on $path: no such file or line\n" unless $there;
  }
}
