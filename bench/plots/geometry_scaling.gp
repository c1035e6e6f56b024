# SPDX-License-Identifier: GPL-3.0-or-later
# Time of every stage, all sweeps together, and of whole solids, against the triangles made.
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" bench/plots/geometry_scaling.gp
set datafile separator ","
set terminal svg size 800,520 font "sans,13" background "white"
set logscale xy
set grid
set format xy "10^{%T}"
set key outside right top
set xlabel "triangles"
set ylabel "time (ms)"
file = data."/geometry_times.csv"

set output pictures."/geometry_scaling.svg"
stages = "'drawing and fillets' union triangles wrapping writing reading audit"
set xrange [1e3:*]
set yrange [1e-2:*]
plot for [i = 1:7] file using 3:(column(4 + i)) skip 1 with points pt 7 ps 0.6 title word(stages, i), \
     x * 1e-3 with lines lc "gray" dt 2 title "1 microsecond a triangle"

set output pictures."/solid_scaling.svg"
set xrange [*:*]
set yrange [*:*]
of(name, column) = strcol(1) eq name ? column : NaN
plot for [name in '"lattice by segments" "lattice mold by length" "lattice mold by 1/tolerance" "liner mold by length" "liner mold by 1/tolerance"'] \
       data."/solid_times.csv" using 3:(of(name, $5)) skip 1 with linespoints pt 7 ps 0.7 lw 1.5 \
       title name
