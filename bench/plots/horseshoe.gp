# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" horseshoe.gp: error of a horseshoe's force against time.
set terminal svg size 800,520 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set key below font ",11" spacing 0.95
set bmargin 8
set colorsequence podo
set xlabel offset 0,0.3 "processor time, s"
set ylabel "relative error of the force"
set yrange [1e-17:1]
table = data."/horseshoe.csv"
error(which, method) = strcol(1) eq which && strcol(5) eq method && strlen(strcol(7)) > 0 ? \
                       ($7 > 2e-17 ? $7 : 2e-17) : NaN
# Where a method fails, a cross at the top.
failed(which) = strcol(1) eq which && strcol(9) ne "solved" ? 0.5 : NaN
methods = "'collocation' 'shooting from the end' 'shooting from the middle' 'first integral' 'interpolant'"

which = "170° w/R 0.571: 0.9 of full"
set title "Horseshoe of 170°, w/R 0.571, at 0.9 of its full extension"
set output pictures."/horseshoe.svg"
plot for [i=1:5] table using 8:(error(which, word(methods, i))) with linespoints lw 1.5 pt 4+i ps 0.9 title word(methods, i), \
     table using 8:(failed(which)) with points pt 2 lc rgb "#888888" title "not solved"

which = "180° w/R 0.01: full extension"
set title "Slender horseshoe of 180°, w/R 0.01, at full extension"
set output pictures."/horseshoe_slender.svg"
replot
