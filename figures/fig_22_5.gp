# Figure 22.5 - the die at the begin of its way, half way and at the end, and what the slab presses on it with.
# In: fig_22_5_die_*.csv, fig_22_5_slab_*.csv, fig_22_5_arrows_*.csv   Out: fig_22_5.svg
width = 640; height = 690
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [-0.05:4.05]
set yrange [-1.05:0.6]
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
MPA = 0.0035  # length of an arrow [mm] for 1 MPa
set multiplot
do for [k = 0:2] {
  set origin 0,0.67 - 0.333*k
  set size 1,0.33
  slab = sprintf('%s/fig_22_5_slab_%d.csv', data, k)
  die = sprintf('%s/fig_22_5_die_%d.csv', data, k)
  arrows = sprintf('%s/fig_22_5_arrows_%d.csv', data, k)
  eval 'plot '.body(slab, 1).', '.body(die, 1).', '.pressing(arrows, MPA, 1)
}
unset multiplot
