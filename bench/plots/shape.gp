# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" shape.gp: error of a tip against time.
set terminal svg size 800,520 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set key below font ",11" spacing 0.95
set bmargin 8
set colorsequence podo
set xlabel offset 0,0.3 "processor time, s"
set ylabel "distance of the tip from its true place, mm"
set yrange [1e-16:1e3]
set title "Tip of a superimposed helix of 400 mm"
table = data."/shape.csv"
error(method) = strcol(1) eq "superimposed helix (400 mm at 40 kPa)" && strcol(2) eq method ? \
                ($4 > 2e-16 ? $4 : 2e-16) : NaN
methods = "'explicit Euler' 'midpoint' 'exponential midpoint' 'Runge-Kutta 4' 'CVODE' 'closed form'"
set output pictures."/shape.svg"
plot for [i=1:6] table using 5:(error(word(methods, i))) with linespoints lw 1.5 pt 4+i ps 0.7 title word(methods, i)
