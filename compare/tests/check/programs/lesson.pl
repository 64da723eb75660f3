#!/usr/bin/perl
# A mapper for the lesson as a student might write it, with Perl's own sin, cos, exp and log.
# usage: lesson.pl [--bug NAME] [--noise-free | --seed N] --out DIR SCENARIO
use strict;
use warnings;
use POSIX qw(floor);

my ($bug, $seed, $out, $file) = ('', undef, undef, undef);
while (@ARGV) {
    my $word = shift @ARGV;
    if    ($word eq '--bug')        { $bug = shift @ARGV }
    elsif ($word eq '--noise-free') { $seed = undef }
    elsif ($word eq '--seed')       { $seed = shift @ARGV }
    elsif ($word eq '--out')        { $out = shift @ARGV }
    else                            { $file = $word }
}

my $pi = 3.141592653589793;
my %p = (
    p0 => 0.5, p_occ => 0.75, p_free => 0.3, l_min => -8, l_max => 8,
    no_return => 'free', fov => $pi, beams => 181, noise_std => 0.02, min_range => 0,
);
my (@walls, @scans);
open(my $in, '<', $file) or die "cannot open $file: $!\n";
sub fail { die "$file:$.: $_[0]\n" }
sub number {
    my $text = shift;
    fail("not a number") if $text !~ /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i && $text !~ /^[+-]?(?:nan|inf|infinity)$/i;
    return $text;
}
my %required = map { $_ => 1 } qw(width height resolution origin_x origin_y max_range);
sub start { for my $name (keys %required) { fail("occgrid_$name is missing") if !defined $p{$name} } }
while (my $line = <$in>) {
    my @f = split ' ', $line;
    next if !@f || $f[0] =~ /^#/;
    if ($f[0] =~ /^(PARAM|WALL|POSE)$/) {
        for my $i (0 .. $#f) { if ($f[$i] =~ /^#/) { splice @f, $i; last } }
    }
    start() if $f[0] =~ /^(POSE|FLASER|ROBOTLASER1)$/;
    if ($f[0] eq 'PARAM' && @f > 1 && $f[1] =~ /^occgrid_(\w+)$/) {
        fail("PARAM must stand before the first scan") if @scans;
        fail("PARAM takes 2 values") if @f != 3;
        $p{$1} = $1 eq 'no_return' ? $f[2] : number($f[2]);
        fail("not between 0 and 1") if $1 =~ /^p/ && ($f[2] <= 0 || $f[2] >= 1);
    }
    elsif ($f[0] eq 'WALL') { push @walls, [map { number($_) } @f[1 .. 4]] }
    elsif ($f[0] eq 'POSE') {
        fail("POSE takes 3 values") if @f != 4;
        number($_) for @f[1 .. 3];
        push @scans, { pose => [@f[1 .. 3]] };
    }
    elsif ($f[0] eq 'FLASER') {
        my $n = $f[1];
        for my $range (@f[2 .. $n + 1]) { fail("a range is negative") if number($range) !~ /nan/i && $range < 0 }
        my %parts = (180 => 180, 181 => 180, 360 => 360, 361 => 360, 400 => 720, 401 => 720);
        my $step = $n == 1 ? 0 : $pi / ($parts{$n} || $n - 1);
        push @scans, {
            pose => [@f[$n + 2 .. $n + 4]], ranges => [@f[2 .. $n + 1]],
            angles => [map { -($pi / 2) + $_ * $step } 0 .. $n - 1],
        };
    }
    elsif ($f[0] eq 'ROBOTLASER1') {
        my $n = $f[8];
        my $m = $f[9 + $n];
        push @scans, {
            pose => [@f[10 + $n + $m .. 12 + $n + $m]], ranges => [@f[9 .. 8 + $n]],
            angles => [map { $f[2] + $_ * $f[4] } 0 .. $n - 1],
        };
    }
}
close $in;

my ($w, $h, $res, $ox, $oy, $zmax) = @p{qw(width height resolution origin_x origin_y max_range)};
sub logit { my $q = shift; $q = 1e-9 if $q < 1e-9; $q = 1 - 1e-9 if $q > 1 - 1e-9; return log($q / (1 - $q)) }
my $l0 = logit($p{p0});
my $occ = logit($p{p_occ}) - $l0;
my $free = logit($p{p_free}) - $l0;
my @grid = ($l0) x ($w * $h);

sub words32 {    # Philox4x32-10
    my ($c0, $c1, $c2, $c3, $k0, $k1) = @_;
    for my $round (0 .. 9) {
        my ($a, $b) = (0xD2511F53 * $c0, 0xCD9E8D57 * $c2);
        { use integer; $a = 0xD2511F53 * $c0; $b = 0xCD9E8D57 * $c2; }
        ($c0, $c1, $c2, $c3) =
            ((($b >> 32) & 0xFFFFFFFF) ^ $c1 ^ $k0, $b & 0xFFFFFFFF, (($a >> 32) & 0xFFFFFFFF) ^ $c3 ^ $k1, $a & 0xFFFFFFFF);
        $k0 = ($k0 + 0x9E3779B9) & 0xFFFFFFFF;
        $k1 = ($k1 + 0xBB67AE85) & 0xFFFFFFFF;
    }
    return ($c0, $c1);
}

sub deviate {
    my ($scan, $beam) = @_;
    $beam++ if $bug eq 'noise';
    my ($w0, $w1) = words32($scan, $beam, 0, 0, $seed, 0);
    return sqrt(-2 * log(($w0 + 0.5) / 4294967296)) * cos(2 * $pi * (($w1 + 0.5) / 4294967296));
}

sub simulate {
    my ($x, $y, $a) = @_;
    my ($dx, $dy) = (cos($a), sin($a));
    my $best = $zmax;
    for my $wall (@walls) {
        my ($x0, $y0, $x1, $y1) = @$wall;
        my ($sx, $sy) = ($x1 - $x0, $y1 - $y0);
        my $rxs = $dx * $sy - $dy * $sx;
        next if abs($rxs) < 1e-12;
        my ($qx, $qy) = ($x0 - $x, $y0 - $y);
        my $t = ($qx * $sy - $qy * $sx) / $rxs;
        my $u = ($qx * $dy - $qy * $dx) / $rxs;
        $best = $t if $t >= 0 && $u >= 0 && $u <= 1 && $t < $best;
    }
    return $best;
}

sub cell { my $v = shift; return $bug eq 'truncation' ? int($v) : floor($v) }

sub update {
    my ($gx, $gy, $step) = @_;
    return if $gx < 0 || $gx >= $w || $gy < 0 || $gy >= $h;
    my $l = $grid[$gy * $w + $gx] + $step;
    if ($bug ne 'clamp') {
        $l = $p{l_max} if $l > $p{l_max};
        $l = $p{l_min} if $l < $p{l_min};
    }
    $grid[$gy * $w + $gx] = $l;
}

for my $s (0 .. $#scans) {
    my $scan = $scans[$s];
    my ($x, $y, $theta) = map { $_ + 0 } @{ $scan->{pose} };
    my $n = $scan->{ranges} ? @{ $scan->{ranges} } : $p{beams};
    my ($gx0, $gy0) = (cell(($x - $ox) / $res), cell(($y - $oy) / $res));
    for my $i (0 .. $n - 1) {
        my $angle = $scan->{angles} ? $scan->{angles}[$i] : $n == 1 ? 0 : -($p{fov} / 2) + ($p{fov} * $i) / ($n - 1);
        my $a = $theta + $angle;
        $a = $angle if $bug eq 'heading';
        my $z;
        if ($scan->{ranges}) {
            next if $scan->{ranges}[$i] =~ /nan/i;
            $z = $scan->{ranges}[$i] =~ /inf/i ? 9**9**9 : $scan->{ranges}[$i] + 0;
            next if $z < $p{min_range};
        }
        else {
            $z = simulate($x, $y, $a);
            if (defined $seed) {
                $z += $p{noise_std} * deviate($s, $i);
                $z = 0 if $z < 0;
                $z = $zmax if $z > $zmax;
            }
        }
        my $hit = $z < $zmax - 1e-12;
        next if !$hit && $p{no_return} eq 'ignore';
        $z = $zmax if !$hit;
        my $last = $hit || $bug eq 'maxrange';
        my ($gx1, $gy1) = (cell(($x + $z * cos($a) - $ox) / $res), cell(($y + $z * sin($a) - $oy) / $res));
        my ($dx, $dy) = (abs($gx1 - $gx0), abs($gy1 - $gy0));
        my ($sx, $sy) = ($gx0 < $gx1 ? 1 : -1, $gy0 < $gy1 ? 1 : -1);
        my ($err, $gx, $gy) = ($dx - $dy, $gx0, $gy0);
        while (1) {
            my $end = $gx == $gx1 && $gy == $gy1;
            update($gx, $gy, $free) if $end && $last && $bug eq 'alsofree';
            update($gx, $gy, $end && $last ? $occ : $free);
            last if $end;
            my $e2 = 2 * $err;
            if ($e2 > -$dy) { $err -= $dy; $gx += $sx }
            if ($bug eq 'ties' ? $e2 <= $dx : $e2 < $dx) { $err += $dx; $gy += $sy }
        }
    }
}

(my $name = $file) =~ s{.*/}{};
$name =~ s/\.[^.]*$//;
open(my $pgm, '>', "$out/$name.pgm") or die "cannot write $out/$name.pgm: $!\n";
print $pgm "P2\n$w $h\n255\n";
my @rows = $bug eq 'flipped' ? (0 .. $h - 1) : reverse(0 .. $h - 1);
for my $gy (@rows) {
    my @pixels = map {
        my $l = $grid[$gy * $w + $_];
        my $prob = $l >= 0 ? 1 / (1 + exp(-$l)) : exp($l) / (1 + exp($l));
        floor((1 - $prob) * 255 + 0.5)
    } 0 .. $w - 1;
    print $pgm join(' ', @pixels), "\n";
}
close $pgm;
