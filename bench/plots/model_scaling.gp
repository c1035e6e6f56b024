# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" model_scaling.gp: time of prediction against size.
set terminal svg size 800,520 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set key below font ",11" spacing 0.95
set bmargin 8
set colorsequence podo
set xlabel offset 0,0.3 "how many"
set ylabel "processor time, s"
set title "Time of prediction as a design grows"
table = data."/model_scaling.csv"
seconds(stage) = strcol(1) eq stage ? $3 : NaN
stages = "'straight strands of two widths' 'horseshoe strands of two widths' 'strands of a nearly even family (prepared only)' 'families' 'distinct horseshoe laws' 'pressures' 'segments' 'segments with columns of their own' 'load cases (tips included)'"
names = "'straight strands' 'horseshoe strands' 'nearly even strands, prepared' 'families' 'horseshoe laws' 'pressures' 'like segments' 'unlike segments' 'load cases'"
set output pictures."/model_scaling.svg"
plot for [i=1:words(stages)] table using 2:(seconds(word(stages, i))) with linespoints lw 1.5 pt 4+i ps 0.7 title word(names, i), \
     x*1e-5 with lines dt 2 lc rgb "black" title "in proportion"
