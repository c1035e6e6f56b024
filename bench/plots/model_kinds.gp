# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='FOLDER'; pictures='FOLDER'" model_kinds.gp: mean error of each kind of model
# against time.
set terminal svg size 800,520 font "sans,13" background "white"
set datafile separator ","
set logscale xy
set grid lc rgb "#dddddd"
set key below font ",11" spacing 0.95
set bmargin 6
set colorsequence podo
set xlabel "processor time of 6 pressures, set-up included, ms"
set ylabel "mean error, %"
set xrange [0.05:5000]
set yrange [0.1:40]
set title "Twisting lattices of 36 and 60 degrees, 10 to 60 kPa"
table = data."/model_kinds.csv"
set output pictures."/model_kinds.svg"
plot table every ::1 using ($6+$7):2 with linespoints lw 1.5 pt 7 ps 0.8 title "stretch - 1", \
     table every ::1 using ($6+$7):4 with linespoints lw 1.5 pt 5 ps 0.8 title "twist", \
     table every ::1 using ($6+$7):2:1 with labels font ",10" offset 0,1.2 notitle
