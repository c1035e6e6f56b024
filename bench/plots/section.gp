# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" section.gp: error of an equilibrium against time.
set terminal svg size 800,520 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set key below font ",11" spacing 0.95 samplen 2.5
set bmargin 8
set colorsequence podo
set xlabel offset 0,0.3 "processor time of one state, µs"
set ylabel "error over the largest scaled coordinate"
set yrange [1e-17:1]
set title "Equilibrium of a section"
table = data."/section.csv"
error(which, method) = strcol(1) eq which && strcol(2) eq method ? \
                       ($4 > 2e-17 ? $4 : 2e-17) : NaN
cases = "'twisting 36° at 40 kPa' 'bending 2:3.5 at 30 kPa' 'superimposed irregular at 30 kPa'"
names = "twisting bending superimposed"
methods = "'quadrature points' 'error goal' 'Newton tolerance'"
short = "'quadrature' 'error goal' 'Newton'"
set output pictures."/section.svg"
plot for [m=1:3] for [c=1:3] table using ($6*1e6):(error(word(cases, c), word(methods, m))) \
     with linespoints lw 1.5 dt m lc c pt 4+m ps 0.7 title word(names, c).": ".word(short, m)
