# Figure 14.3 - displacements and horizontal stress on the deformed rings; gap and displacements 20 times.
# In: fig_14_3_RING.csv before loading, fig_14_3_FIELD_RING.csv   Out: fig_14_3.svg
width = 640; height = 610
load 'style.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [-1:81]
set yrange [-1:81]
set style line 21 lc rgb '#a8a8a8' lw 0.6 dt 1  # before loading
set style line 22 lc rgb '#7b7b78' lw 0.6 dt 1  # below the seams of the bands
field(name) = data.'/fig_14_3_'.name.'.csv'
set multiplot
do for [k=0:3] {
  name = word("u ux uy sxx", k + 1)
  left = 0.5*(k % 2); top = k < 2 ? 0.93 : 0.43
  set lmargin at screen left + 0.005; set rmargin at screen left + 0.385
  set tmargin at screen top; set bmargin at screen top - 0.41
  set title word("|u| u_x u_y σ_x", k + 1).(k < 3 ? ' [cm]' : ' [MPa]')
  set palette maxcolors (k < 3 ? 10 : 13)
  if (k == 0) { set cbrange [0.1:0.3]; set cbtics 0.1, 0.04 }
  if (k > 0 && k < 3) { set cbrange [0:0.3]; set cbtics 0.06 }
  if (k == 3) { set cbrange [-200:1100]; set cbtics 200 }
  set colorbox user origin left + 0.39, top - 0.38 size 0.022, 0.35
  low = word("0.1 0 0 -200", k + 1) + 0; step = word("0.02 0.03 0.03 100", k + 1) + 0; n = k < 3 ? 10 : 13
  middle(band) = low + (band < 1 ? 0.5 : band > n ? n - 0.5 : band - 0.5)*step
  plot field(name.'_lining') using 'x':'y' with lines ls 22, \
       field(name.'_rock') using 'x':'y' with lines ls 22, \
       field(name.'_lining') using 'x':'y':(middle(column('band'))) with polygons fs solid noborder fc palette, \
       field(name.'_rock') using 'x':'y':(middle(column('band'))) with polygons fs solid noborder fc palette, \
       field('lining') using 'x':'y' with lines ls 21, field('rock') using 'x':'y' with lines ls 21
}
unset multiplot
