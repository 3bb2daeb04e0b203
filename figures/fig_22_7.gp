# Figure 22.7 - the die at full depth, half way and at the end of its way through a soft slab.
# In: fig_22_7_die_*.csv, fig_22_7_slab_*.csv, fig_22_7_arrows_*.csv   Out: fig_22_7.svg
width = 640; height = 740
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [-0.1:8.2]
set yrange [-0.05:3]
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
MPA = 2  # length of an arrow for a pressure of 1, the modulus of the slab
set multiplot
do for [k = 0:2] {
  set origin 0,0.67 - 0.333*k
  set size 1,0.33
  slab = sprintf('%s/fig_22_7_slab_%d.csv', data, k)
  die = sprintf('%s/fig_22_7_die_%d.csv', data, k)
  arrows = sprintf('%s/fig_22_7_arrows_%d.csv', data, k)
  eval 'plot '.body(slab, 1).', '.body(die, 1).', '.pressing(arrows, MPA, 1)
}
unset multiplot
