# Figure 6.5 - the printed method on the cantilever, step by step.   In: fig_6_5_*.csv   Out: fig_6_5.svg
width = 480; height = 560
load 'style.gp'
set multiplot
set lmargin at screen 0.13
set rmargin at screen 0.97
set xrange [10:51]
set xtics 10
set ytics 1 format 'k = %g'
unset grid
RING = "with points pt 6 ps 0.75 lw 1.2 lc rgb BLACK"
DOT = "with points pt 7 ps 0.45 lc rgb BLUE"
BAR = "with boxxyerror fc rgb RED fs solid noborder"
unset key
set label 21 'violated' at screen 0.16,0.965 left point pt 6 ps 0.8 lw 1.2 lc rgb BLACK offset 0.8,-0.35
set label 22 'in QAS' at screen 0.40,0.965 left point pt 7 ps 0.45 lc rgb BLUE offset 0.8,-0.35
set object 21 rectangle center screen 0.61,0.965 size screen 0.025,0.009 fc rgb RED fs solid noborder
set label 23 'closed by the step' at screen 0.635,0.965 left
set format x ''
set title 'QAS: all violated pairs' offset 0,-0.7
set tmargin at screen 0.87
set bmargin at screen 0.74
set yrange [1.6:-0.6]
set label 1 'no pair violated' at 12,1 left
plot data.'/fig_6_5_all.csv' using 'at':'step' @RING, \
     '' using (column('at')):(column('quasi_active') > 0 ? column('step') : NaN) @DOT, \
     '' using (column('at')):(column('closed') > 0 ? column('step')+0.4 : NaN):(0.42):(0.07) @BAR
set title 'QAS: the one pair that overlaps most'
do for [k=21:23] { unset label k }
unset object 21
set tmargin at screen 0.66
set bmargin at screen 0.50
set yrange [2.6:-0.6]
set label 1 'no pair violated' at 12,2 left
plot data.'/fig_6_5_one.csv' using 'at':'step' @RING, \
     '' using (column('at')):(column('quasi_active') > 0 ? column('step') : NaN) @DOT, \
     '' using (column('at')):(column('closed') > 0 ? column('step')+0.4 : NaN):(0.42):(0.07) @BAR
set title 'weights inside the first step above'
unset label 1
set tmargin at screen 0.42
set bmargin at screen 0.105
set yrange [8.7:-0.7]
set ytics 2 format '%g'
set format x '%g'
set xlabel 'position {/:Italic x} [cm]' offset 0,0.5
set ylabel 'inner step' offset 1,0
set key at 12,1 left top
plot data.'/fig_6_5_inner.csv' using 'at':'step' with points pt 5 ps 0.7 lc rgb BLUE title 'carries weight', \
     '' using (column('at')):(column('joins') > 0 ? column('step') : NaN) with points pt 4 ps 1.1 lw 1.2 lc rgb BLACK title 'joins in this step'
unset multiplot
