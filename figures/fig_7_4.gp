# Figure 7.4 - the printed method on the pin, step by step.   In: fig_7_4_*.csv   Out: fig_7_4.svg
width = 480; height = 640
load 'style.gp'
set multiplot
set xrange [0:98]
set xtics 30
unset grid
RING = "with points pt 6 ps 0.8 lw 1.2 lc rgb BLACK"
DOT = "with points pt 7 ps 0.45 lc rgb BLUE"
BAR = "with boxxyerror fc rgb RED fs solid noborder"
unset key
set label 21 'violated' at screen 0.16,0.965 left point pt 6 ps 0.8 lw 1.2 lc rgb BLACK offset 0.8,-0.35
set label 22 'in QAS' at screen 0.40,0.965 left point pt 7 ps 0.45 lc rgb BLUE offset 0.8,-0.35
set object 21 rectangle center screen 0.61,0.965 size screen 0.025,0.009 fc rgb RED fs solid noborder
set label 23 'closed by the step' at screen 0.635,0.965 left
do for [reading in 't c'] {
  left = reading eq 't'
  file = data.'/fig_7_4_'.reading
  set lmargin at screen (left ? 0.13 : 0.58)
  set rmargin at screen (left ? 0.53 : 0.98)
  set format x ''
  unset xlabel
  unset ylabel
  set ytics 1 format (left ? 'k = %g' : '')
  set label 2 (left ? '(T) the load pulls' : '(C) the load presses') at graph 0.5,1.65 center font ',15'
  set title 'QAS: all violated' offset 0,-0.7
  set tmargin at screen 0.855
  set bmargin at screen 0.76
  set yrange [1.6:-0.6]
  set label 1 'none violated' at 49,1 center
  plot file.'_all.csv' using 'at':'step' @RING, \
       '' using (column('at')):(column('quasi_active') > 0 ? column('step') : NaN) @DOT, \
       '' using (column('at')):(column('closed') > 0 ? column('step')+0.4 : NaN):(2.6):(0.08) @BAR
  do for [k=21:23] { unset label k }
  unset object 21
  unset label 2
  set title 'QAS: the largest overlap'
  set tmargin at screen 0.70
  set bmargin at screen 0.46
  set yrange [5.6:-0.6]
  set label 1 'none violated' at 49,5 center
  plot file.'_one.csv' using 'at':'step' @RING, \
       '' using (column('at')):(column('quasi_active') > 0 ? column('step') : NaN) @DOT, \
       '' using (column('at')):(column('closed') > 0 ? column('step')+0.42 : NaN):(2.6):(0.08) @BAR
  unset label 1
  set title 'weights inside'
  set tmargin at screen 0.40
  set bmargin at screen 0.09
  set yrange [10.2:-0.7]
  set ytics 2 format (left ? '%g' : '')
  set format x '%g'
  set xlabel 'angle {/:Italic θ} [deg]' offset 0,0.5
  if (left) { set ylabel 'inner step' offset 1,0 }
  if (!left) {
    set label 24 'carries weight' at 6,8.3 left point pt 5 ps 0.7 lc rgb BLUE offset 0.8,-0.35
    set label 25 'joins in this step' at 6,9.5 left point pt 4 ps 1.1 lw 1.2 lc rgb BLACK offset 0.8,-0.35
  }
  plot file.'_inner.csv' using 'at':'step' with points pt 5 ps 0.7 lc rgb BLUE, \
       '' using (column('at')):(column('joins') > 0 ? column('step') : NaN) with points pt 4 ps 1.1 lw 1.2 lc rgb BLACK
}
unset multiplot
