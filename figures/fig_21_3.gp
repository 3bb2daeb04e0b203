# Figure 21.3 - three orders of one matrix: every column of L above its place in the beam, joined to its parent.
# In: fig_21_3.csv   Out: fig_21_3.svg
width = 860; height = 420
load 'style.gp'
set multiplot layout 1,3
set xrange [-2:52]
set border 1
set grid noxtics
set xlabel 'place [cm]'
set xtics 0,25,50
set tmargin at screen 0.84
set bmargin at screen 0.25
set ytics scale 0
unset key
file = data.'/fig_21_3.csv'
do for [k=0:2] {
  set title word('contact_last minimum_degree separators', k+1)
  if (k == 0) { set ylabel 'columns below the root' offset 1,0; set title 'contact last' } else { unset ylabel; set format y '' }
  set lmargin at screen 0.12 + 0.305*k
  set rmargin at screen 0.36 + 0.305*k
  if (k == 1) { set title 'minimum degree' }
  set yrange [320:-14]
  plot file every :::k::k using 'x':'depth':(column('parent_x')-column('x')):(column('parent_depth')-column('depth')) with vectors nohead lc rgb SKY lw 0.7 dt 1, \
       '' every :::k::k using 'x':'depth' with points pt 7 ps 0.25 lc rgb BLUE
}
unset multiplot
