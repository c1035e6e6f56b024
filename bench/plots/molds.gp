# SPDX-License-Identifier: GPL-3.0-or-later
# Stated distance of a mold's worst piece from its true surface, against the time for all pieces.
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" bench/plots/molds.gp
set datafile separator ","
set terminal svg size 800,520 font "sans,13" background "white"
set logscale xy
set grid
set format y "10^{%T}"
set key top right
of(name, column) = strcol(1) eq name ? column : NaN

set output pictures."/mold_error.svg"
set xlabel "time for all pieces (ms)"
set ylabel "stated distance from the true surface (mm)"
plot for [name in '"lattice mold" "horseshoe mold" "liner mold"'] \
       data."/mold_error.csv" using 7:(of(name, $4)) skip 1 with linespoints pt 7 ps 0.7 lw 1.5 \
       title name
